// The player's saved settings. Checks that any content is accepted, and that values are within their bounds.
#include <cmath>
#include <cstdlib>

#include "player/window/remembered.h"
#include "tests/fuzz/support/fuzz_target.h"
#include "tests/fuzz/support/memory_file.h"

using namespace vantage;

FUZZ_TARGET(settings)(const std::uint8_t* data, std::size_t size) {
    static const fuzz::MemoryFolder folder;
    folder.set("player.json", fuzz::text_of(data, size));
    const Remembered r = read_settings(folder.path(), {});
    if (r.window.width < 320 || r.window.width > 16384 || r.settings.photos < 0 ||
        r.settings.photos_per_pass < 1 || !(r.settings.weights.sharpness >= 0.005) ||
        !(r.settings.weights.exponent <= 64) || !(r.settings.angle_limit >= 0))
        std::abort();
    return 0;
}
