#include "cli/step_progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace vantage {

StepProgress::StepProgress(std::string step, bool quiet)
    : step_(std::move(step)), quiet_(quiet), terminal_(::isatty(STDERR_FILENO) == 1) {}

StepProgress::~StepProgress() {
    if (shown_ && terminal_) std::fputs("\r\033[K", stderr);
}

void StepProgress::show(std::size_t done, std::size_t count) {
    const double passed = seconds();
    if (quiet_ || done == 0 || (!terminal_ && passed < next_)) return;
    next_ = passed + 10;
    const double left = passed / double(done) * double(count - done);
    std::fprintf(stderr, "%s%s %zu of %zu, %.0f s left   %s", terminal_ ? "\r" : "", step_.c_str(), done,
                 count, left, terminal_ ? "" : "\n");
    shown_ = true;
}

double StepProgress::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

}  // namespace vantage
