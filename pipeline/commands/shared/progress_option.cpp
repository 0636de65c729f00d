#include "pipeline/commands/shared/progress_option.h"

#include "base/cli/stop_signals.h"

namespace vantage {

void add_progress(const Command& command, ProgressStyle& style) {
    command.choice(
        "--progress", style,
        {{"auto", ProgressStyle::automatic},
         {"bar", ProgressStyle::bar},
         {"lines", ProgressStyle::lines},
         {"json", ProgressStyle::json},
         {"none", ProgressStyle::none}},
        "how to show progress; auto: a bar on a terminal, lines elsewhere; json: machine-readable lines");
}

OnProgress shown_until_signal(ProgressLine& line) {
    return until_stopped(&stop_on_signals(InFlight::finished),
                         "stopped: the copied part is kept; run the same command again to continue",
                         [&line](const Progress& p) { line.show(p); });
}

}  // namespace vantage
