#pragma once
#include "player/interface/state/session.h"

namespace vantage {

/// Copies the view to the clipboard as a command line, or flies to a pasted view, at the session's request.
/// `package` defines the coordinates.
void use_clipboard(Session& session, const PackageReader& package, double now);

}  // namespace vantage
