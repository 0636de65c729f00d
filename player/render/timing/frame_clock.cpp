#include "player/render/timing/frame_clock.h"

#include <algorithm>
#include <utility>

namespace vantage {

FrameClock::FrameClock(bool software) : software_(software) {
    if (software_) return;
    for (Timed& t : ring_) t.query = gl::make_query(GL_TIME_ELAPSED);
}

void FrameClock::begin() {
    if (std::exchange(measuring_, false) && !software_) glEndQuery(GL_TIME_ELAPSED);
    start_ = std::chrono::steady_clock::now();
    measuring_ = !ring_[next_].pending;
    if (measuring_ && !software_) glBeginQuery(GL_TIME_ELAPSED, ring_[next_].query.id());
}

void FrameClock::end(std::optional<Pace> pace) {
    if (software_) glFinish();
    const double ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    if (software_) {
        if (pace) last_ = {*pace, ms};
        return;
    }
    if (!std::exchange(measuring_, false)) return;
    glEndQuery(GL_TIME_ELAPSED);
    Timed& t = ring_[next_];
    t.pace = pace, t.ms = ms, t.pending = true;
    next_ = (next_ + 1) % ring_.size();
}

std::optional<FrameClock::Frame> FrameClock::take() {
    // Starts with the oldest query, since queries finish in order.
    for (std::size_t i = 0; i < ring_.size(); ++i) {
        Timed& t = ring_[(next_ + i) % ring_.size()];
        if (!t.pending) continue;
        GLint finished = 0;
        glGetQueryObjectiv(t.query.id(), GL_QUERY_RESULT_AVAILABLE, &finished);
        if (!finished) break;
        GLuint64 ns = 0;
        glGetQueryObjectui64v(t.query.id(), GL_QUERY_RESULT, &ns);
        t.pending = false;
        if (t.pace) last_ = {*t.pace, std::max(t.ms, double(ns) / 1e6)};
    }
    return std::exchange(last_, std::nullopt);
}

}  // namespace vantage
