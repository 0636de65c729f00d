#pragma once
#include <chrono>
#include <string>

#include "pipeline/run/progress.h"

namespace vantage {

/// How progress is told: a bar that rewrites itself, plain lines, a JSON object a line, or not at all.
enum class ProgressStyle { bar, lines, json, none };
/// "auto" is a bar on a terminal and lines elsewhere. Throws Error(usage).
ProgressStyle progress_style(const std::string& name);

/// What is done, and for each stage how fast and how long it will take, on the error stream.
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

/// Shows on the line, which must live as long; after a signal to stop throws Error(interrupted), for work
/// that copies and goes on where it was.
OnProgress shown_until_signal(ProgressLine& line);

}  // namespace vantage
