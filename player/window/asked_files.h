#pragma once
#include <functional>
#include <future>

#include "player/interface/session.h"
#include "player/objects/object_set.h"

namespace vantage {

/// Writes what a session asks for into the current folder, one file at a time, while the caller goes on: the
/// table of measurements, the scene file, the drawing of the cut. Its destructor waits for the last one.
class AskedFiles {
  public:
    /// Starts what is asked for, and says when it is done.
    void attend(Session& session, const PackageReader& package, const ObjectSet& objects, double now);
    bool writes() const { return said_.valid(); }

  private:
    /// As write_numbered().
    void start(const std::string& stem, const char* extension, const std::string& what,
               std::function<void(const std::string& file)> write);

    std::future<std::string> said_;  ///< by what is being written
};

}  // namespace vantage
