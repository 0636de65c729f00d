#pragma once
#include "player/interface/session.h"
#include "player/objects/object_set.h"

namespace vantage {

/// Writes what the session asks for, into the current folder: the table of measurements, the scene file, the
/// drawing of the cut.
void write_asked_files(Session& session, const PackageReader& package, const ObjectSet& objects, double now);

}  // namespace vantage
