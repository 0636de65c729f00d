#pragma once
#include "base/cli/command.h"
#include "player/options/show_options.h"

namespace vantage {

/// The command line of vantage-player. Its actions return the exit code or throw Error.
Command player_command();

/// Parts of player_command(). Without a verb, the command opens a window.
void add_window(const Command& program);
void add_kiosk(const Command& program);
void add_headset(const Command& program);
void add_render(const Command& program);
void add_video(const Command& program);
void add_orthophoto(const Command& program);
void add_list(const Command& program);
void add_evaluate(const Command& program);
void add_verify(const Command& program);
void add_bench(const Command& program);
void add_smoothness(const Command& program);

}  // namespace vantage
