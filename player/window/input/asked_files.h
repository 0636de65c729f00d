#pragma once
#include <deque>
#include <functional>
#include <future>
#include <string>
#include <vector>

#include "player/composition/object_set.h"
#include "player/interface/state/session.h"
#include "player/survey/section.h"

namespace vantage {

/// Writes files that a session requests (the table of measurements, the scene file, the drawing of the
/// section) into the current folder, one after the other, in the background.
class AskedFiles {
  public:
    AskedFiles() = default;
    /// Writes pending files, and prints their results to stderr.
    ~AskedFiles();
    AskedFiles(const AskedFiles&) = delete;

    /// Takes requests, and reports finished files.
    void attend(Session& session, const PackageReader& package, const ObjectSet& objects, double now);
    bool busy() const { return said_.valid(); }

  private:
    using Job = std::function<std::string()>;  ///< writes a file and returns the message
    /// Like write_numbered().
    void add(const std::string& stem, const char* extension, const std::string& what,
             std::function<void(const std::string& file)> write);
    void add_cut(std::vector<SectionLine> lines, const PackageReader& package);

    std::deque<Job> jobs_;
    std::future<std::string> said_;  ///< the message of the job in progress
};

}  // namespace vantage
