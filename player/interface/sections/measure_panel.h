#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "player/interface/measuring/profile_chart.h"
#include "player/interface/overlays/measure_overlay.h"
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"
#include "player/survey/scene_point.h"
#include "player/survey/survey_saver.h"

namespace vantage {

/// In measuring mode, removes the keys and clicks that it handles from the session's input: Enter, Backspace,
/// Esc, and double clicks, which finish a measurement. Does nothing in other modes.
void take_measuring_keys(Session& session);

/// Measuring mode: clicks on the model set points, and a panel lists the measurements. The measurements are
/// read from a file next to the package when the mode begins, and saved after each change.
class MeasurePanel {
  public:
    /// `package` must outlive the panel.
    explicit MeasurePanel(const PackageReader& package);

    /// Handles the session's input, and draws measurements and the panel while session.window.panels.measure
    /// is set. `meshes`: the visible meshes.
    void show(Controls& controls, Session& session, std::span<const PlacedMesh> meshes, const View& view,
              double now);

    /// The functions below are the steps of show(), for pointers other than the window's. Enters or leaves
    /// the mode as set in the session, and returns whether the mode is active.
    bool attend(Session& session, double now);
    /// Whether measurements are being saved, or attend() has yet to report the result of saving them.
    bool saves() const { return file_.busy(); }
    /// Whether the measurements could not be saved, after waiting for pending writes; failed() does not wait.
    bool unsaved() const { return file_.fails(); }
    bool failed() const { return file_.failed(); }
    /// Saves the measurements again if they could not be saved. Returns whether they are saved.
    bool save_unsaved();
    const std::filesystem::path& file() const { return file_.path(); }
    /// Sets the surface point under the pointer; nullopt: none.
    void point_at(const std::optional<SurveyPoint>& point) { under_ = point; }
    /// Adds the point under the pointer to the measurement.
    void set_point(Session& session, double now);
    /// Finishes a measurement with its current points, if there are enough.
    void end();
    void remove_last_point() {
        if (!next_.points.empty()) next_.points.pop_back();
    }
    bool unfinished() const { return !next_.points.empty(); }
    /// How often the file was read.
    int reads() const { return reads_; }
    const Survey& survey() const { return survey_; }
    /// Enters the mode, and replaces the measurements if they are still equal to `expected`.
    void restore(Session& session, const Survey& expected, const Survey& survey, double now);
    /// The panel's controls. `meshes`: the visible meshes.
    void content(Controls& controls, Session& session, std::span<const PlacedMesh> meshes, double now);
    /// All measurements, with the unfinished one last.
    std::vector<DrawnMeasurement> drawn() const;
    const Eigen::Vector3d& up() const { return survey_.up; }  ///< in input coordinates

  private:
    void begin(Session& session, double now);
    void look_under_pointer(const Session& session, std::span<const PlacedMesh> meshes, const View& view);
    void take_keys(Session& session);
    void take_clicks(Session& session, std::span<const PlacedMesh> meshes, const View& view, double now);
    void add(const SurveyPoint& point);
    void evaluate_all();
    void changed();
    void choice_of_measure(Controls& controls, bool keyboard);
    void under_pointer(Controls& controls) const;
    void scale_section(Controls& controls, bool keyboard);
    void list(Controls& controls);
    void selected_section(Controls& controls, Session& session, double now);
    void select(std::size_t measurement);
    std::string free_name(Measure measure) const;
    Snapping snapping(const Session& session) const;

    const PackageReader* package_;
    Eigen::Vector3d origin_;
    SurveySaver file_;
    Survey survey_;
    std::vector<Measured> values_;  ///< of the measurements
    bool active_ = false;
    int reads_ = 0;
    Measurement next_{"", Measure::distance, {}};  ///< being measured
    bool to_vertices_ = false, scale_bar_ = true;
    std::optional<SurveyPoint> under_;
    std::optional<std::size_t> selected_;
    bool shows_last_ = false;  ///< the list scrolls to its end
    ProfileChart profile_;
    std::array<char, 256> name_{};  ///< name of the selected measurement, as edited
    double known_length_ = 0;       ///< known length of the selected distance, to set the scale
};

}  // namespace vantage
