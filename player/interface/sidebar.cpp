#include "player/interface/sidebar.h"

#include <imgui.h>

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

/// A header, and its content if open.
template <class Content>
void section(Controls& c, const char* name, bool& open, const Content& content) {
    c.section(name, &open);
    if (!open) return;
    ImGui::PushID(name);  // a control may have the name of another section
    content();
    ImGui::PopID();
    ImGui::Spacing();
}

bool sections(Controls& c, Session& s, const SidebarContent& content, double now) {
    const auto& [renderer, objects, view] = content;
    bool changed = false;
    Panels& p = s.window.panels;
    section(c, "Picture", p.picture, [&] { picture_section(c, s, renderer); });
    if (!renderer.scene().photos.empty())
        section(c, "Photos", p.photo_list, [&] { photo_list_section(c, s, renderer, now); });
    const PackageReader& package = renderer.package();
    if (!points_only(package.scene())) {
        section(c, "Cut", p.cut, [&] {
            cut_section(c, s, renderer.scene(), Eigen::Map<const Eigen::Vector3d>(package.scene().origin));
        });
        section(c, "Orthophoto", p.orthophoto, [&] { orthophoto_section(c, s, package); });
    }
    if (!renderer.resources().fields.all().empty())
        section(c, "Scalar fields", fields_open(s),
                [&] { field_section(c, s.settings.field, renderer, view); });
    if (renderer.resources().points)
        section(c, "Point cloud", p.points, [&] { point_section(c, s, renderer); });
    if (renderer.scene().image_sets.size() > 1)
        section(c, "Image sets", p.image_sets, [&] { image_set_section(c, s.settings, renderer); });
    section(c, "Objects", p.objects,
            [&] { changed = object_section(c, s.window.commands, objects, renderer.scene().size); });
    if (!renderer.scene().photos.empty())
        section(c, "Blending", p.blending, [&] { blending_section(c, s, renderer); });
    section(c, "Status", p.status, [&] { status_section(c, s.drawn, renderer, objects.graphics_budget()); });
    return changed;
}

}  // namespace

bool sidebar(Controls& c, Session& s, const SidebarContent& content, const Area& area, double now) {
    begin_docked("##sidebar", area, ImGui::GetStyle().WindowPadding,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse);
    ImGui::PushItemWidth(width_beside_names());
    c.set_width_fixed(true);
    const bool changed = sections(c, s, content, now);
    c.set_width_fixed(false);
    ImGui::PopItemWidth();
    ImGui::End();
    return changed;
}

}  // namespace vantage
