#pragma once
#include <string>

namespace vantage {

class Command;

struct OutputOptions {
    std::string size;    ///< WIDTHxHEIGHT of window or pictures; empty: default
    std::string file;    ///< file or folder; empty: default
    bool force = false;  ///< see output_file
};
void add_size_option(const Command& command, OutputOptions& options);
/// -o and --force.
void add_output_options(const Command& command, OutputOptions& options);

}  // namespace vantage
