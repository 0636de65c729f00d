#pragma once
#include "base/cli/command.h"
#include "base/cli/progress_line.h"
#include "pipeline/run/until_stopped.h"

namespace vantage {

/// Adds --progress.
void add_progress(const Command& command, ProgressStyle& style);

/// A callback for resumable copying: shows progress on `line`, which must outlive the callback, and throws
/// Error(interrupted) after a stop signal.
OnProgress shown_until_signal(ProgressLine& line);

}  // namespace vantage
