#pragma once
#include <optional>
#include <string>

#include "player/headset/runtime/headset_session.h"

namespace vantage {

/// A headset: the OpenXR runtime and its session, both of which may be lost and re-created. Use it only on
/// the OpenGL thread.
class Headset {
  public:
    /// Connects to the runtime. Needs no OpenGL. Throws Error(graphics) if there is no runtime or no headset.
    Headset();
    /// The session, which is created with the current OpenGL context if it does not exist yet. Without a
    /// runtime, tries to reconnect at most once a second, and returns null while that fails. Throws
    /// Error(graphics) if the first session cannot be created.
    HeadsetSession* session();
    /// Drops the session, and also the runtime if it was lost.
    void lose(bool runtime);
    /// Name of the last connected runtime.
    const std::string& name() const { return name_; }

  private:
    std::optional<XrRuntime> runtime_;
    std::optional<HeadsetSession> session_;
    std::string name_;
    bool had_session_ = false;
    double tried_at_ = -1e9;  ///< time of the last attempt, seconds
};

}  // namespace vantage
