#pragma once
#include <chrono>
#include <cstddef>
#include <string>

namespace vantage {

/// What is done, how fast and how long it will take, on the error stream: one line that rewrites itself on a
/// terminal, plain lines elsewhere.
class ProgressLine {
  public:
    ProgressLine();
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(const std::string& stage, const std::string& photo, std::size_t done, std::size_t total) const;

  private:
    bool terminal_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace vantage
