#pragma once
#include <string>

namespace vantage {

/// The exit codes of both programs (Exit), for the end of --help. Each program returns some of them.
inline std::string exit_codes_text() {
    return "Exit codes: 0 success, 2 usage, 3 input, 4 damaged package, 5 stale package, 6 storage,\n"
           "7 graphics, 8 interrupted, 9 incomplete, 10 different, 11 internal error, 12 out of memory,\n"
           "13 mesh not in view.";
}

}  // namespace vantage
