#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "player/measure/evaluation/held_out.h"

namespace vantage {

/// The error of one cause over all frames.
struct CauseTotal {
    Cause cause = Cause::count;
    double share = 0, colored_share = 0;  ///< fraction of all photos' squared errors, see CauseSquares
    /// Increase in PSNR without this error, averaged over the photos: for the frame and for the colored
    /// pixels.
    double decibels = 0, colored_decibels = 0;
    std::size_t worst = 0;  ///< index of the photo with the largest error from this cause
};

/// One entry per cause with nonzero error, largest share first.
std::vector<CauseTotal> cause_totals(const std::vector<PhotoEvaluation>& results);

/// Prints the header of the table of photos. `names`: width of the first column.
void print_heading(int names);
void print_row(const PhotoEvaluation& result, int names);
/// Prints the means over photos with a colored pixel, if there are any.
void print_means(const std::vector<PhotoEvaluation>& results, int names);
/// Prints one line per cause with nonzero error.
void print_causes(const std::vector<PhotoEvaluation>& results);

/// The values that print_row() prints, as one object per photo.
nlohmann::json json_of(const std::vector<PhotoEvaluation>& results);

/// Writes one line per photo as CSV, with these values and more. Throws Error(storage).
void write_photos(const std::filesystem::path& file, const std::vector<PhotoEvaluation>& results);

}  // namespace vantage
