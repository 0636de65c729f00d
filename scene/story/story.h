#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vantage {

/// A text for visitors: one for all languages, or one for each.
struct StoryText {
    std::string plain;                               ///< UTF-8; used if there are no others
    std::map<std::string, std::string> by_language;  ///< tags such as "en" or "pt-BR", and UTF-8
    bool empty() const { return plain.empty() && by_language.empty(); }
    bool operator==(const StoryText&) const = default;
};

/// A camera as people write it, in the input's coordinates.
struct StoryView {
    Eigen::Vector3d eye = Eigen::Vector3d::Zero(), target = Eigen::Vector3d::UnitX();
    std::optional<Eigen::Vector3d> up{};  ///< nothing: that of the photos
    double roll = 0;                      ///< degrees by which the camera is turned clockwise
    double fov = 45;                      ///< vertical, degrees
    bool operator==(const StoryView&) const = default;
};

struct StoryNote {
    std::string id;  ///< unique
    StoryText title, text;
    std::string picture{};                    ///< PNG or JPEG, relative to the story's folder; empty: none
    std::optional<StoryView> view{};          ///< from where it is looked at
    std::optional<Eigen::Vector3d> anchor{};  ///< the place on the surface, in the input's coordinates
    bool operator==(const StoryNote&) const = default;
};

/// A place where a tour stops: at a note or at a view.
struct StoryStop {
    std::string note{};  ///< id; empty: `view` is given
    std::optional<StoryView> view{};
    double fly = 3, stay = 5;  ///< seconds to get there, and there
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

/// What is behind the model: a color, or a gradient from the top of the picture to its bottom.
struct StoryBackground {
    StoryColor top{}, bottom{};
    double soft_edges = 0;  ///< share of the shorter side over which the picture fades toward its edges
    bool operator==(const StoryBackground&) const = default;
};

/// What a kiosk shows while nobody touches it, again and again. Exactly one of the three is given.
struct StoryAttract {
    double after = 60;   ///< seconds without input
    std::string tour{};  ///< id
    std::vector<StoryStop> stops{};
    double turn = 0;  ///< seconds for one turn around the model
    bool operator==(const StoryAttract&) const = default;
};

/// What a curator tells about a package or a scene.
struct Story {
    std::string language = "en";  ///< of plain texts, and where a text lacks the visitor's language
    StoryText title;
    std::optional<StoryView> opening{};
    std::optional<StoryBackground> background{};
    std::vector<StoryNote> notes;
    std::vector<StoryTour> tours;
    std::optional<StoryAttract> attract{};
    bool operator==(const Story&) const = default;
};

/// The text in a language ("de-AT", or else "de"), or else in the story's own, or else in the first one.
const std::string& text_in(const Story& story, const StoryText& text, const std::string& language);

/// All languages of its texts, sorted; its own one is among them.
std::vector<std::string> languages_of(const Story& story);

/// Null if there is none of that id.
const StoryNote* note_of(const Story& story, const std::string& id);
/// By its id, or else by its title in any language; null if there is none.
const StoryTour* tour_of(const Story& story, const std::string& name);
/// The view of a stop, or of its note; null if the note is missing or has none.
const StoryView* view_of_stop(const Story& story, const StoryStop& stop);

/// Sets a text in a language. A text for all languages becomes one for the story's own and one for this.
void set_text(const Story& story, StoryText& text, const std::string& language, const std::string& words);

/// Removes a note, and the stops of tours and of the attract loop at it; tours without stops are removed,
/// too.
void remove_note(Story& story, std::size_t note);

/// An id that no note has yet: "note-1", "note-2", ...
std::string free_note_id(const Story& story);

}  // namespace vantage
