#include "player/measure/bench/frame_timer.h"

#include <algorithm>

namespace vantage {

using Clock = std::chrono::steady_clock;

FrameTimer::FrameTimer(bool software) : software_(software) {
    if (!software_) query_ = gl::make_query(GL_TIME_ELAPSED);
}

void FrameTimer::begin() {
    start_ = Clock::now();
    if (!software_) glBeginQuery(GL_TIME_ELAPSED, query_.id());
}

double FrameTimer::end() {
    if (software_) {
        glFinish();
        return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
    }
    glEndQuery(GL_TIME_ELAPSED);
    const double cpu = std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
    GLuint64 ns = 0;
    glGetQueryObjectui64v(query_.id(), GL_QUERY_RESULT, &ns);
    return std::max(cpu, double(ns) / 1e6);
}

}  // namespace vantage
