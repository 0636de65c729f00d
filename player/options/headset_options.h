#pragma once
#include <CLI/CLI.hpp>

namespace vantage {

struct HeadsetOptions {
    bool on = false;
    double unit_meters = 0;  ///< a scene unit; 0: as the measurements say, or else unknown
};
void add_headset_options(CLI::App& app, HeadsetOptions& options);

}  // namespace vantage
