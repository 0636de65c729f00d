#include "player/commands/parse.h"

#include "scene/error.h"

namespace vantage {

std::optional<int> parse(CLI::App& app, int argc, char** argv) {
    try {
        app.parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : int(Exit::usage);
    }
}

}  // namespace vantage
