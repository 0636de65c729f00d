#pragma once
#include <CLI/CLI.hpp>
#include <array>
#include <functional>

/// The verbs, one file each. A verb's function adds its subcommand to the command line; if it is chosen,
/// parsing sets `run`.
namespace vantage {

using Run = std::function<int()>;
using AddCommand = void(CLI::App& app, Run& run);
AddCommand add_inspect, add_align, add_prepare, add_merge, add_refine, add_repack, add_info, add_check,
    add_diff, add_extract, add_thumbnail, add_synth;

/// In the order of --help.
inline constexpr std::array all_commands{add_inspect, add_align,   add_prepare,   add_merge,
                                         add_refine,  add_repack,  add_info,      add_check,
                                         add_diff,    add_extract, add_thumbnail, add_synth};

}  // namespace vantage
