#pragma once
#include "player/interface/session.h"

namespace vantage {

/// Begins ImGui's frame with the session's input. ImGui reads which keys are down: those released since the
/// last frame are, for this one; also Ctrl, which the caller releases after the frame, if it was not down
/// before. The pointer is where the input says.
void new_frame(const Session& session);

}  // namespace vantage
