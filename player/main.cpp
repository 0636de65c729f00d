#include <malloc.h>

#include <array>
#include <csignal>
#include <string>
#include <string_view>

#include "cli/report_exception.h"
#include "player/commands/commands.h"
#include "scene/lost_package.h"

namespace {

/// Prints a line for each verb and one for the program.
void describe(char* program, char* option) {
    for (const vantage::Verb& v : vantage::verbs) {
        std::string name = v.name;
        std::array words{name.data(), option};
        v.command(int(words.size()), words.data());
    }
    std::array words{program, option};
    vantage::show_command(int(words.size()), words.data());
}

int run(int argc, char** argv) {
    const std::string_view verb = argc > 1 ? argv[1] : "";
    if (verb == "--describe") return describe(argv[0], argv[1]), 0;
    for (const vantage::Verb& v : vantage::verbs)
        if (verb == v.name) return v.command(argc - 1, argv + 1);
    return vantage::show_command(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
    // A software renderer allocates each draw's vertices: given back to the kernel every time, they cost as
    // much as drawing a small frame.
    mallopt(M_TRIM_THRESHOLD, 128 << 20);
    std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the file size limit fails with a message
    vantage::name_lost_packages("vantage-player");
    try {
        return run(argc, argv);
    } catch (...) {
        return vantage::report_exception("vantage-player");
    }
}
