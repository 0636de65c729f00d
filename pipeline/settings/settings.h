#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "scene/effects.h"

namespace vantage {

/// What renders the model from the photos' cameras. Automatic: a GPU if there is one, else the CPU.
enum class RenderBy { automatic, opengl, processor };
const char* name(RenderBy by);
/// Throws Error(usage) for an unknown name.
RenderBy render_by(const std::string& name);

/// How the distance to the nearest border is computed. Automatic: jump flooding (JFA^2) on a GPU, else exact.
enum class DistanceMethod { automatic, exact, jfa, jfa_plus_1, one_plus_jfa, jfa_squared };
const char* name(DistanceMethod method);
/// Throws Error(usage) for an unknown name.
DistanceMethod distance_method(const std::string& name);

/// How colors between a photo's pixels are interpolated.
enum class Resampling { nearest, linear, cubic, lanczos };
const char* name(Resampling resampling);
/// Throws Error(usage) for an unknown name.
Resampling resampling(const std::string& name);

/// Settings of `vantage prepare`; each is a point on a curve of accuracy against time.
struct PrepareSettings {
    DistanceMethod distance = DistanceMethod::automatic;
    RenderBy render_by = RenderBy::automatic;
    double border_width = 64;        ///< px in a photo 3072 px wide: where the border mask reaches 1
    double border_threshold = 0.01;  ///< depth step relative to depth, per pixel of the masks
    int thumbnail = 512;             ///< px on the long side
    int photo_size = 0;              ///< px on the long side that photos are reduced to; 0: full size
    Resampling resampling = Resampling::cubic;  ///< for photos that are undistorted
    unsigned cluster_triangles = 256;
    unsigned threads = 0;               ///< also the number of photos in flight; 0: one per core
    std::uint64_t memory = 0;           ///< bytes; limits the number of photos in flight; 0: no limit
    std::vector<std::string> hold_out;  ///< photos whose pixels stay out of the package
    std::map<Effect, EffectChoice> effects;
};

}  // namespace vantage
