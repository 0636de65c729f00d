#include "pipeline/commands/run_program.h"

#include <csignal>
#include <cstdlib>  // defines __GLIBC__
#include <new>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <opencv2/core.hpp>

#include "cli/command.h"
#include "cli/report_exception.h"
#include "pipeline/commands/commands.h"
#include "scene/error.h"
#include "scene/lost_package.h"

namespace vantage {
namespace {

/// Makes glibc reuse one photo's buffers for the next: returned to the system, they would have to be mapped
/// and zeroed again, page by page.
void keep_freed_memory() {
#ifdef __GLIBC__
    ::mallopt(M_ARENA_MAX, 1);
    ::mallopt(M_MMAP_THRESHOLD, 1 << 30);
    ::mallopt(M_TRIM_THRESHOLD, 2147483647);
#endif
}

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
    keep_freed_memory();
    // Photos are divided among our own threads. OpenCV's would compete with them, and its pool waits forever
    // for a thread that the system refuses to start.
    cv::setNumThreads(1);
    std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the file size limit fails with a message
    name_lost_packages("vantage");
    try {
        return run_verb(argc, argv);
    } catch (...) {
        return report_exception("vantage");
    }
}

}  // namespace vantage
