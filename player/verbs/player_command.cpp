#include "player/verbs/verbs.h"

namespace vantage {

Command player_command() {
    const Command program("vantage-player",
                          "Shows a prepared package: a scanned object through its own photos.");
    program.version("vantage-player " VANTAGE_VERSION);
    for (const auto add : {add_show, add_bench, add_evaluate, add_orthophoto, add_smoothness, add_verify})
        add(program);
    return program;
}

}  // namespace vantage
