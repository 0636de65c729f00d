#include "player/evaluate/colors_without.h"

namespace vantage {

ColorsWithout::ColorsWithout(const PackageReader& package)
    : package_(package),
      samples_(read_samples(package.photos(),
                            [&](std::uint32_t photo) {
                                const auto bytes = std::as_bytes(
                                    package.records<package::SampleRecord>(package::Type::samples, photo));
                                return std::vector<std::byte>(bytes.begin(), bytes.end());
                            })),
      lens_(lenses_of(package.photos())) {}

PhotoColors ColorsWithout::colors(std::uint32_t photo) const {
    return fit_without(samples_.spans(), lens_, photo, effect_on(package_.scene(), Effect::falloff));
}

std::vector<package::PhotoRecord> ColorsWithout::records(const PhotoColors& colors) const {
    std::vector<package::PhotoRecord> out(package_.photos().begin(), package_.photos().end());
    const bool gains = effect_on(package_.scene(), Effect::exposure),
               falloff = effect_on(package_.scene(), Effect::falloff);
    if (gains || falloff) apply_colors(colors, gains, falloff, out);
    return out;
}

}  // namespace vantage
