#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/bench/results/measurement.h"

namespace vantage::bench {

/// The completed jobs. Each job is appended to a file when it ends, so that an interrupted run can be
/// resumed.
class Log {
  public:
    /// Resumes the log if its recorded `run` is the same; otherwise, starts a new log. Drops an incomplete
    /// last line. Throws Error(storage).
    Log(const std::filesystem::path& file, const std::string& run);

    bool holds(const std::string& job) const { return seconds_.contains(job); }
    /// Appends a completed job. Throws Error(storage).
    void add(const std::string& job, double seconds, const std::vector<Measurement>& measurements);

    std::size_t jobs() const { return seconds_.size(); }
    /// The total time of all jobs in seconds.
    double seconds() const;
    const std::vector<Measurement>& measurements() const { return measurements_; }

  private:
    std::filesystem::path file_;
    std::map<std::string, double> seconds_;  ///< by job
    std::vector<Measurement> measurements_;
};

}  // namespace vantage::bench
