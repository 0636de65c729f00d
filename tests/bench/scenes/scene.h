#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/input/scene_input.h"
#include "pipeline/synth/spec.h"
#include "player/render/picture.h"
#include "player/view/view.h"

namespace vantage::bench {

/// The extent of the measurements.
struct Effort {
    std::string name;    ///< "smoke", "short" or "full"
    int longest;         ///< maximum long side of compared pictures, in px
    std::size_t views;   ///< reference views per scene
    std::size_t photos;  ///< photos per scene in sweeps whose time grows with the number of photos
    int repeats;         ///< repetitions of each timing
    std::size_t points;  ///< number of surface points, in sweeps that sample geometry
};

/// A view with a reference picture.
struct TrueView {
    std::string name;
    View view;                          ///< relative to the package's origin
    Picture truth;                      ///< the photo itself, or the ray-cast picture
    std::vector<std::uint32_t> photos;  ///< photos that may be blended: all except the held-out one
    std::vector<bool> seeable;  ///< whether at least one of `photos` sees the pixel's surface (ray-cast)
    std::string held_out;       ///< name of the photo used as `truth`, or empty
};

/// A scene to measure on: its input files, and its package as written by `vantage prepare` with default
/// settings.
struct BenchScene {
    std::string name;
    std::filesystem::path folder;   ///< mesh, cameras, photos
    std::optional<SynthSpec> spec;  ///< set for synthetic scenes, whose views can all be ray-cast
    std::filesystem::path package;
    std::vector<TrueView> views;
};

/// Prepares a scene in `work` from the folder of a scan, or from a specification (TOML) of a scene, which is
/// synthesized first. The results of an earlier call with the same files are reused. Throws Error.
BenchScene open_scene(const std::filesystem::path& input, const std::filesystem::path& work,
                      const Effort& effort);

}  // namespace vantage::bench
