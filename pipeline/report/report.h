#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "pipeline/prepare/prepare.h"
#include "pipeline/run/trace.h"
#include "scene/package_reader.h"

namespace vantage {

/// What is known of the run that made a package, beside the package.
struct ReportRun {
    PrepareResult prepared;
    std::vector<Trace::Span> spans;
    double seconds = 0, memory_mb = 0;
};

/// Writes one self-contained HTML page about a package: whether it is complete, the effects with their
/// evidence, how much of the model how many photos see, each photo with its masks, warnings, and where the
/// time went. Throws Error(storage).
void write_report(const std::filesystem::path& file, const PackageReader& package,
                  const std::optional<ReportRun>& run);

}  // namespace vantage
