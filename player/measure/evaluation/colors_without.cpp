#include "player/measure/evaluation/colors_without.h"

#include "scene/agreement/band_photos.h"

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
      bands_(read_bands(package)) {}

PhotoColors ColorsWithout::colors(std::uint32_t photo) const {
    const std::uint32_t band = package_.photos()[photo].band;
    const auto samples = samples_of_band(samples_.spans(), package_.photos(), band);
    return fit_without(samples, lens_, photo, bands_[band].effects & effect_bit(Effect::falloff));
}

std::vector<package::PhotoRecord> ColorsWithout::records(const PhotoColors& colors,
                                                         std::uint32_t photo) const {
    std::vector<package::PhotoRecord> out(package_.photos().begin(), package_.photos().end());
    const EffectSet on = bands_[package_.photos()[photo].band].effects;
    const bool gains = on & effect_bit(Effect::exposure), falloff = on & effect_bit(Effect::falloff);
    if (gains || falloff) apply_colors(colors, gains, falloff, out);
    return out;
}

}  // namespace vantage
