#pragma once
#include <CLI/CLI.hpp>

#include "player/camera/stereo.h"

namespace vantage {

void add_stereo_options(CLI::App& app, StereoSettings& stereo);

}  // namespace vantage
