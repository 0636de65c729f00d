#pragma once
#include <CLI/CLI.hpp>
#include <chrono>
#include <string>

#include "pipeline/run/progress.h"

namespace vantage {

/// How progress is shown: a bar that updates in place, plain lines, one JSON object per line, or not at all.
enum class ProgressStyle { bar, lines, json, none };
/// Adds --progress: the name of a style.
void add_progress(CLI::App& app, std::string& style);
/// "auto" is a bar on a terminal and lines elsewhere. Throws Error(usage).
ProgressStyle progress_style(const std::string& name);

/// Shows progress on stderr, with the rate and remaining time of the current stage.
class ProgressLine {
  public:
    explicit ProgressLine(ProgressStyle style) : style_(style) {}
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(const Progress& progress);

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
