#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/bench/results/measurement.h"

namespace vantage::bench {

/// The jobs that are done, on disk as each ends: a run that was cut off goes on from there.
class Log {
  public:
    /// `run` says what must be the same for a former run to be gone on with; a log of another run is begun
    /// anew. What was half written is dropped. Throws Error(storage).
    Log(const std::filesystem::path& file, const std::string& run);

    bool holds(const std::string& job) const { return seconds_.contains(job); }
    /// Throws Error(storage).
    void add(const std::string& job, double seconds, const std::vector<Measurement>& measurements);

    std::size_t jobs() const { return seconds_.size(); }
    double seconds() const;
    const std::vector<Measurement>& measurements() const { return measurements_; }

  private:
    std::filesystem::path file_;
    std::map<std::string, double> seconds_;  ///< a job
    std::vector<Measurement> measurements_;
};

}  // namespace vantage::bench
