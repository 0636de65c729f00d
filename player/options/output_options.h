#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace vantage {

struct OutputOptions {
    std::string size;    ///< WIDTHxHEIGHT of window or pictures; empty: default
    std::string file;    ///< or folder; empty: default
    bool force = false;  ///< see output_file
    bool quiet = false;
};
void add_output_options(CLI::App& app, OutputOptions& options);

}  // namespace vantage
