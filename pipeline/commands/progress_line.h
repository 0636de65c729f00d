#pragma once
#include <chrono>
#include <string>

#include "cli/command.h"
#include "pipeline/run/progress.h"

namespace vantage {

/// How progress is shown: a bar that updates in place, plain lines, one JSON object per line, or not at all.
/// `automatic`: a bar on a terminal, lines elsewhere.
enum class ProgressStyle { automatic, bar, lines, json, none };
/// Adds --progress.
void add_progress(const Command& command, ProgressStyle& style);

/// Shows progress on stderr, with the rate and remaining time of the current stage.
class ProgressLine {
  public:
    explicit ProgressLine(ProgressStyle style);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(const Progress& progress);
    ProgressStyle style() const { return style_; }  ///< never automatic

  private:
    ProgressStyle style_;
    bool shown_ = false;
    std::string stage_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// A callback for resumable copying: shows progress on `line`, which must outlive it, and throws
/// Error(interrupted) after a signal to stop.
OnProgress shown_until_signal(ProgressLine& line);

}  // namespace vantage
