#include "player/verify/verify.h"

#include "cli/real_range.h"
#include "player/commands/commands.h"
#include "player/commands/parse.h"

namespace vantage {

void add_verify_options(CLI::App& app, VerifyOptions& o) {
    app.add_option("FILES", o.packages, "packages")->type_name("PACKAGE")->required();
    app.add_option("--golden", o.golden,
                   "folder with views.path and the stored pictures; for several packages, the folder of "
                   "these folders")
        ->type_name("FOLDER")
        ->required();
    app.add_flag("--update", o.update, "store the pictures, and views if there are none");
    app.add_option("--size", o.size, "size of the pictures, in pixels")
        ->type_name("WIDTHxHEIGHT")
        ->capture_default_str();
    app.add_option("--tolerance", o.tolerance, "gray levels by which a pixel may differ")
        ->check(CLI::Range(0, 255))
        ->capture_default_str();
    app.add_option("--share", o.share, "share of the pixels that may differ by more")
        ->check(real_range(0.0, 1.0))
        ->capture_default_str();
    app.add_option("-o,--output", o.differences, "folder for pictures of differences")
        ->type_name("FOLDER")
        ->capture_default_str();
    app.add_option("--junit", o.junit, "write a JUnit file for CI")->type_name("FILE");
    app.add_flag("--json", o.json, "machine-readable output");
    app.footer(
        "views.path holds one view per line, as recorded by the window and read by --path.\n"
        "Examples:\n"
        "  vantage-player verify chapel.vantage --golden golden/chapel --update\n"
        "  vantage-player verify chapel.vantage --golden golden/chapel\n"
        "  vantage-player verify shelf/*.vantage --golden golden --junit pictures.xml   (shelf/a.vantage "
        "with golden/a)\n"
        "Exit code, the first that applies to any package: 3 unreadable, 4 damaged, 10 different; 0 "
        "otherwise.");
}

int verify_command(int argc, char** argv) {
    CLI::App app{"vantage-player verify compares renderings of packages with stored pictures."};
    VerifyOptions options;
    add_verify_options(app, options);
    if (const auto code = parse(app, argc, argv)) return *code;
    return run_verify(options);
}

}  // namespace vantage
