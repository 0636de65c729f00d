#include "player/interface/sections/status_section.h"

#include <imgui.h>

#include <algorithm>
#include <string>

#include "base/text/localized.h"
#include "base/text/translation.h"
#include "player/interface/state/failure_text.h"

namespace vantage {
namespace {

constexpr float MiB = 1024 * 1024;

void line(const std::string& text) { ImGui::TextUnformatted(text.c_str()); }

/// Displays the time under the pointer, since ImGui would format it with a decimal point.
void frame_curve(const DrawnFrames& frames) {
    const float highest = *std::ranges::max_element(frames.ms);
    ImGui::PushStyleVar(ImGuiStyleVar_DisabledAlpha, 1);
    ImGui::BeginDisabled();
    ImGui::PlotLines("##frames", frames.ms.data(), int(frames.ms.size()), 0, "", 0,
                     std::max(1.0f, highest * 1.1f), ImVec2(-1, 4 * ImGui::GetFontSize()));
    ImGui::EndDisabled();
    ImGui::PopStyleVar();
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    const float low = ImGui::GetItemRectMin().x, wide = ImGui::GetItemRectSize().x,
                share = std::clamp((ImGui::GetIO().MousePos.x - low) / wide, 0.0f, 1.0f);
    const auto at = std::min(std::size_t(share * float(frames.ms.size())), frames.ms.size() - 1);
    ImGui::SetTooltip("%s", localized("%.1f ms", double(frames.ms[at])).c_str());
}

/// A bar that shows how much of a budget is used, recorded under its English name.
void budget_bar(Controls& c, const char* name, double held, double budget) {
    const std::string text = localized(tr("%.0f of %.0f MiB"), held / double(MiB), budget / double(MiB));
    ImGui::ProgressBar(float(budget > 0 ? held / budget : 0), ImVec2(-4 * ImGui::GetFontSize(), 0),
                       text.c_str());
    c.note(name);
    ImGui::SameLine();
    ImGui::TextUnformatted(tr(name));
}

/// For a remote package.
void transfer_lines(const Renderer& renderer) {
    const auto traffic = renderer.package().traffic();
    if (!traffic) return;
    line(localized(tr("network %.0f kB/s, %.1f MB; cache %.1f MB"), traffic->bytes_per_second / 1e3,
                   double(traffic->bytes_received) / 1e6, double(traffic->bytes_from_cache) / 1e6));
    if (const std::string failure = renderer.resources().failure(); !failure.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1, 0.5f, 0.4f, 1));
        ImGui::TextWrapped("%s", failure_text(tr("Parts of the scene cannot be loaded."), failure).c_str());
        ImGui::PopStyleColor();
    } else if (traffic->offline) {
        ImGui::TextUnformatted(tr("the server cannot be reached: shown from the cache"));
    }
}

}  // namespace

void status_section(Controls& c, const DrawnFrames& frames, const Renderer& renderer,
                    std::uint64_t graphics_budget) {
    frame_curve(frames);
    const FrameStatistics& f = frames.statistics;
    line(localized(tr("%.1f ms per frame, median %.1f"), f.mean, f.median));
    line(localized(tr("99 %% below %.1f, 99.9 %% below %.1f"), f.p99, f.p999));
    if (frames.pace.scale < 1)
        line(localized(tr("in motion: %.0f %% of the resolution%s"), 100 * frames.pace.scale,
                       frames.pace.reduced ? tr(", fewer photos") : ""));
    const FrameReport& r = frames.report;
    ImGui::Text(tr("%zu photos in %zu passes, %zu draws"), r.photos, r.passes, r.draws);
    line(localized(tr("%zu tiles, %zu pending; %.1f MiB uploaded"), r.tiles, r.tiles_to_come,
                   double(r.uploaded) / double(MiB)));
    if (renderer.scene().has_transparency())
        ImGui::Text(tr("%zu transparent fragments, %zu approximated"), r.fragments, r.fragments_approximated);
    const Residency& held = renderer.resources().store.residency();
    line(localized(tr("graphics memory: %.0f of %.0f MiB"), double(gl::memory_held()) / double(MiB),
                   double(graphics_budget) / double(MiB)));
    budget_bar(c, marked("tiles"), double(held.color_held() + 2 * held.weight_maps_held()) * 256 * 1024,
               double(held.layout().bytes()));
    transfer_lines(renderer);
    if (r.tiles_damaged)
        ImGui::TextColored(ImVec4(1, 0.5f, 0.4f, 1), tr("%zu damaged tiles not shown"), r.tiles_damaged);
}

}  // namespace vantage
