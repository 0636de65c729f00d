#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/input/scene_input.h"
#include "pipeline/synth/spec.h"
#include "player/camera/view.h"
#include "player/render/picture.h"

namespace vantage::bench {

/// How much is measured.
struct Effort {
    std::string name;    ///< "smoke", "short" or "full"
    int longest;         ///< px on the long side of the pictures that are compared, at most
    std::size_t views;   ///< true views of a scene
    std::size_t photos;  ///< of a scene that are looked at where each costs
    int repeats;         ///< of everything that is timed
    std::size_t points;  ///< on the surface, where geometry is sampled
};

/// A view whose picture is known.
struct TrueView {
    std::string name;
    View view;                          ///< relative to the package's origin
    Picture truth;                      ///< the photo itself, or the ray-cast picture
    std::vector<std::uint32_t> photos;  ///< that may be blended: all, without the one left out
    std::vector<bool> seeable;          ///< a pixel: shows surface that one of `photos` sees, by ray casting
};

/// A scene to measure on: its files as a user has them, and its package as `vantage prepare` makes it.
struct BenchScene {
    std::string name;
    std::filesystem::path folder;   ///< mesh, cameras, photos
    std::optional<SynthSpec> spec;  ///< of a synthetic one: any view's truth can be had
    std::filesystem::path package;
    std::vector<TrueView> views;
};

/// Makes a scene ready in `work`: a folder of a scan, or a specification (TOML) that is synthesised first.
/// What an earlier call left there, from the same files, is used again. Throws Error.
BenchScene open_scene(const std::filesystem::path& input, const std::filesystem::path& work,
                      const Effort& effort);

}  // namespace vantage::bench
