#include "player/headset/headset_menu.h"

#include <imgui.h>

#include <array>
#include <iterator>

#include "base/text/formatted.h"
#include "base/text/translation.h"
#include "player/interface/sections/blending_section.h"
#include "player/interface/sections/choice.h"
#include "player/interface/sections/columns.h"
#include "player/interface/sections/cut_section.h"
#include "player/interface/sections/field_section.h"
#include "player/interface/sections/image_set_section.h"
#include "player/interface/sections/object_section.h"
#include "player/interface/sections/photo_list_section.h"
#include "player/interface/sections/picture_section.h"
#include "player/interface/sections/point_section.h"
#include "player/interface/sections/status_section.h"
#include "player/interface/tour/story_panel.h"
#include "player/interface/unit_texts.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {
namespace {

constexpr float pages_width = 190;

constexpr std::array<const char*, std::size_t(MenuPage::count)> page_names{
    MARKED_IN("page", "Move"), marked("Photos"),        marked("Picture"),
    marked("Blending"),        marked("Scalar fields"), marked("Point cloud"),
    marked("Image sets"),      marked("Objects"),       marked("Cut"),
    marked("Measure"),         marked("Story"),         marked("Status")};

bool has_page(MenuPage page, const MenuContent& m) {
    const PlanScene& scene = m.scene.plan();
    switch (page) {
        case MenuPage::photos:
        case MenuPage::blending:
            return !scene.photos.empty();
        case MenuPage::fields:
            return !m.scene.renderer.resources().fields.all().empty();
        case MenuPage::points:
            return m.scene.renderer.resources().points.has_value();
        case MenuPage::image_sets:
            return scene.image_sets.size() > 1;
        case MenuPage::objects:
            return m.scene.objects.size() > 1;
        case MenuPage::cut:
        case MenuPage::measure:
            return !points_only(m.scene.package().scene());
        case MenuPage::story:
            return m.scene.active.any() || !m.scene.active.trouble.empty();
        default:
            return true;
    }
}

void page_buttons(Controls& c, const MenuContent& m) {
    for (std::size_t i = 0; i < page_names.size(); ++i) {
        if (!has_page(MenuPage(i), m)) continue;
        const bool chosen = m.page == MenuPage(i);
        if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        ImGui::PushID("page");
        const std::string name = shown_name(page_names[i]);
        if (ImGui::Button(name.c_str(), ImVec2(-1, 0))) m.page = MenuPage(i);
        c.note((std::string("Page ") + without_context(page_names[i])).c_str());
        ImGui::PopID();
        if (chosen) ImGui::PopStyleColor();
    }
}

/// Controls for the model's unit and size, with a button that restores its usual scale.
void size_controls(Controls& c, Session& s, const MenuContent& m) {
    Locomotion& w = m.locomotion;
    int unit = 0;
    for (int i = 1; i < int(std::size(unit_texts)); ++i)
        if (m.unit_meters == meters_in(Unit(i))) unit = i;
    if (c.choice("Model's unit", &unit, unit_texts, int(std::size(unit_texts))) && unit > 0) {
        m.unit_meters = meters_in(Unit(unit));
        w.usual_scale = 1 / m.unit_meters;
        w.stance = rescaled(w.stance, s.viewpoint.camera.eye, w.usual_scale);
    }
    c.explain("The unit of the input's coordinates, which the input files do not state.");
    double size = w.usual_scale / w.stance.scale;
    if (c.slider("Size", &size, 0.01, 100.0, "%.2f", ImGuiSliderFlags_Logarithmic))
        w.stance = rescaled(w.stance, s.viewpoint.camera.eye, w.usual_scale / size);
    c.explain(
        "1: true size, or at arm's length if the unit is unknown. You can also scale the model with two "
        "hands.");
    ImGui::BeginDisabled(w.stance.scale == w.usual_scale);
    if (c.button("True size")) w.stance = rescaled(w.stance, s.viewpoint.camera.eye, w.usual_scale);
    ImGui::EndDisabled();
}

void move_page(Controls& c, Session& s, const MenuContent& m, double now) {
    if (c.button("Home")) fly_home(s, now);
    ImGui::SameLine();
    if (c.button("Leave")) s.window.commands.push_back(Quit{});
    size_controls(c, s, m);
    Locomotion& w = m.locomotion;
    int degrees = int(w.snap_degrees);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr("Turn by"));
    for (const int by : {15, 30, 45, 90}) {
        ImGui::SameLine();
        c.radio(formatted("%d°##%d", by, by).c_str(), &degrees, by);
    }
    w.snap_degrees = degrees;
    c.checkbox("Fly with the stick", &w.smooth);
    c.explain(
        "The stick of the other hand flies in the direction in which that hand points. Teleporting always "
        "works.");
    c.checkbox("Dark edges while flying", &m.vignette);
    c.explain("Makes flying more comfortable for many people.");
}

