#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "player/render_settings.h"

namespace vantage {

/// The command line of vantage-player.
struct Options {
    std::string package;
    bool list = false, offscreen = false, quiet = false;
    std::vector<std::string> photos, exclude;
    std::string view, path, size, out, screenshot;
    double scale = 1;
    int samples = 0;  ///< 0: by what is shown
    int frames = 0;   ///< 0: until the window is closed
    int nearest = 8;  ///< photos the window blends
    std::string holes, fov_normalisation = "auto";
    RenderSettings render;
};

void add_options(CLI::App& app, Options& options);

}  // namespace vantage
