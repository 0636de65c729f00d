#include "player/survey/survey_saver.h"

#include <cstdio>
#include <utility>

#include "base/text/error.h"

namespace vantage {

SurveySaver::SurveySaver(SurveyFile file)
    : path_(file.path),
      file_(std::move(file)),
      thread_([this](const std::stop_token& stop) { write_until(stop); }) {}

SurveySaver::~SurveySaver() {
    thread_.request_stop();
    thread_.join();
    if (!trouble_.empty()) std::fprintf(stderr, "vantage-player: %s\n", trouble_.c_str());
}

Survey SurveySaver::read(const Survey& otherwise) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !next_ && !writing_; });
    Survey out = read_survey(file_, otherwise);
    exists_ = file_.content.has_value();
    return out;
}

void SurveySaver::save(const Survey& survey) {
    const std::lock_guard lock(mutex_);
    next_ = survey;
    changed_.notify_all();
}

bool SurveySaver::fails() const {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !next_ && !writing_; });
    return failed_;
}

std::string SurveySaver::take_trouble() {
    const std::lock_guard lock(mutex_);
    return std::exchange(trouble_, {});
}

bool SurveySaver::failed() const {
    const std::lock_guard lock(mutex_);
    return failed_;
}

bool SurveySaver::busy() const {
    const std::lock_guard lock(mutex_);
    return next_ || writing_ || !trouble_.empty();
}

bool SurveySaver::exists() const {
    const std::lock_guard lock(mutex_);
    return exists_ || next_ || writing_;
}

void SurveySaver::write_until(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [&] { return next_.has_value(); })) {
        const Survey survey = *std::exchange(next_, std::nullopt);
        writing_ = true;
        lock.unlock();
        std::string trouble;
        try {
            write_survey(file_, survey);
        } catch (const Error& e) {
            trouble = e.what();
        }
        lock.lock();
        writing_ = false;
        trouble_ = trouble;
        failed_ = !trouble.empty();
        exists_ = file_.content.has_value();
        changed_.notify_all();
    }
}

}  // namespace vantage
