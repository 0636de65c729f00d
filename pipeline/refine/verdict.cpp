#include "pipeline/refine/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

constexpr double max_loss = 0.75;    ///< largest permitted loss of any photo, dB
constexpr double negligible = 0.01;  ///< mean gains up to this are negligible, dB
constexpr double fewer_seams = 0.9;  ///< maximum ratio of the seams with the effect to those without

}  // namespace

Judgment summarize(std::span<const ValidatedPhoto> photos) {
    Judgment j;
    double squares = 0, losses = 0;
    for (const ValidatedPhoto& p : photos) {
        if (p.without.pixels < fewest_pixels) continue;
        const double gain = p.with.psnr - p.without.psnr;
        if (j.photos == 0 || gain < j.worst) j.worst = gain, j.worst_photo = p.name;
        ++j.photos;
        j.worse += gain < 0;
        j.gain += gain;
        squares += gain * gain;
        losses += std::pow(std::min(gain, 0.0), 2);
        j.ssim += p.with.ssim - p.without.ssim;
        j.seams_before += p.without.seams;
        j.seams_after += p.with.seams;
    }
    if (j.photos == 0) return j;
    const double n = j.photos;
    for (double* mean : {&j.gain, &j.ssim, &j.seams_before, &j.seams_after}) *mean /= n;
    j.error = n > 1 ? std::sqrt(std::max(squares / n - j.gain * j.gain, 0.0) / (n - 1)) : 0;
    j.noise = std::sqrt(2 * losses) / n;
    return j;
}

bool is_called_for(const Judgment& j) {
    if (j.photos < min_validated_photos || j.worst < -max_loss) return false;
    if (j.gain > 2 * std::min(j.error, j.noise) && j.gain > negligible) return true;
    return j.gain > -std::max(j.error, negligible) && j.seams_after <= fewer_seams * j.seams_before;
}

void confirm(EffectDecision& decision, const Judgment& judgment) {
    decision.judgment = judgment;
    decision.evidence += "; " + sentence(judgment);
    if (!decision.forced && judgment.photos >= min_validated_photos) decision.on = is_called_for(judgment);
}

std::string sentence(const Judgment& j) {
    if (j.photos < min_validated_photos) return "too few photos to hold one out";
    std::string out = fmt::format("held-out photos {} {:.2f} dB (standard error {:.2f}; {} of {} worse)",
                                  j.gain < 0 ? "lose" : "gain", std::abs(j.gain), j.error, j.worse, j.photos);
    if (j.worst < -max_loss) out += fmt::format(", {} loses {:.2f} dB", j.worst_photo, -j.worst);
    if (j.seams_before > 0)
        out += fmt::format(", seams {} by {:.0f} %", j.seams_after < j.seams_before ? "fall" : "grow",
                           100 * std::abs(1 - j.seams_after / j.seams_before));
    return out;
}

}  // namespace vantage
