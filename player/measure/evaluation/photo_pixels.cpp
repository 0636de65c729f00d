#include "player/measure/evaluation/photo_pixels.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/values/halve.h"
#include "base/values/tiling.h"
#include "scene/agreement/read_level.h"

namespace vantage {

namespace {

void expect_level(const PackageReader& package, package::Type type, std::uint32_t photo, int level) {
    if (!package.photos()[photo].levels || !package.find(type, photo, std::uint32_t(level)))
        throw std::invalid_argument("the photo has no such level");
}

Picture picture_of(RgbaImage image) { return {image.width, image.height, std::move(image.rgba), {}}; }

}  // namespace

Picture photo_at_level(const PackageReader& package, std::uint32_t photo, int level) {
    expect_level(package, package::Type::tiles, photo, level);
    RgbaImage image = read_pinhole_level(package, package.photos()[photo], photo, 0);
    for (int l = 0; l < level; ++l) image = halve(image);
    return picture_of(std::move(image));
}

Picture weight_maps_at_level(const PackageReader& package, std::uint32_t photo, int level) {
    expect_level(package, package::Type::weight_maps, photo, level);
    return picture_of(
        read_level_image(package, package.photos()[photo], photo, package::Type::weight_maps, level));
}

View view_of_level(const package::PhotoRecord& photo, int level) {
    return {intrinsics(photo).at_level(level), cam_from_origin(photo), exposure_of(photo)};
}

}  // namespace vantage
