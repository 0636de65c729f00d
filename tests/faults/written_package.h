#pragma once
#include <string>
#include <vector>

#include "tests/programs/overnight.h"

namespace vantage {

/// A command that writes a package, with its inputs in `inputs` and its output in `out`.
struct WritingCommand {
    std::string name, words;
    std::string before, after;  ///< the package before and after the command; empty if there is none
};

/// Commands on a small scene: a first preparation, a preparation that updates a package, a merge and a
/// refinement.
class WrittenPackage : public Overnight {
  protected:
    const fs::path out = dir / "out", package = out / "scene.vantage";

    void SetUp() override;
    /// Restores the output folder to its state before the command.
    void start(const WritingCommand& c) const;
    /// Runs the command with `fault`, which sets the environment variables that faulty_disk.cpp reads. If
    /// `fault` is empty, the command runs without faults.
    Outcome run_command(const WritingCommand& c, const std::string& fault = "") const;
    /// Expects the old or the new package; the package may be missing only if there was none before.
    void expect_old_or_new(const WritingCommand& c, const std::string& when) const;
    /// Runs the command again, without faults, and expects the new package.
    void expect_finished_by_next_run(const WritingCommand& c, const std::string& when) const;

    std::vector<WritingCommand> commands;
};

}  // namespace vantage
