#include <cstdio>
#include <optional>
#include <string_view>

#include "player/measure/bench.h"
#include "player/measure/evaluate.h"
#include "player/offscreen.h"
#include "player/options.h"
#include "player/verify/verify.h"
#include "player/window.h"
#include "scene/error.h"
#include "scene/lost_package.h"

namespace {

void list_photos(const vantage::PackageReader& package) {
    for (const vantage::package::PhotoRecord& p : package.photos())
        std::printf("%s  %ux%u  sees %.1f %% of the vertices%s\n", p.name, p.width, p.height,
                    100 * p.visible_vertices, p.flags & vantage::package::photo_held_out ? "  held out" : "");
}

/// Empty where the program is to go on.
std::optional<int> parse(CLI::App& app, int argc, char** argv) {
    try {
        app.parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : int(vantage::Exit::usage);
    }
}

int bench(int argc, char** argv) {
    using namespace vantage;
    CLI::App app{"vantage-player bench flies scripted paths and measures every frame."};
    BenchOptions options;
    add_bench_options(app, options);
    if (const auto code = parse(app, argc, argv)) return *code;
    return run_bench(PackageReader(options.player.package), options);
}

int evaluate(int argc, char** argv) {
    using namespace vantage;
    CLI::App app{
        "vantage-player evaluate leaves each photo out in turn and compares it with what the others make of "
        "it."};
    EvaluateOptions options;
    add_evaluate_options(app, options);
    if (const auto code = parse(app, argc, argv)) return *code;
    return run_evaluate(PackageReader(options.player.package), options);
}

int verify(int argc, char** argv) {
    using namespace vantage;
    CLI::App app{"vantage-player verify compares what packages show with pictures that were stored of them."};
    VerifyOptions options;
    add_verify_options(app, options);
    if (const auto code = parse(app, argc, argv)) return *code;
    return run_verify(options);
}

int play(int argc, char** argv) {
    using namespace vantage;
    CLI::App app{"vantage-player shows a prepared package: a scanned object through its own photos."};
    app.set_version_flag("--version", "vantage-player " VANTAGE_VERSION);
    Options options;
    add_options(app, options);
    if (const auto code = parse(app, argc, argv)) return *code;
    for (const CLI::Option* option : app.get_options())
        options.blending_given |= option->get_group() == "Blending" && option->count() > 0;
    const PackageReader package(options.package);
    package.meta();  // not needed to show it, but damage is said
    if (options.list) return list_photos(package), 0;
    return options.offscreen ? run_offscreen(package, options) : run_window(package, options);
}

}  // namespace

int main(int argc, char** argv) {
    using vantage::Exit;
    vantage::name_lost_packages("vantage-player");
    const std::string_view command = argc > 1 ? argv[1] : "";
    try {
        if (command == "bench") return bench(argc - 1, argv + 1);
        if (command == "evaluate") return evaluate(argc - 1, argv + 1);
        if (command == "verify") return verify(argc - 1, argv + 1);
        return play(argc, argv);
    } catch (const vantage::Error& e) {
        std::fprintf(stderr, "vantage-player: %s\n", e.what());
        return int(e.code());
    } catch (const std::exception& e) {
        std::fprintf(stderr, "vantage-player: %s\n", e.what());
        return int(Exit::graphics);
    }
}
