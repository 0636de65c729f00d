#include "pipeline/formats/camera_axes.h"
#include "pipeline/formats/cameras/realitycapture/realitycapture.h"

namespace vantage {
namespace {

struct RealityCaptureModel {
    const char* name;
    int radial;  ///< number of radial coefficients, k1 to k4
    bool tangential;
};
constexpr RealityCaptureModel lens_rows[] = {
    {"none", 0, false},    {"perspective", 0, false}, {"division", 1, false}, {"brown3", 3, false},
    {"brown3t2", 3, true}, {"brown4", 4, false},      {"brown4t2", 4, true}};

}  // namespace

std::string realitycapture_models() {
    std::string out;
    for (const RealityCaptureModel& m : lens_rows) out += (out.empty() ? "" : ", ") + std::string(m.name);
    return out;
}

std::optional<Lens> realitycapture_lens(std::string_view name, const std::array<double, 6>& c, double skew) {
    for (const RealityCaptureModel& m : lens_rows) {
        if (name != m.name) continue;
        // x / (1 + k1 r^2), r being the undistorted radius
        if (name == "division")
            return skew == 0 ? std::optional(Lens{LensModel::opencv, {0, 0, 0, 0, 0, c[0]}}) : std::nullopt;
        std::array<double, 4> k{};
        for (int i = 0; i < m.radial; ++i) k[std::size_t(i)] = c[std::size_t(i)];
        return brown_lens(k, m.tangential ? c[5] : 0, m.tangential ? c[4] : 0, skew);
    }
    return {};
}

}  // namespace vantage
