#include "player/interface/sections/measure_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <utility>

#include "base/text/error.h"
#include "base/text/localized.h"
#include "base/text/translation.h"
#include "player/interface/docked.h"
#include "player/interface/keys.h"
#include "player/interface/overlays/measure_overlay.h"
#include "player/interface/sections/columns.h"
#include "player/interface/state/failure_text.h"
#include "player/interface/unit_texts.h"
#include "player/survey/number_text.h"

namespace vantage {
namespace {

constexpr double vertex_pixels = 10;  ///< distance within which points snap to vertices

constexpr const char* measures[] = {marked("point"), marked("distance"), marked("polyline"), marked("area"),
                                    marked("angle"), marked("height"),   marked("profile")};
static_assert(std::size(measures) == std::size_t(Measure::count));
const char* instruction(Measure measure) {
    switch (measure) {
        case Measure::point:
            return marked("Click a point.");
        case Measure::polyline:
            return marked("Click points; Enter or a double click ends.");
        case Measure::area:
            return marked("Click the corners; Enter or a double click ends.");
        case Measure::angle:
            return marked("Click a point, the vertex, and a point.");
        case Measure::height:
            return marked("Click the lower point, then the higher one.");
        default:
            return marked("Click two points.");
    }
}

bool is_enter(const KeyPress& press) { return press.key == key::enter || press.key == key::keypad_enter; }

Unit unit_at(int index) { return Unit(index); }

}  // namespace

void take_measuring_keys(Session& s) {
    if (!s.window.panels.measure || s.window.panels.help) return;
    s.window.input.double_clicked = false;
    const auto is_ours = [](const KeyPress& p) {
        return p.with == KeyPress::With::nothing &&
               (is_enter(p) || p.key == key::backspace || p.key == key::escape);
    };
    std::ranges::copy_if(s.window.input.keys, std::back_inserter(s.window.measuring), is_ours);
    std::erase_if(s.window.input.keys, is_ours);
}

MeasurePanel::MeasurePanel(const PackageReader& package)
    : package_(&package),
      origin_(Eigen::Map<const Eigen::Vector3d>(package.scene().origin)),
      file_(survey_file_of(package.path(), package.remote())),
      profile_(origin_) {}

/// Another program may have changed the file since the mode was last active. Unsaved measurements are kept.
void MeasurePanel::begin(Session& s, double now) {
    active_ = true;
    ++reads_;
    survey_.up = up_of(package_->scene());
    try {
        if (!file_.fails()) survey_ = file_.read(Survey{.up = survey_.up});
    } catch (const Error& e) {
        say(s.message, failure_text(tr("Measurements cannot be read."), e), now);
    }
    selected_.reset();
    evaluate_all();
}

void MeasurePanel::evaluate_all() {
    values_.clear();
    for (const Measurement& m : survey_.measurements)
        values_.push_back(evaluate(m, survey_.scale, survey_.up));
}

bool MeasurePanel::attend(Session& s, double now) {
    if (const std::string trouble = file_.take_trouble(); !trouble.empty())
        say(s.message, failure_text(tr("Measurements are not saved."), trouble), now);
    if (!s.window.panels.measure) {
        active_ = false;
        next_.points.clear();
        return false;
    }
    if (!active_) begin(s, now);
    take_keys(s);
    return true;
}

void MeasurePanel::show(Controls& c, Session& s, std::span<const PlacedMesh> meshes, const View& view,
                        double now) {
    if (!attend(s, now)) return;
    take_clicks(s, meshes, view, now);
    look_under_pointer(s, meshes, view);
    draw_measurements(c, drawn(), view, origin_, survey_.up);
    if (scale_bar_ && !meshes.empty())
        show_scale_bar(c, view, s.viewpoint.camera.target, survey_.scale, s.window.free);
    const float em = ImGui::GetFontSize(), right = ImGui::GetIO().DisplaySize.x;
    Area place = s.window.free;
    place.width = double(right) - place.left;  // with the column for the panel
    ImGui::SetNextWindowPos(ImVec2(right - 0.5f * em, float(place.top) + 0.5f * em), ImGuiCond_Appearing,
                            ImVec2(1, 0));
    ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0),
                                        ImVec2(FLT_MAX, std::max(11 * em, float(place.height) - em)));
    if (ImGui::Begin(shown_name("Measure").c_str(), &s.window.panels.measure,
                     ImGuiWindowFlags_AlwaysAutoResize)) {
        keep_within(place);
        ImGui::PushItemWidth(11 * em);
        content(c, s, meshes, now);
        ImGui::PopItemWidth();
        profile_.draw(view);
    }
    ImGui::End();
}

