#pragma once
#include <optional>
#include <string>

#include "player/headset/runtime/headset_session.h"

namespace vantage {

/// A headset: the OpenXR runtime and the session with it. Both may be lost and come back. Belongs to the
/// OpenGL thread.
class Headset {
  public:
    /// Connects to the runtime. Needs no OpenGL. Throws Error(graphics) if there is no runtime or no headset.
    Headset();
    /// The session, made with the current OpenGL context if there is none. Without a runtime, tries to
    /// connect again, at most once a second; null as long as that fails. Throws Error(graphics) if the first
    /// session fails.
    HeadsetSession* session();
    /// Forgets the session, and the runtime if it is gone as well.
    void lose(bool runtime);
    /// Of the runtime that was connected last.
    const std::string& name() const { return name_; }

  private:
    std::optional<XrRuntime> runtime_;
    std::optional<HeadsetSession> session_;
    std::string name_;
    bool had_session_ = false;
    double tried_at_ = -1e9;  ///< seconds
};

}  // namespace vantage
