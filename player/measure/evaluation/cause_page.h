#pragma once
#include <ostream>
#include <vector>

#include "player/measure/evaluation/held_out.h"

namespace vantage {

/// Name of the file with the crops of a photo's worst region: NAME-CAUSE.png.
std::string region_file(const PhotoEvaluation& result, const WorstRegion& region);

/// Writes the part of the page that attributes the squared error to its causes, as HTML: a table of all
/// photos together, one row per photo, and for each cause the worst regions of all photos.
void write_causes(std::ostream& out, const std::vector<PhotoEvaluation>& results);

/// Writes the crops of one photo's worst regions.
void write_regions_of(std::ostream& out, const PhotoEvaluation& result);

}  // namespace vantage