Snapping MeasurePanel::snapping(const Session& s) const {
    return {s.settings.sections, to_vertices_ ? vertex_pixels : 0};
}

void MeasurePanel::look_under_pointer(const Session& s, std::span<const PlacedMesh> meshes,
                                      const View& view) {
    const ImGuiIO& io = ImGui::GetIO();
    const Eigen::Vector2d at(double(io.MousePos.x), double(io.MousePos.y));
    under_.reset();
    if (!io.WantCaptureMouse && in_frame(view.intrinsics, at))
        under_ = scene_point(meshes, origin_, view, at, snapping(s));
}

/// Backspace removes the last point. Esc cancels the current measurement, then leaves the mode.
void MeasurePanel::take_keys(Session& s) {
    for (const KeyPress& press : std::exchange(s.window.measuring, {})) {
        if (is_enter(press)) {
            end();
        } else if (press.key == key::backspace) {
            remove_last_point();
        } else if (!press.repeated) {
            if (next_.points.empty()) s.window.panels.measure = false;
            next_.points.clear();
        }
    }
}

void MeasurePanel::take_clicks(Session& s, std::span<const PlacedMesh> meshes, const View& view, double now) {
    if (ImGui::GetIO().WantCaptureMouse) return;
    for (const Click& click : s.window.input.clicks) {
        if (click.second) {
            end();
            continue;
        }
        const auto point = scene_point(meshes, origin_, view, {click.x, click.y}, snapping(s));
        if (point)
            add(*point);
        else
            say(s.message,
                meshes.empty() ? tr("Measuring needs a mesh") : tr("There is no surface to measure"), now);
    }
}

void MeasurePanel::set_point(Session& s, double now) {
    if (under_)
        add(*under_);
    else
        say(s.message, tr("There is no surface to measure"), now);
}

void MeasurePanel::add(const SurveyPoint& point) {
    next_.points.push_back(point);
    if (next_.points.size() == max_points(next_.measure)) end();
}

/// Finishes the current measurement if it has enough points.
void MeasurePanel::end() {
    if (next_.points.size() < fewest_points(next_.measure)) return;
    survey_.measurements.push_back(
        {free_name(next_.measure), next_.measure, std::exchange(next_.points, {})});
    changed();
    select(survey_.measurements.size() - 1);
    shows_last_ = true;
}

void MeasurePanel::restore(Session& s, const Survey& expected, const Survey& survey, double now) {
    s.window.panels.measure = true;
    if (!active_) begin(s, now);
    if (!(survey_ == expected)) return;
    survey_.scale = survey.scale;
    survey_.measurements = survey.measurements;
    selected_.reset();
    changed();
}

void MeasurePanel::changed() {
    evaluate_all();
    file_.save(survey_);
}

bool MeasurePanel::save_unsaved() {
    if (!unsaved()) return true;
    file_.save(survey_);
    return !unsaved();
}

std::string MeasurePanel::free_name(Measure measure) const {
    for (int n = 1;; ++n) {
        const std::string name = std::string(tr(name_of(measure))) + " " + std::to_string(n);
        if (!std::ranges::count(survey_.measurements, name, &Measurement::name)) return name;
    }
}

std::vector<DrawnMeasurement> MeasurePanel::drawn() const {
    std::vector<DrawnMeasurement> out;
    for (std::size_t i = 0; i < survey_.measurements.size(); ++i) {
        const Measurement& m = survey_.measurements[i];
        const std::string text = m.measure == Measure::point ? "" : ": " + text_of(values_[i]);
        out.push_back({m, m.name + text, selected_ == i ? MeasureLook::selected : MeasureLook::finished});
    }
    Measurement next = next_;
    if (under_) next.points.push_back(*under_);
    const bool whole = next.measure != Measure::point && next.points.size() >= fewest_points(next.measure);
    const std::string value = whole ? text_of(evaluate(next, survey_.scale, survey_.up)) : "";
    out.push_back({next, value, under_ ? MeasureLook::preview : MeasureLook::unfinished});
    return out;
}

