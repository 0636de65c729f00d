#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "pipeline/scene_input.h"
#include "pipeline/stages/border.h"
#include "pipeline/stages/undistort.h"
#include "scene/effects.h"

namespace vantage {

/// Settings of `vantage prepare`; every one is a point on a curve of accuracy against time.
struct PrepareSettings {
    DistanceMethod distance = DistanceMethod::automatic;
    double border_width = 64;        ///< px at a photo 3072 px wide: where the border mask reaches 1
    double border_threshold = 0.01;  ///< depth step relative to depth, per pixel of the masks
    int thumbnail = 512;             ///< px on the long side
    int photo_size = 0;              ///< px on the long side that photos are reduced to; 0: as they are
    Resampling resampling = Resampling::lanczos;  ///< of photos whose lens bends lines
    unsigned cluster_triangles = 256;
    unsigned threads = 0;  ///< 0: all cores; also the number of photos in flight
    std::vector<std::string> hold_out;
    std::map<Effect, EffectChoice> effects;
};

/// What is going on, for a progress line.
struct Progress {
    const char* stage;
    std::string photo;
    std::size_t done, total;
};

/// Prepares the package `out` from `scene`. Work is per photo: at most `threads` photos are in memory. The
/// same inputs and settings give the same bytes. Throws Error; the file appears only when whole.
void prepare(SceneInput scene, const PrepareSettings& settings, const std::filesystem::path& out,
             const std::function<void(const Progress&)>& progress);

}  // namespace vantage
