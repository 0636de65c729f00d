#include "player/interface/overlays/agreeing_photo.h"

#include <vector>

#include "player/interface/sections/image_set_section.h"
#include "player/plan/plan.h"

namespace vantage {

std::optional<std::uint32_t> agreeing_photo(const PlanScene& scene, const View& view,
                                            const ImageSetSettings& image_sets) {
    const std::vector<double> agreement = agreements(scene, view);
    std::optional<std::uint32_t> best;
    for (std::uint32_t i = 0; i < scene.photos.size(); ++i)
        if (scene.photos[i].levels && is_shown(image_sets, scene.photos[i]) &&
            (!best || agreement[i] > agreement[*best]))
            best = i;
    return best;
}

}  // namespace vantage
