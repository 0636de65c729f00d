#pragma once
#include <deque>
#include <filesystem>
#include <functional>
#include <future>
#include <string>
#include <vector>

#include "player/composition/object_set.h"
#include "player/interface/state/session.h"
#include "player/survey/section.h"
#include "player/window/input/numbered_file.h"

namespace vantage {

/// Writes files that a session requests (tables of measurements, the scene file, the drawing of the
/// section) next to the package (see stem_for_files()), one after the other, in the background.
class AskedFiles {
  public:
    AskedFiles() = default;
    /// Writes pending files, and prints their results to stderr.
    ~AskedFiles();
    AskedFiles(const AskedFiles&) = delete;

    /// Takes requests, and reports finished files.
    void attend(Session& session, const PackageReader& package, const ObjectSet& objects, double now);
    bool busy() const { return written_.valid(); }

  private:
    using Job = std::function<WrittenFile()>;
    /// Like write_numbered().
    void add(const std::filesystem::path& stem, const char* extension, const std::string& what,
             std::function<void(const std::string& file)> write);
    void add_cut(std::vector<SectionLine> lines, const PackageReader& package);

    std::deque<Job> jobs_;
    std::future<WrittenFile> written_;  ///< by the job in progress
};

}  // namespace vantage