/// Takes the place of a comparison with a photo, which is not available in stereo.
void only_this_photo(Controls& c, Session& s, const PlanScene& scene) {
    bool only = s.photos.size() == 1 && s.photos.front() == s.viewpoint.standing_at;
    if (c.checkbox("Only this photo", &only)) {
        use_all(s.photos, scene);
        if (only) std::erase_if(s.photos, [&](std::uint32_t p) { return p != s.viewpoint.standing_at; });
    }
    c.explain("Shows the model with only the photo at your position, for comparison with all photos.");
}

void photos_page(Controls& c, Session& s, const MenuContent& m, double now) {
    c.checkbox("Photos in the scene", &s.window.panels.frusta);
    c.explain("Shows each photo where it was taken. Select one to stand there.");
    only_this_photo(c, s, m.scene.plan());
    photo_list_section(c, s, m.scene.renderer, now);
}

void measure_page(Controls& c, Session& s, const MenuContent& m, double now) {
    if (c.button("Undo point")) m.scene.measure.remove_last_point();
    ImGui::SameLine();
    if (c.button("Finish")) m.scene.measure.end();
    m.scene.measure.content(c, s, m.scene.objects.meshes(), now);
}

void story_page(Controls& c, Session& s, const MenuContent& m, double now) {
    if (!m.scene.active.open || *m.scene.active.open >= m.scene.active.story.notes.size())
        return story_content(c, m.scene.active, s, now);
    if (c.button("All notes")) {
        m.scene.active.playing.reset();
        return m.scene.active.open.reset();
    }
    ImGui::TextUnformatted(note_label(m.scene.active, *m.scene.active.open).c_str());
    note_content(c, m.scene.active, m.scene.note_picture, s, ImVec2(ImGui::GetContentRegionAvail().x, 260),
                 now);
}

void page_content(Controls& c, Session& s, const MenuContent& m, double now) {
    const PackageReader& package = m.scene.package();
    switch (m.page) {
        case MenuPage::photos:
            return photos_page(c, s, m, now);
        case MenuPage::picture:
            return picture_content(c, s, m.scene.renderer);
        case MenuPage::blending:
            return blending_section(c, s, m.scene.renderer);
        case MenuPage::fields:
            return field_section(c, s.settings.field, m.scene.renderer,
                                 view_of(s.viewpoint.camera, 1000, 1000));
        case MenuPage::points:
            return point_section(c, s, m.scene.renderer);
        case MenuPage::image_sets:
            return image_set_section(c, s.settings, m.scene.renderer);
        case MenuPage::objects:
            object_section(c, s.window.commands, m.scene.objects, m.scene.plan().size);
            return;
        case MenuPage::cut:
            return cut_section(c, s, m.scene.plan(),
                               Eigen::Map<const Eigen::Vector3d>(package.scene().origin));
        case MenuPage::measure:
            return measure_page(c, s, m, now);
        case MenuPage::story:
            return story_page(c, s, m, now);
        case MenuPage::status:
            return status_section(c, s.drawn, m.scene.renderer, m.scene.objects.graphics_budget());
        default:
            return move_page(c, s, m, now);
    }
}

}  // namespace

void headset_menu(Controls& c, Session& s, const MenuContent& m, FrameSize size, double now) {
    if (!has_page(m.page, m)) m.page = MenuPage::move;
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ImVec2(float(size.width), float(size.height)));
    ImGui::Begin("##menu", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::BeginChild("##pages", ImVec2(pages_width, 0));
    page_buttons(c, m);
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginChild("##content", ImVec2(0, 0));
    ImGui::PushItemWidth(width_beside_names());
    c.set_width_fixed(true);
    ImGui::PushID(int(m.page));
    page_content(c, s, m, now);
    ImGui::PopID();
    c.set_width_fixed(false);
    ImGui::PopItemWidth();
    ImGui::EndChild();
    ImGui::End();
    s.window.panels.measure = m.page == MenuPage::measure;
}

}  // namespace vantage
