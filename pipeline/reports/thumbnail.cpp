#include "pipeline/reports/thumbnail.h"

#include "pipeline/photos/reduced.h"
#include "scene/package/contents/first_photo.h"

namespace vantage {
RgbaImage thumbnail(const PackageReader& package, int longest) {
    const RgbaImage image = first_thumbnail(package);
    return reduced(image, thumbnail_size(image.width, image.height, longest));
}

}  // namespace vantage
