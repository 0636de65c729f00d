#include "player/interface/sections/photo_list_section.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/text/localized.h"
#include "base/text/lower_case.h"
#include "base/text/translation.h"
#include "player/interface/sections/choice.h"
#include "player/interface/sections/columns.h"
#include "player/interface/sections/image_set_section.h"
#include "player/survey/ray_cast.h"

namespace vantage {
namespace {

std::optional<double> error_of(const PhotoList& list, std::uint32_t photo) {
    const auto& errors = list.errors;
    return photo < errors.size() ? errors[photo] : std::nullopt;
}

/// Photos that match the filter and the point, in display order.
std::vector<std::uint32_t> listed(const Session& s, const PlanScene& scene) {
    std::vector<std::uint32_t> out;
    const std::string filter = lower_case(s.photo_list.filter.data());
    const auto passes = [&](std::uint32_t p) {
        return is_shown(s.settings.image_sets, scene.photos[p]) &&
               lower_case(scene.photos[p].name).find(filter) != std::string::npos;
    };
    if (s.photo_list.by_point && s.photo_list.point) {
        for (const Footprint& f : s.photo_list.showing)
            if (passes(f.photo)) out.push_back(f.photo);
        return out;
    }
    for (std::uint32_t p = 0; p < scene.photos.size(); ++p)
        if (passes(p)) out.push_back(p);
    const auto error = [&](std::uint32_t p) { return error_of(s.photo_list, p).value_or(-1); };
    if (s.photo_list.worst_first) std::ranges::stable_sort(out, std::ranges::greater(), error);
    return out;
}

void use(std::vector<std::uint32_t>& photos, std::uint32_t photo, bool used) {
    std::erase(photos, photo);
    if (used) photos.insert(std::ranges::upper_bound(photos, photo), photo);
}

/// Details of a photo, at the clicked point or in general.
std::string remark(const PhotoList& list, const package::PhotoRecord& photo, std::uint32_t number) {
    const auto at = std::ranges::find(list.showing, number, &Footprint::photo);
    if (!photo.levels) return tr("skipped");
    if (list.by_point && list.point && at != list.showing.end())
        return localized(tr("pixels of %.3g"), at->size);
    const auto error = error_of(list, number);
    return localized(tr("%.0f %%, %+.1f stops"), 100 * photo.visible_vertices,
                     -std::log2(std::max(photo.gain[1], 1e-9))) +
           (error ? localized(tr(", %.1f px"), *error) : "");
}

void row(Controls& c, Session& s, const PlanScene& scene, std::uint32_t photo, double now) {
    const package::PhotoRecord& p = scene.photos[photo];
    const std::string name = p.name;
    bool used = std::ranges::binary_search(s.photos, photo);
    ImGui::BeginDisabled(!p.levels);
    if (c.checkbox(("##Use " + name).c_str(), &used)) use(s.photos, photo, used);
    c.explain("Use this photo.");
    ImGui::SameLine();
    if (c.button((name + "##Fly to " + name).c_str())) fly_to(s, photo, p, now);
    ImGui::EndDisabled();
    ImGui::SameLine();
    const std::string text = remark(s.photo_list, p, photo);
    ImGui::TextDisabled("%s", text.c_str());
    const char* const help = marked(
        "The share of the mesh that the photo sees, its exposure relative to the other photos, and the "
        "offset of its content from theirs, in pixels. With Photos at point: the size of a pixel at that "
        "point.");
    c.explain((text + '\n' + tr(help)).c_str());  // the list may be too narrow for the text
}

void point_line(const PhotoList& list) {
    if (!list.by_point) return;
    if (!list.point)
        ImGui::TextUnformatted(tr("Click on the model."));
    else
        ImGui::Text(tr_count("%zu photo shows the point", "%zu photos show the point", list.showing.size()),
                    list.showing.size());
}

void list_controls(Controls& c, const WindowState& window, PhotoList& list) {
    if (window.keyboard) {
        c.text("Name contains", list.filter);
        c.explain("Lists only photos whose names contain this text.");
    }
    check_boxes(c, {{marked("Photos at point"), &list.by_point,
                     marked("Lists the photos that show the point you click on the model, those with the "
                            "finest pixels first."),
                     window.keyboard},
                    {marked("Worst first"), &list.worst_first,
                     marked("Sorts by the offset of a photo's content from that of the other photos, largest "
                            "first. Offsets are measured with the input's cameras, before any refinement."),
                     std::ranges::any_of(list.errors, &std::optional<double>::has_value)}});
    if (!list.by_point) list.point.reset();
    point_line(list);
}

}  // namespace

void use_all(std::vector<std::uint32_t>& photos, const PlanScene& scene) {
    photos.clear();
    for (std::uint32_t p = 0; p < scene.photos.size(); ++p)
        if (scene.photos[p].levels) photos.push_back(p);
}

void photo_list_section(Controls& c, Session& s, const Renderer& renderer, double now, bool more) {
    const PlanScene& scene = renderer.scene();
    static const char* const shows[] = {marked("photos"), marked("which photo"), marked("how many photos")};
    choice(c, "Show", s.settings.show, shows);
    c.explain(
        "The photos, or false colors: the photo with the largest weight, or the number of blended photos "
        "that see each point.");
    if (!more) return;
    list_controls(c, s.window, s.photo_list);
    const std::vector<std::uint32_t> photos = listed(s, scene);
    if (c.button("Use only these")) {
        s.photos = photos;
        std::erase_if(s.photos, [&](std::uint32_t p) { return !scene.photos[p].levels; });
        std::ranges::sort(s.photos);
    }
    c.explain("Excludes the photos that the list does not show.");
    in_second_column("Use all");
    if (c.button("Use all")) use_all(s.photos, scene);
    c.explain("Excludes no photo.");
    ImGui::BeginChild("##photos", ImVec2(0, 12 * ImGui::GetFontSize()), true);
    ImGuiListClipper clipper;
    clipper.Begin(int(photos.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            row(c, s, scene, photos[std::size_t(i)], now);
    ImGui::EndChild();
}

void pick_listed_point(Session& s, const PlanScene& scene, const View& view) {
    PhotoList& list = s.photo_list;
    if (!list.by_point || !s.window.panels.expert || !s.window.panels.photo_list) return;
    if (!s.window.panels.measure && !ImGui::GetIO().WantCaptureMouse)
        for (const Click& click : s.window.input.clicks)
            if (const auto hit = first_hit(scene, ray_through(view, {click.x, click.y}))) {
                list.point = hit->position;
                list.showing = footprints(scene, hit->triangle, hit->position);
            }
    const auto at = list.point ? project(view.intrinsics, view.cam_from_origin, *list.point) : std::nullopt;
    if (!at) return;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const ImVec2 middle(float(at->pixel.x()), float(at->pixel.y()));
    draw.AddCircle(middle, 7, IM_COL32_BLACK, 0, 4);
    draw.AddCircle(middle, 7, IM_COL32_WHITE, 0, 2);
}

bool shows_listed_point(const PhotoList& list, std::uint32_t photo) {
    return list.point && std::ranges::count(list.showing, photo, &Footprint::photo) > 0;
}

}  // namespace vantage
