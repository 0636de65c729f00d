#include <string_view>

#include "cli/report_exception.h"
#include "player/commands/commands.h"
#include "scene/lost_package.h"

namespace {

int run(int argc, char** argv) {
    const std::string_view verb = argc > 1 ? argv[1] : "";
    if (verb == "bench") return vantage::bench_command(argc - 1, argv + 1);
    if (verb == "evaluate") return vantage::evaluate_command(argc - 1, argv + 1);
    if (verb == "verify") return vantage::verify_command(argc - 1, argv + 1);
    return vantage::show_command(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
    vantage::name_lost_packages("vantage-player");
    try {
        return run(argc, argv);
    } catch (...) {
        return vantage::report_exception("vantage-player");
    }
}
