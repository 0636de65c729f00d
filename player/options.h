#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "player/render/render_settings.h"

namespace vantage {

/// The command line of vantage-player.
struct Options {
    std::string package;
    bool list = false, offscreen = false, quiet = false;
    std::vector<std::string> photos, exclude;
    std::string view, path, size, out, screenshot;
    double scale = 1;
    int samples = 0;              ///< 0: by what is shown
    bool fresh = false;           ///< nothing remembered
    bool blending_given = false;  ///< on the command line
    std::string controls;         ///< file for the places of the controls
    int frames = 0;               ///< 0: until the window is closed
    int photos_blended = -1;      ///< -1: by what is shown; 0: all
    unsigned graphics_mib = 0, ring_mib = 32, upload_kib = 8192;
    std::string holes, fov_normalisation = "auto", exposure;
    RenderSettings render;
};

void add_options(CLI::App& app, Options& options);

}  // namespace vantage
