#include "pipeline/presentation/presentation.h"

#include "pipeline/presentation/up_direction.h"
#include "scene/package/package_reader.h"

namespace vantage {

Presentation presentation_of(std::span<const package::PhotoRecord> photos, Samples samples,
                             std::span<const SurfaceDisc> discs) {
    std::vector<Pose> all, with_pixels;
    std::vector<std::span<const package::SampleRecord>> shown;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        all.push_back(cam_from_origin(photos[i]));
        if (!photos[i].levels) continue;
        with_pixels.push_back(all.back());
        shown.push_back(samples[i]);
    }
    Presentation out;
    out.up = up_direction(with_pixels.empty() ? all : with_pixels, discs);
    out.kind = kind_of_scan(with_pixels, shown, discs, out.up);
    out.first = first_view(photos, samples, discs, out.up, out.kind);
    return out;
}

}  // namespace vantage
