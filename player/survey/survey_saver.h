#pragma once
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "player/survey/survey_file.h"

namespace vantage {

/// Reads and writes a survey's file; writes while the caller goes on: a frame must not wait for the disk. Of
/// surveys that follow each other faster than they are written, the last one is. Its destructor writes what
/// is still to be written, and says on stderr what trouble was not taken.
class SurveySaver {
  public:
    explicit SurveySaver(SurveyFile file);
    ~SurveySaver();
    SurveySaver(const SurveySaver&) = delete;

    /// As read_survey(), after pending writes.
    Survey read(const Survey& otherwise);
    void save(const Survey& survey);
    /// Why the last one could not be written; empty if it could, or was asked before.
    std::string take_trouble();
    /// A survey is still to be written, or its trouble to be taken.
    bool busy() const;
    const std::filesystem::path& path() const { return path_; }

  private:
    void write_until(const std::stop_token& stop);

    std::filesystem::path path_;
    SurveyFile file_;  ///< of the thread while `writing_`
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<Survey> next_;
    bool writing_ = false;
    std::string trouble_;
    std::jthread thread_;  ///< last: it uses the others
};

}  // namespace vantage
