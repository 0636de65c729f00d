#include "player/interface/sidebar.h"

#include <imgui.h>

#include <algorithm>
#include <tuple>

#include "base/text/translation.h"
#include "player/interface/docked.h"
#include "player/interface/sections/blending_section.h"
#include "player/interface/sections/columns.h"
#include "player/interface/sections/cut_section.h"
#include "player/interface/sections/field_section.h"
#include "player/interface/sections/image_set_section.h"
#include "player/interface/sections/object_section.h"
#include "player/interface/sections/orthophoto_section.h"
#include "player/interface/sections/photo_list_section.h"
#include "player/interface/sections/picture_section.h"
#include "player/interface/sections/point_section.h"
#include "player/interface/sections/status_section.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {
namespace {

// The settings of each group, of the session or its defaults.
constexpr auto of_picture = [](auto& s) {
    auto& r = s.settings;
    return std::tie(r.background, r.light, r.transparency, r.refined_colors, r.exposure, s.stereo);
};
constexpr auto of_photos = [](auto& s) { return std::tie(s.settings.show, s.photos); };
constexpr auto of_blending = [](auto& s) {
    auto& r = s.settings;
    return std::tie(r.blend, r.weights, r.transients, r.fill_holes, r.weights_from, r.choice, r.photos,
                    r.angle_limit, r.coordinates);
};
constexpr auto of_fields = [](auto& s) { return std::tie(s.settings.field); };
constexpr auto of_points = [](auto& s) {
    auto& p = s.settings.points;
    return std::tie(p.show, p.alone, p.color, p.by, p.size, p.eye_dome, p.budget);
};
constexpr auto of_image_sets = [](auto& s) { return std::tie(s.settings.image_sets); };
constexpr auto of_surveying = [](auto& s) { return std::tie(s.cut); };
constexpr auto of_movement = [](auto& s) { return std::tie(s.movement); };
constexpr auto none = [](auto&) { return std::tuple(); };
constexpr std::tuple all_settings{of_picture, of_photos,     of_blending,  of_fields,
                                  of_points,  of_image_sets, of_surveying, of_movement};

struct Heading {
    const char* name;
    const char* key;
    bool* more;
};

/// The heading of a group, and its content.
template <class Settings, class Content>
void group(Controls& c, Session& s, const Heading& heading, const Settings& of, const Content& content) {
    if (c.heading(heading.name, heading.key, heading.more, of(s) != of(s.defaults))) of(s) = of(s.defaults);
    ImGui::PushID(heading.name);  // a control may have the name of another group
    content();
    ImGui::PopID();
    ImGui::Spacing();
}

void field_group(Controls& c, Session& s, const Renderer& renderer, const View& view) {
    const std::span<const ScalarField> fields = renderer.resources().fields.all();
    FieldSettings& field = s.settings.field;
    bool& more = s.window.panels.fields;
    // Fields that are computed from the photos exist in every package.
    const bool stored = std::ranges::any_of(fields, [](const ScalarField& f) { return !f.measure; });
    const bool chosen = field.index >= 0;
    group(c, s, {marked("Scalar fields"), "F7", chosen || !stored ? &more : nullptr}, of_fields, [&] {
        if (stored || chosen || more) field_section(c, field, renderer, view, more);
    });
}

/// The groups for what a package may contain besides a model and photos. Returns whether the picture changed
/// in a way that the session does not record.
bool groups_of_content(Controls& c, Session& s, const SidebarContent& content) {
    const auto& [renderer, objects, view] = content;
    Panels& p = s.window.panels;
    if (!renderer.resources().fields.all().empty()) field_group(c, s, renderer, view);
    if (renderer.resources().points)
        group(c, s, {marked("Point cloud"), "F8", &p.points}, of_points,
              [&] { point_section(c, s, renderer, p.points); });
    if (renderer.scene().image_sets.size() > 1)
        group(c, s, {marked("Image sets"), "F9", &p.image_sets}, of_image_sets,
              [&] { image_set_section(c, s.settings, renderer, p.image_sets); });
    bool changed = false;
    if (objects.size() > 1)
        group(c, s, {marked("Objects"), "F10", &p.objects}, none, [&] {
            changed = object_section(c, s.window.commands, objects, renderer.scene().size, p.objects);
        });
    return changed;
}

void surveying_group(Controls& c, Session& s, const Renderer& renderer) {
    const PackageReader& package = renderer.package();
    Panels& p = s.window.panels;
    group(c, s, {marked("Surveying"), "", &p.surveying}, of_surveying, [&] {
        c.checkbox("Measure", &p.measure);
        c.explain("Points, distances, areas, angles and heights on the model (M).");
        cut_section(c, s, renderer.scene(), Eigen::Map<const Eigen::Vector3d>(package.scene().origin));
        if (!p.surveying) return;
        ImGui::TextDisabled("%s", tr("Orthophoto"));
        orthophoto_section(c, s, package);
    });
}

bool groups(Controls& c, Session& s, const SidebarContent& content, double now) {
    const Renderer& renderer = content.renderer;
    Panels& p = s.window.panels;
    group(c, s, {marked("Picture"), "F12", &p.picture}, of_picture,
          [&] { picture_section(c, s, renderer, p.picture, now); });
    if (!renderer.scene().photos.empty()) {
        group(c, s, {marked("Photos"), "", &p.photo_list}, of_photos,
              [&] { photo_list_section(c, s, renderer, now, p.photo_list); });
        group(c, s, {marked("Blending"), "F2", &p.blending}, of_blending,
              [&] { blending_section(c, s, renderer, p.blending); });
    }
    const bool changed = groups_of_content(c, s, content);
    if (!points_only(renderer.package().scene())) surveying_group(c, s, renderer);
    group(c, s, {marked("Movement"), "", &p.movement}, of_movement, [&] {
        if (p.movement) movement_section(c, s.movement);
    });
    group(c, s, {marked("Status"), "F3", &p.status}, none, [&] {
        if (p.status) status_section(c, s.drawn, renderer, content.objects.graphics_budget());
    });
    return changed;
}

void reset_all_button(Controls& c, Session& s) {
    const auto differs = [&](const auto&... of) { return (... || (of(s) != of(s.defaults))); };
    if (!std::apply(differs, all_settings)) return;
    if (c.button("Reset all"))
        std::apply([&](const auto&... of) { ((of(s) = of(s.defaults)), ...); }, all_settings);
    c.explain("Back to the defaults of all groups (Ctrl+Z undoes it)");
}

}  // namespace

bool sidebar(Controls& c, Session& s, const SidebarContent& content, const Area& area, double now) {
    begin_docked("##sidebar", area, ImGui::GetStyle().WindowPadding,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse);
    ImGui::PushItemWidth(width_beside_names());
    c.set_width_fixed(true);
    const bool changed = groups(c, s, content, now);
    reset_all_button(c, s);
    c.set_width_fixed(false);
    ImGui::PopItemWidth();
    ImGui::End();
    return changed;
}

}  // namespace vantage
