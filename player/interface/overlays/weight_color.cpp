#include "player/interface/overlays/weight_color.h"

namespace vantage {

ImU32 weight_color(double distance, double angle, float alpha) {
    return ImGui::ColorConvertFloat4ToU32(
        ImVec4(float(0.15 + 0.85 * angle), float(0.15 + 0.85 * distance), 0.2f, alpha));
}

}  // namespace vantage