void MeasurePanel::content(Controls& c, Session& s, std::span<const PlacedMesh> meshes, double now) {
    choice_of_measure(c, s.window.keyboard);
    under_pointer(c);
    scale_section(c, s.window.keyboard);
    list(c);
    selected_section(c, s, now);
    profile_.show(c, s, meshes, survey_, selected_);
    if (!survey_.measurements.empty()) {
        if (c.button("Export table"))
            s.window.commands.push_back(SaveTable{MARKED_IN("written", "measurements"), survey_csv(survey_)});
        c.explain("Writes all measurements as a table (CSV) next to the package.");
    }
    if (file_.failed())
        ImGui::TextWrapped(tr("not saved in %s"), file_.path().filename().c_str());
    else if (file_.exists())
        ImGui::TextDisabled(tr("saved in %s"), file_.path().filename().c_str());
}

void MeasurePanel::choice_of_measure(Controls& c, bool keyboard) {
    int measure = int(next_.measure);
    if (c.choice(MARKED_IN("quantity", "Measure"), &measure, measures, int(std::size(measures)))) {
        next_.measure = Measure(measure);
        next_.points.clear();
    }
    c.explain("The quantity that the next clicks on the model measure.");
    if (!keyboard) return;  // nor a pointer near vertices
    ImGui::TextUnformatted(tr(instruction(next_.measure)));
    ImGui::TextDisabled("%s", tr("Backspace removes the last point; Esc stops measuring."));
    c.checkbox("Snap to vertices", &to_vertices_);
    c.explain(
        "Sets points on the nearest vertex of the mesh, if one is near the pointer; otherwise on the "
        "surface under it.");
}

/// Without a surface under the pointer, uses the same number of lines, so that the panel keeps its size.
void MeasurePanel::under_pointer(Controls& c) const {
    ImGui::Separator();
    ImGui::TextDisabled("%s", tr("Under the pointer, in the input's coordinates"));
    ImGui::TextUnformatted(under_ ? localized_numbers(coordinates_text(*under_)).c_str() : tr("no surface"));
    if (const auto uncertainty = under_ ? uncertainty_of(*under_) : std::nullopt)
        ImGui::TextDisabled(tr("± %s, finest pixels in %s"),
                            localized_numbers(uncertainty_text(*uncertainty)).c_str(), under_->photo.c_str());
    else
        ImGui::TextDisabled("%s", under_ ? tr("uncertainty unknown: no photo sees the point") : " ");
    c.explain(
        "Standard uncertainty: the size of a pixel there in the photo with the finest pixels, and half a "
        "pixel of this view for pointing. Move closer to point more precisely.");
}

void MeasurePanel::scale_section(Controls& c, bool keyboard) {
    ImGui::Separator();
    Scale& scale = survey_.scale;
    int unit = int(scale.unit), shown = int(shown_unit(scale));
    if (c.choice("Model's unit", &unit, unit_texts, int(std::size(unit_texts)))) {
        scale = unit_at(unit) == Unit::unknown ? Scale{} : Scale{1, unit_at(unit), unit_at(unit)};
        changed();
    }
    c.explain("The unit of the input's coordinates, which the input files do not state.");
    if (scale.unit != Unit::unknown && c.choice("Shown in", &shown, unit_texts, int(std::size(unit_texts))) &&
        unit_at(shown) != Unit::unknown) {
        scale.shown = unit_at(shown);
        changed();
    }
    if (keyboard && scale.unit != Unit::unknown) c.checkbox("Scale bar", &scale_bar_);
    if (scale.length != 1)
        ImGui::TextDisabled(tr("one unit of the model is %s %s"),
                            localized_numbers(number_text(scale.length)).c_str(),
                            tr_in("unit", name_of(scale.unit)));
    ImGui::TextDisabled(tr("up is %s"), localized_numbers(direction_text(survey_.up)).c_str());
    c.explain(
        "Heights are measured along this direction: the axis of the input that is nearest to the photos' "
        "mean up direction, or that mean direction if no axis is near.");
}

