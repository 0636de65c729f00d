// vantage-bench: measures what accuracy costs in time and bytes.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "scene/error.h"
#include "tests/bench/run.h"

int main(int argc, char** argv) {
    using namespace vantage;
    CLI::App app("vantage-bench measures what each level of accuracy costs and reports it as an HTML page.");
    bench::RunOptions options;
    bench::add_run_options(app, options);
    try {
        app.parse(argc, argv);
        return bench::run(options);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? int(Exit::ok) : int(Exit::usage);
    } catch (const Error& e) {
        std::fprintf(stderr, "vantage-bench: %s\n", e.what());
        return int(e.code());
    } catch (const std::exception& e) {
        std::fprintf(stderr, "vantage-bench: %s\n", e.what());
        return 1;
    }
}
