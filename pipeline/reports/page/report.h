#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "pipeline/prepare/prepare.h"
#include "pipeline/run/trace.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Data about the run that wrote a package.
struct ReportRun {
    PrepareResult prepared;
    std::vector<Trace::Span> spans;
    double seconds = 0, memory_mb = 0;
};

/// Writes a self-contained HTML page about a package. The page shows completeness, warnings, effects with
/// their evidence, coverage of the model, and each photo with its weight maps. If `run` is given, it also
/// shows the stages and their times. Throws Error(storage), or Error(damaged) if META cannot be parsed.
void write_report(const std::filesystem::path& file, const PackageReader& package,
                  const std::optional<ReportRun>& run);

}  // namespace vantage
