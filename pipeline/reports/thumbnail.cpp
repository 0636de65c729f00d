#include "pipeline/reports/thumbnail.h"

#include "pipeline/photos/reduced.h"
#include "scene/package/contents/first_photo.h"
#include "scene/package/contents/stored_tile.h"
#include "scene/package/damaged_package.h"

namespace vantage {
RgbaImage thumbnail(const PackageReader& package, int longest) {
    const std::uint32_t photo = first_photo(package);
    if (photo >= package.photos().size())
        throw Error(Exit::input, package.path().string() + ": has no photo with a thumbnail");
    const package::PhotoRecord& p = package.photos()[photo];
    RgbaImage image = blank_image(int(p.thumbnail_width), int(p.thumbnail_height));
    if (image.rgba.empty() || !read_thumbnail(package, photo, std::as_writable_bytes(std::span(image.rgba))))
        throw DamagedPackage(Defect::chunk_checksum,
                             package.path().string() + ": the thumbnail of " + p.name + " is damaged");
    return reduced(image, thumbnail_size(image.width, image.height, longest));
}

}  // namespace vantage
