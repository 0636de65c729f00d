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

/// Writes what a session asks for into the current folder, one file after the other, while the caller goes
/// on: the table of measurements, the scene file, the drawing of the cut.
class AskedFiles {
  public:
    AskedFiles() = default;
    /// Writes what is still to be written, and says on stderr what became of it.
    ~AskedFiles();
    AskedFiles(const AskedFiles&) = delete;

    /// Takes what is asked for, and says when it is done.
    void attend(Session& session, const PackageReader& package, const ObjectSet& objects, double now);
    bool busy() const { return said_.valid(); }

  private:
    using Job = std::function<std::string()>;  ///< writes a file and returns what is to be said
    /// As write_numbered().
    void add(const std::string& stem, const char* extension, const std::string& what,
             std::function<void(const std::string& file)> write);
    void add_cut(std::vector<SectionLine> lines, const PackageReader& package);

    std::deque<Job> jobs_;
    std::future<std::string> said_;  ///< by the job that is being done
};

}  // namespace vantage
