#pragma once
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "player/survey/survey_file.h"

namespace vantage {

/// Reads and writes a survey's file. Writing happens in the background, so that frames do not wait for the
/// disk. If surveys change faster than they are written, only the last one is written. Its destructor writes
/// the pending survey, and prints unreported errors to stderr.
class SurveySaver {
  public:
    explicit SurveySaver(SurveyFile file);
    ~SurveySaver();
    SurveySaver(const SurveySaver&) = delete;

    /// Like read_survey(), but waits for pending writes first.
    Survey read(const Survey& otherwise);
    void save(const Survey& survey);
    /// Waits for pending writes, and returns whether the last one failed.
    bool fails() const;
    /// The error of the last write; empty if that write succeeded, or if its error has already been taken.
    std::string take_trouble();
    /// Whether the last write failed.
    bool failed() const;
    /// Whether a survey is pending, or whether an error has not been taken.
    bool busy() const;
    /// Whether the file existed when it was last read or written, or is about to be written.
    bool exists() const;
    const std::filesystem::path& path() const { return path_; }

  private:
    void write_until(const std::stop_token& stop);

    std::filesystem::path path_;
    SurveyFile file_;  ///< used only by the thread while `writing_` is set
    mutable std::mutex mutex_;
    mutable std::condition_variable_any changed_;
    std::optional<Survey> next_;
    bool writing_ = false, exists_ = false, failed_ = false;
    std::string trouble_;
    std::jthread thread_;  ///< declared last, because the thread uses the other members
};

}  // namespace vantage
