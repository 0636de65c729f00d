#include "player/measure/whole_frame.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/values/srgb.h"

namespace vantage {
namespace {

/// Blends `over` in front of `under` in linear light. The result is opaque.
void complete(std::uint8_t* over, const std::uint8_t* under) {
    const double alpha = over[3] / 255.0;
    for (std::size_t c = 0; over[3] < 255 && c < 3; ++c) {
        if (over[3] == 0) {
            over[c] = under[c];
            continue;
        }
        const double light =
            alpha * linear_of_srgb_byte()[over[c]] + (1 - alpha) * linear_of_srgb_byte()[under[c]];
        over[c] = std::uint8_t(std::lround(255 * srgb_from_linear(light)));
    }
    over[3] = 255;
}

}  // namespace

Picture as_in_window(Renderer& renderer, const View& view, RenderSettings settings, const Picture& rendered,
                     int side) {
    settings.fill_holes = true;
    Picture out = rendered;
    const Picture without_photos = take_picture(renderer, view, settings, {}, side);
    for (std::size_t i = 0; i < out.rgba.size(); i += 4) complete(&out.rgba[i], &without_photos.rgba[i]);
    return out;
}

Plane squared_errors(const Picture& photo, const Picture& shown, const std::vector<bool>& taken,
                     const std::vector<bool>& colored, const std::array<double, 3>& gain) {
    Plane out(photo.width, photo.height);
    for (std::size_t i = 0; i < taken.size(); ++i)
        for (std::size_t c = 0; taken[i] && c < 3; ++c) {
            const double off = photo.rgba[4 * i + c] - (colored[i] ? gain[c] : 1) * shown.rgba[4 * i + c];
            out.values[i] += float(off * off);
        }
    return out;
}

FrameScore score_frame(const Picture& photo, const Picture& shown, const std::vector<bool>& taken,
                       const std::vector<bool>& colored, const std::array<double, 3>& gain,
                       const Plane& errors) {
    FrameScore s;
    s.pixels = std::size_t(std::ranges::count(taken, true));
    if (s.pixels == 0) return s;
    s.psnr = psnr_after({1, 1, 1}, photo, shown, taken);
    s.psnr_gain = psnr_of(std::accumulate(errors.values.begin(), errors.values.end(), 0.0), s.pixels);
    s.ssim = mean_ssim(photo, shown, taken);
    s.ssim_gain = mean_ssim(photo, gained(shown, gain, colored), taken);
    return s;
}

}  // namespace vantage
