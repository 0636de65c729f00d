#include "player/render/timing/pass_clock.h"

#include <utility>

namespace vantage {

void PassClock::start() {
    on_ = true;
    pass_ = timed_pass_names.size();
    ms_ = {};
}

void PassClock::mark(std::size_t pass) {
    if (!on_) return;
    take(false);
    gl::Query query;
    if (unused_.empty()) {
        query = gl::make_query(GL_TIMESTAMP);
    } else {
        query = std::move(unused_.back());
        unused_.pop_back();
    }
    glQueryCounter(query.id(), GL_TIMESTAMP);
    marks_.push_back({std::move(query), pass});
}

/// Starts with the oldest query, since queries finish in order.
void PassClock::take(bool wait) {
    while (!marks_.empty()) {
        Mark& oldest = marks_.front();
        GLint reached = wait;
        if (!wait) glGetQueryObjectiv(oldest.query.id(), GL_QUERY_RESULT_AVAILABLE, &reached);
        if (!reached) return;
        GLuint64 ns = 0;
        glGetQueryObjectui64v(oldest.query.id(), GL_QUERY_RESULT, &ns);
        add(oldest.pass, double(ns) / 1e6);
        unused_.push_back(std::move(oldest.query));
        marks_.pop_front();
    }
}

void PassClock::add(std::size_t next, double ms) {
    if (pass_ < ms_.size()) ms_.at(pass_) += ms - since_;
    pass_ = next, since_ = ms;
}

PassTimes PassClock::finish() {
    end();
    take(true);
    on_ = false;
    return ms_;
}

}  // namespace vantage
