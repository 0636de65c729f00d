#pragma once
#include "player/interface/state/session.h"

namespace vantage {

/// At the session's request, copies the view to the clipboard as a command line, or flies to a pasted view.
/// `package` defines the coordinates.
void use_clipboard(Session& session, const PackageReader& package, double now);

}  // namespace vantage
