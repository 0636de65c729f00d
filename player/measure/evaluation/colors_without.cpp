#include "player/measure/evaluation/colors_without.h"

#include "scene/agreement/image_set_photos.h"

namespace vantage {

ColorsWithout::ColorsWithout(const PackageReader& package)
    : package_(package),
      samples_(read_samples(package.photos(),
                            [&](std::uint32_t photo) {
                                const auto bytes = std::as_bytes(
                                    package.records<package::SampleRecord>(package::Type::samples, photo));
                                return std::vector<std::byte>(bytes.begin(), bytes.end());
                            })),
      lens_(lenses_of(package.photos())),
      image_sets_(read_image_sets(package)) {}

PhotoColors ColorsWithout::colors(std::uint32_t photo) const {
    const std::uint32_t image_set = package_.photos()[photo].image_set;
    const auto samples = samples_of_image_set(samples_.spans(), package_.photos(), image_set);
    return fit_without(samples, lens_, photo,
                       image_sets_[image_set].effects & effect_bit(Effect::vignetting));
}

std::vector<package::PhotoRecord> ColorsWithout::records(const PhotoColors& colors,
                                                         std::uint32_t photo) const {
    std::vector<package::PhotoRecord> out(package_.photos().begin(), package_.photos().end());
    const EffectSet on = image_sets_[package_.photos()[photo].image_set].effects;
    const bool gains = on & effect_bit(Effect::exposure), vignetting = on & effect_bit(Effect::vignetting);
    if (gains || vignetting) apply_colors(colors, gains, vignetting, out);
    return out;
}

}  // namespace vantage
