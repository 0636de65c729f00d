#include <cstdio>
#include <string_view>

#include "player/commands/commands.h"
#include "scene/error.h"
#include "scene/lost_package.h"

namespace {

int run(int argc, char** argv) {
    const std::string_view verb = argc > 1 ? argv[1] : "";
    if (verb == "bench") return vantage::bench_command(argc - 1, argv + 1);
    if (verb == "evaluate") return vantage::evaluate_command(argc - 1, argv + 1);
    if (verb == "verify") return vantage::verify_command(argc - 1, argv + 1);
    return vantage::show_command(argc, argv);
}

/// Prints the exception being handled. Returns its exit code.
int report_exception() {
    try {
        throw;
    } catch (const vantage::Error& e) {
        std::fprintf(stderr, "vantage-player: %s\n", e.what());
        return int(e.code());
    } catch (const std::exception& e) {
        std::fprintf(stderr, "vantage-player: %s\n", e.what());
        return int(vantage::Exit::graphics);
    }
}

}  // namespace

int main(int argc, char** argv) {
    vantage::name_lost_packages("vantage-player");
    try {
        return run(argc, argv);
    } catch (...) {
        return report_exception();
    }
}
