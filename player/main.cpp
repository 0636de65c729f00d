#include <malloc.h>

#include <csignal>

#include "cli/report_exception.h"
#include "player/commands/commands.h"
#include "scene/lost_package.h"

int main(int argc, char** argv) {
    // A software renderer allocates each draw's vertices: given back to the kernel every time, they cost as
    // much as drawing a small frame.
    mallopt(M_TRIM_THRESHOLD, 128 << 20);
    std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the file size limit fails with a message
    vantage::name_lost_packages("vantage-player");
    try {
        return vantage::player_command().run({argv + 1, argv + argc});
    } catch (...) {
        return vantage::report_exception("vantage-player");
    }
}
