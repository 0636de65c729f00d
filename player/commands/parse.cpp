#include "player/commands/parse.h"

#include "cli/describe.h"
#include "scene/error.h"

namespace vantage {

std::optional<int> parse(CLI::App& app, int argc, char** argv) {
    if (describe_if_asked(app, argc, argv)) return int(Exit::ok);
    try {
        app.parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : int(Exit::usage);
    }
}

}  // namespace vantage
