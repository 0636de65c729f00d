#pragma once
#include <array>
#include <span>
#include <vector>

#include "player/measure/evaluation/luminance.h"
#include "player/measure/evaluation/place.h"

namespace vantage {

/// Causes of differences between a rendered view and its photo, see docs/method.md. Rows of cause_table().
enum class Cause { no_surface, unseen, displaced, detail, disagreement, odd_photo, unjudged, count };
inline constexpr std::size_t cause_count = std::size_t(Cause::count);

/// Texts and color of a cause.
struct CauseRow {
    Cause cause;
    const char *name, *meaning;         ///< one or two words; one line of text
    const char* file;                   ///< part of file and column names
    std::array<std::uint8_t, 3> color;  ///< on maps
};
const std::array<CauseRow, cause_count>& cause_table();
inline const CauseRow& cause_row(Cause cause) { return cause_table()[std::size_t(cause)]; }

/// Whether the cause applies to pixels without color.
inline bool is_hole(Cause cause) { return cause == Cause::no_surface || cause == Cause::unseen; }

/// The squared error of each cause, summed over pixels and three channels.
struct CauseSquares : std::array<double, cause_count> {
    double of(Cause cause) const { return (*this)[std::size_t(cause)]; }
    double all() const;
    double colored() const;                   ///< without holes
    double share(Cause cause) const;          ///< fraction of all(); 0 if there is no error
    double colored_share(Cause cause) const;  ///< fraction of colored(); 0 for holes and if there is no error
};

/// The squared error of a frame, attributed to the causes.
struct CauseMap {
    Cells cells;
    std::vector<CauseSquares> squares;  ///< per cell

    CauseSquares totals() const;
};

/// Input for the attribution of errors. All pictures and planes have the same size.
struct CauseEvidence {
    const Picture& photo;
    const Picture& shown;              ///< see as_in_window, with gains applied
    std::span<const Picture> alone;    ///< the view rendered from single photos, with the same gains
    const Plane& errors;               ///< see squared_errors
    const std::vector<bool>& taken;    ///< whether the photo's pixel is valid
    const std::vector<bool>& colored;  ///< whether a photo contributes to the picture's pixel
    const std::vector<bool>& surface;  ///< whether the pixel shows the mesh
};

/// Assigns the error of each uncolored pixel to one cause, and the error of each cell's colored pixels to one
/// cause.
CauseMap find_causes(const CauseEvidence& evidence);

}  // namespace vantage
