#pragma once
#include <chrono>
#include <string>

#include "base/values/progress.h"

namespace vantage {

/// How progress is shown: a bar that updates in place, plain lines, one JSON object per line, or not at all.
/// `automatic` means a bar on a terminal, lines elsewhere, and nothing with -q.
enum class ProgressStyle { automatic, bar, lines, json, none };

/// Shows progress on stderr, with the rate and the remaining time of the current stage.
class ProgressLine {
  public:
    /// `seconds_between_lines`: the minimum interval between lines, for operations with many short steps.
    explicit ProgressLine(ProgressStyle style, double seconds_between_lines = 0);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(const Progress& progress);
    ProgressStyle style() const { return style_; }  ///< never automatic
    double seconds() const;                         ///< since the stage began

  private:
    ProgressStyle style_;
    double seconds_between_lines_, next_line_;
    bool shown_ = false;
    std::string stage_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace vantage
