#include <csignal>

#include "base/cli/report_exception.h"
#include "base/files/large_pages.h"
#include "player/verbs/verbs.h"
#include "scene/package/lost_package.h"

int main(int argc, char** argv) {
    vantage::use_large_pages();
    std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the file size limit fails with a message
    vantage::name_lost_packages("vantage-player");
    return vantage::run_reported("vantage-player", [&] {
        return vantage::player_command().run({argv + 1, argv + argc});
    });
}
