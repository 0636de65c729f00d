#pragma once
#include <optional>

#include "player/interface/state/session.h"

namespace vantage {

/// Records the camera's path as long as the session requests it, and then writes it next to the package.
class PathRecorder {
  public:
    /// `rests`: whether nothing has moved since the last call.
    void attend(Session& session, bool rests, const PackageReader& package, double now);

  private:
    struct Recording {
        double begin;
        Navigation last;  ///< camera of the last frame
        double last_at;
    };
    std::optional<Recording> recording_;
};

}  // namespace vantage
