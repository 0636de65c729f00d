#include "player/headset/headset.h"

#include <chrono>

#include "base/text/error.h"
#include "player/headset/runtime/xr_result.h"

namespace vantage {
namespace {

constexpr double try_again_seconds = 1;

double seconds_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Headset::Headset() : runtime_(std::in_place), name_(runtime_->name()) { headset_of(*runtime_); }

HeadsetSession* Headset::session() {
    if (session_) return &*session_;
    if (seconds_now() < tried_at_ + try_again_seconds) return nullptr;
    try {
        if (!runtime_) {
            if (!runtime_answers()) throw XrLost(true);
            name_ = runtime_.emplace().name();
        }
        session_.emplace(*runtime_);
    } catch (const XrLost& lost) {
        lose(lost.runtime);
    } catch (const Error&) {
        if (!had_session_) throw;
        lose(true);
    }
    had_session_ |= session_.has_value();
    return session_ ? &*session_ : nullptr;
}

void Headset::lose(bool runtime) {
    session_.reset();
    if (runtime) runtime_.reset();
    tried_at_ = seconds_now();
}

}  // namespace vantage
