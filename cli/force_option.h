#pragma once
#include <CLI/CLI.hpp>

namespace vantage {

/// For commands that write files (see output_file).
inline void add_force(CLI::App& app, bool& force) {
    app.add_flag("--force", force,
                 "also replace files that were not written by Vantage; never inputs, folders or devices");
}

}  // namespace vantage
