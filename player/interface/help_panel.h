#pragma once
#include "player/interface/session.h"

namespace vantage {

/// What mouse and keys do.
void help_panel(Session& session);

}  // namespace vantage
