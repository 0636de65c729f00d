#pragma once
#include <array>

#include "base/cli/command.h"

/// The verbs, one file each. A verb's function adds its command to the program.
namespace vantage {

using AddCommand = void(const Command& program);
AddCommand add_inspect, add_align, add_prepare, add_merge, add_refine, add_repack, add_info, add_check,
    add_diff, add_extract, add_thumbnail, add_costs, add_synth;

/// All commands, in the order of --help.
inline constexpr std::array all_commands{add_inspect,   add_align, add_prepare, add_merge, add_refine,
                                         add_repack,    add_info,  add_check,   add_diff,  add_extract,
                                         add_thumbnail, add_costs, add_synth};

}  // namespace vantage
