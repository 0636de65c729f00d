#include "scene/package/contents/first_photo.h"

#include <limits>
#include <span>

#include "scene/package/contents/stored_tile.h"
#include "scene/package/damaged_package.h"

namespace vantage {

std::uint32_t first_photo(const PackageReader& package, std::uint32_t image_set) {
    const auto photos = package.photos();
    const std::uint64_t first = package.scene().first_photo;
    auto best = std::uint32_t(photos.size());
    double nearest = std::numeric_limits<double>::infinity();
    for (std::uint32_t p = 0; p < photos.size(); ++p) {
        if (photos[p].image_set != image_set || !photos[p].levels) continue;
        const double away =
            first >= photos.size()
                ? p
                : (cam_from_origin(photos[p]).center() - cam_from_origin(photos[first]).center()).norm();
        if (p == first) return p;
        if (away < nearest) best = p, nearest = away;
    }
    return best;
}

RgbaImage first_thumbnail(const PackageReader& package) {
    const std::uint32_t photo = first_photo(package);
    if (photo >= package.photos().size())
        throw Error(Exit::input, package.path().string() + ": has no photo with a thumbnail");
    const package::PhotoRecord& p = package.photos()[photo];
    RgbaImage image = blank_image(int(p.thumbnail_width), int(p.thumbnail_height));
    if (image.rgba.empty() || !read_thumbnail(package, photo, std::as_writable_bytes(std::span(image.rgba))))
        throw DamagedPackage(Defect::chunk_checksum,
                             package.path().string() + ": the thumbnail of " + p.name + " is damaged");
    return image;
}

}  // namespace vantage
