#pragma once
#include <optional>
#include <string>
#include <vector>

#include "player/interface/state/session.h"
#include "player/window/child_program.h"

namespace vantage {

/// The command line of this program that writes the requested orthophoto of what the session shows.
std::vector<std::string> orthophoto_arguments(const Session& session, const PackageReader& package,
                                              const std::string& file);

/// Writes the orthophotos that a session requests, one at a time, while the window remains usable.
class OrthophotoWriter {
  public:
    /// Starts requested orthophotos, and reports finished ones.
    void attend(Session& session, const PackageReader& package, double now);
    bool writes() const { return program_.has_value(); }

  private:
    std::string cannot_write() const;
    void start(Session& session, const PackageReader& package, double now);
    std::optional<ChildProgram> program_;
    std::string file_;
};

}  // namespace vantage
