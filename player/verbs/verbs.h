#pragma once
#include "base/cli/command.h"

namespace vantage {

/// The command line of vantage-player. Its actions return the exit code and throw Error.
Command player_command();

/// The parts of player_command(), one file each.
void add_show(const Command& program);
void add_bench(const Command& program);
void add_evaluate(const Command& program);
void add_orthophoto(const Command& program);
void add_smoothness(const Command& program);
void add_verify(const Command& program);

}  // namespace vantage