void MeasurePanel::list(Controls& c) {
    ImGui::Separator();
    if (survey_.measurements.empty()) {
        ImGui::TextDisabled("%s", tr("no measurements yet"));
        return;
    }
    constexpr std::size_t most_rows = 6;
    const float em = ImGui::GetFontSize(), column = 10.7f * em;
    float width = 0;
    for (const Measured& value : values_)
        width = std::max(width, ImGui::CalcTextSize(text_of(value).c_str()).x);
    ImGui::BeginChild("##measurements", ImVec2(column + width + ImGui::GetStyle().ScrollbarSize,
                                               ImGui::GetTextLineHeightWithSpacing() *
                                                   float(std::min(most_rows, values_.size()))));
    for (std::size_t i = 0; i < survey_.measurements.size(); ++i) {
        const Measurement& m = survey_.measurements[i];
        ImGui::PushID(int(i));
        const std::string label = m.name.empty() ? tr("(no name)") : m.name;
        if (ImGui::Selectable((label + "##" + std::to_string(i)).c_str(), selected_ == i, 0,
                              ImVec2(9.3f * em, 0)))
            select(i);
        c.note(label.c_str());
        ImGui::SameLine(column);
        ImGui::TextUnformatted(text_of(values_[i]).c_str());
        ImGui::PopID();
    }
    if (std::exchange(shows_last_, false)) ImGui::SetScrollHereY(1);
    ImGui::EndChild();
}

void MeasurePanel::select(std::size_t measurement) {
    selected_ = measurement;
    std::snprintf(name_.data(), name_.size(), "%s", survey_.measurements[measurement].name.c_str());
    known_length_ = 0;
}

void MeasurePanel::selected_section(Controls& c, Session& s, double now) {
    if (!selected_) return;
    const std::size_t at = *selected_;
    ImGui::Separator();
    if (!values_[at].note.empty() && survey_.measurements[at].measure != Measure::point) {
        for (const std::string& line :
             wrapped(localized_numbers(values_[at].note), 22 * ImGui::GetFontSize()))
            ImGui::TextDisabled("%s", line.c_str());
    }
    if (s.window.keyboard) {
        ImGui::InputText(shown_name("Name").c_str(), name_.data(), name_.size());
        c.note("Name");
        if (ImGui::IsItemDeactivatedAfterEdit()) {
            survey_.measurements[at].name = name_.data();
            changed();
        }
        if (c.button("Copy"))
            ImGui::SetClipboardText((survey_.measurements[at].name + ": " + text_of(values_[at])).c_str());
        ImGui::SameLine();
    }
    const bool deleted = c.button("Delete");
    if (s.window.keyboard && survey_.measurements[at].measure == Measure::distance) {
        c.number("Known length", &known_length_, "%.6f");
        c.explain(
            "The true length of this distance, in the displayed unit, or in meters if the model's unit is "
            "unknown. Sets the scale of all measurements.");
        const auto or_meters = [](Unit unit) { return unit == Unit::unknown ? Unit::m : unit; };
        const Unit unit = or_meters(survey_.scale.unit), shown = or_meters(shown_unit(survey_.scale));
        ImGui::SameLine();
        ImGui::TextUnformatted(tr_in("unit", name_of(shown)));
        ImGui::SameLine();
        if (c.button("Set scale")) {
            const Measured raw = evaluate(survey_.measurements[at], {}, survey_.up);
            const double known = known_length_ * meters_in(shown) / meters_in(unit);
            const auto scale = scale_from(raw.value.value_or(0), raw.uncertainty.value_or(0), known, unit);
            if (scale) {
                survey_.scale = *scale;
                survey_.scale.shown = shown;
                const std::vector<SurveyPoint>& ends = survey_.measurements[at].points;
                survey_.scale.between = {ends.front().position, ends.back().position};
                changed();
            } else {
                say(s.message, tr("A scale needs two different points and a length above 0"), now);
            }
        }
    }
    if (!deleted) return;
    survey_.measurements.erase(survey_.measurements.begin() + std::ptrdiff_t(at));
    selected_.reset();
    changed();
}

}  // namespace vantage
