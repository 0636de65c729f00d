#pragma once
#include "player/interface/state/session.h"

namespace vantage {

/// Copies the view to the clipboard as a command line that shows it, and flies to one that was pasted, if the
/// session asks for that. `package`: whose coordinates they are in.
void use_clipboard(Session& session, const PackageReader& package, double now);

}  // namespace vantage
