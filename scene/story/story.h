#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vantage {

/// A text for visitors, in UTF-8: one text for all languages, or one for each language.
struct StoryText {
    std::string plain;  ///< the text for all languages; used if `by_language` is empty
    std::map<std::string, std::string> by_language;  ///< keys are tags such as "en" or "pt-BR"
    bool empty() const { return plain.empty() && by_language.empty(); }
    bool operator==(const StoryText&) const = default;
};

/// A camera in human-readable form, in the input's coordinates.
struct StoryView {
    Eigen::Vector3d eye = Eigen::Vector3d::Zero(), target = Eigen::Vector3d::UnitX();
    std::optional<Eigen::Vector3d> up{};  ///< the default is the up direction of the photos
    double roll = 0;                      ///< clockwise rotation of the camera in degrees
    double fov = 45;                      ///< vertical, degrees
    bool operator==(const StoryView&) const = default;
};

struct StoryNote {
    std::string id;  ///< unique
    StoryText title, text;
    std::string picture{};  ///< path of a PNG or JPEG file, relative to the story's folder; may be empty
    std::optional<StoryView> view{};          ///< the view from which the note is shown
    std::optional<Eigen::Vector3d> anchor{};  ///< position on the surface, in the input's coordinates
    bool operator==(const StoryNote&) const = default;
};

/// A stop of a tour, at a note or at a view.
struct StoryStop {
    std::string note{};  ///< the note's ID; if empty, `view` is set
    std::optional<StoryView> view{};
    double fly = 3, stay = 5;  ///< durations of the flight and the stop, in seconds
    bool operator==(const StoryStop&) const = default;
};

struct StoryTour {
    std::string id;  ///< unique among tours
    StoryText title;
    std::vector<StoryStop> stops;
    bool operator==(const StoryTour&) const = default;
};

/// 8 bits, sRGB.
using StoryColor = std::array<std::uint8_t, 3>;

/// The plain background: a color, or a gradient from the top of the picture to its bottom.
struct StoryBackground {
    StoryColor top{}, bottom{};
    double soft_edges = 0;  ///< fraction of the shorter side over which the picture fades toward its edges
    bool operator==(const StoryBackground&) const = default;
};

/// Limits of the camera for visitors.
struct StoryLimits {
    bool near_photos = true;           ///< orbits and zooming out end where there are no photos
    std::optional<double> farthest{};  ///< largest distance when zooming out, in input units
    bool operator==(const StoryLimits&) const = default;
};

/// A ball whose surface and background are hidden, in the input's coordinates.
struct StoryBall {
    Eigen::Vector3d center;
    double radius;
    bool operator==(const StoryBall&) const = default;
};

/// The loop that a kiosk shows while idle. Exactly one of `tour`, `stops` and `turn` is set.
struct StoryAttract {
    double after = 60;   ///< seconds without input
    std::string tour{};  ///< id
    std::vector<StoryStop> stops{};
    double turn = 0;  ///< seconds per turn around the model
    bool operator==(const StoryAttract&) const = default;
};

/// A curator's presentation of a package or a scene.
struct Story {
    /// The language of plain texts, and the fallback for texts that lack the visitor's language.
    std::string language = "en";
    StoryText title;
    std::string web{};  ///< address of the scene's page on the web; may be empty
    std::optional<StoryView> opening{};
    std::optional<StoryBackground> background{};
    bool only_object = false;  ///< hides the photographed background at first
    StoryLimits limits{};
    std::vector<StoryBall> hidden{};
    std::vector<StoryNote> notes;
    std::vector<StoryTour> tours;
    std::optional<StoryAttract> attract{};
    bool operator==(const Story&) const = default;
};

/// The text in a language ("de-AT", then "de"). If there is none, the text in the story's language or,
/// failing that, in the first available language.
const std::string& text_in(const Story& story, const StoryText& text, const std::string& language);

/// A sorted list of all languages of the story's texts, including the story's own language.
std::vector<std::string> languages_of(const Story& story);

/// Whether a place is in one of the hidden balls.
bool hides(const Story& story, const Eigen::Vector3d& place);

/// The note with this ID; null if there is none.
const StoryNote* note_of(const Story& story, const std::string& id);
/// The tour with this ID or, if there is none, with this title in any language; null if there is no such
/// tour.
const StoryTour* tour_of(const Story& story, const std::string& name);
/// The view of a stop, or of its note; null if the note is missing or has no view.
const StoryView* view_of_stop(const Story& story, const StoryStop& stop);

/// Sets a text's wording in one language. A text for all languages is split into one for the story's language
/// and one for this language.
void set_text(const Story& story, StoryText& text, const std::string& language, const std::string& words);

/// Removes a note, and its stops in tours and in the attract loop. Tours left without stops are removed as
/// well.
void remove_note(Story& story, std::size_t note);

/// A note ID that is not yet used: "note-1", "note-2", ...
std::string free_note_id(const Story& story);

}  // namespace vantage
