#include "pipeline/reports/thumbnail.h"

#include <optional>

#include "pipeline/photos/reduced.h"
#include "scene/damaged_package.h"
#include "scene/middle_photo.h"
#include "scene/stored_tile.h"

namespace vantage {
namespace {

/// The photo with pixels next to the first one shown; a photo that was held out or left out has none.
std::optional<std::uint32_t> shown_photo(std::span<const package::PhotoRecord> photos) {
    if (photos.empty()) return {};
    const std::uint32_t middle = middle_photo(photos, 0);
    for (std::uint32_t away = 0; away < photos.size(); ++away)
        for (const std::uint32_t i : {middle + away, middle - away})  // below 0: too large
            if (i < photos.size() && photos[i].band == photos[middle].band && photos[i].levels) return i;
    return {};
}

}  // namespace

RgbaImage thumbnail(const PackageReader& package, int longest) {
    const auto photo = shown_photo(package.photos());
    if (!photo) throw Error(Exit::input, package.path().string() + ": has no photo for a thumbnail");
    const package::PhotoRecord& p = package.photos()[*photo];
    RgbaImage image = blank_image(int(p.thumbnail_width), int(p.thumbnail_height));
    if (image.rgba.empty() || !read_thumbnail(package, *photo, std::as_writable_bytes(std::span(image.rgba))))
        throw DamagedPackage(Defect::chunk_checksum,
                             package.path().string() + ": the thumbnail of " + p.name + " is damaged");
    return reduced(image, thumbnail_size(image.width, image.height, longest));
}

}  // namespace vantage
