#include "player/interface/state/user_input.h"

#include <algorithm>

namespace vantage {

bool take_key(UserInput& input, int key) {
    const auto is = [&](const KeyPress& p) { return p.key == key && p.with == KeyPress::With::nothing; };
    const auto at = std::ranges::find_if(input.keys, is);
    if (at == input.keys.end()) return false;
    input.keys.erase(at);
    return true;
}

}  // namespace vantage
