#include "pipeline/commands/shared/run_program.h"

#include <csignal>
#include <new>
#include <opencv2/core.hpp>

#include "base/cli/command.h"
#include "base/cli/report_exception.h"
#include "base/text/error.h"
#include "pipeline/commands/commands.h"
#include "scene/package/lost_package.h"

namespace vantage {
namespace {

int run_verb(int argc, char** argv) {
    const Command program(
        "vantage", "Prepares a scanned mesh and its calibrated photos into one package for vantage-player.");
    program.version("vantage " VANTAGE_VERSION);
    program.notes(
        "Examples:\n"
        "  vantage prepare scans/chapel -o chapel.vantage\n"
        "  vantage check --deep chapel.vantage\n" +
        exit_codes_text());
    for (const auto add : all_commands) add(program);
    try {
        return program.run({argv + 1, argv + argc});
    } catch (const cv::Exception& e) {
        if (e.code == cv::Error::StsNoMem) throw std::bad_alloc();
        throw;
    }
}

}  // namespace

int run_program(int argc, char** argv) {
    // Our own threads process the photos. OpenCV's threads would compete with our own, and OpenCV's pool
    // blocks indefinitely if the system cannot start a thread.
    cv::setNumThreads(1);
    std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the file size limit fails with a message
    name_lost_packages("vantage");
    return run_reported("vantage", [&] { return run_verb(argc, argv); });
}

}  // namespace vantage
