#include "player/verbs/verbs.h"

namespace vantage {

Command player_command() {
    const Command program("vantage-player",
                          "Shows a prepared package: a scanned object through its own photos.");
    program.version("vantage-player " VANTAGE_VERSION);
    for (const auto add : {add_window, add_kiosk, add_headset, add_render, add_video, add_orthophoto,
                           add_list, add_evaluate, add_verify, add_bench, add_smoothness})
        add(program);
    return program;
}

}  // namespace vantage
