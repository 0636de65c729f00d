#pragma once
#include <chrono>
#include <cstddef>
#include <string>

namespace vantage {

/// Tells on stderr how many of a long work's equal steps are done and how long the rest takes: one line that
/// is replaced on a terminal; elsewhere, one every ten seconds.
class StepProgress {
  public:
    /// `step`: its name, such as "frame".
    StepProgress(std::string step, bool quiet);
    ~StepProgress();
    StepProgress(const StepProgress&) = delete;
    void show(std::size_t done, std::size_t count);
    double seconds() const;  ///< since the start

  private:
    std::string step_;
    bool quiet_, terminal_, shown_ = false;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double next_ = 10;
};

}  // namespace vantage
