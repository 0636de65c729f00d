#include "pipeline/align/settle_turns.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/text/photo_names.h"
#include "pipeline/align/open_turns.h"

namespace vantage {
namespace {

constexpr std::size_t max_names = 20;  ///< in a warning

/// The wrong orientation of a photo that must still be turned by the EXIF `orientation`, as a phrase for
/// messages.
const char* lies(int orientation) {
    if (orientation == 3) return "upside down";
    return orientation == 6 || orientation == 8 ? "turned by 90 degrees" : "mirrored";
}

/// Adds one warning for all photos that have the same EXIF orientation. `found`: whether the photos are known
/// to be turned the wrong way.
void warn_of_turns(SceneInput& scene, const std::vector<std::uint32_t>& photos, bool found) {
    std::map<std::pair<int, int>, std::vector<std::string>> names;  // by orientation and its open turn
    for (const std::uint32_t i : photos) {
        const PhotoInput& p = scene.photos[i];
        names[{p.orientation, p.open_turn}].push_back(p.name);
    }
    for (const auto& [how, of] : names) {
        const auto [orientation, open] = how;
        const char* taken =
            orientation == open ? "the pixels are used as stored" : "turned as the file states";
        const char* but = !found                ? ""
                          : orientation == open ? ", but the cameras refer to the photos as displayed"
                                                : ", but the pixels had already been turned";
        scene.warnings.push_back(fmt::format(
            "{}{} relative to the cameras, {}: {}; {}{} (EXIF orientation {})", found ? "" : "perhaps ",
            lies(open), found ? "as neighboring photos show" : "neighboring photos are inconclusive",
            first_of(of, max_names), taken, but, orientation));
    }
}

}  // namespace

void settle_turns(SceneInput& scene, unsigned threads) {
    OpenTurns turns = find_open_turns(scene.photos, {.threads = threads});
    std::vector<std::string> displayed;
    std::erase_if(turns.found, [&](std::uint32_t i) {
        PhotoInput& p = scene.photos[i];
        const bool turns_by_size = p.open_turn >= 5 && p.decoded.width != p.decoded.height;
        if (turns_by_size) take_as_displayed(p), displayed.push_back(p.name);
        return turns_by_size;
    });
    if (!displayed.empty())
        scene.warnings.push_back(
            fmt::format("turned by their EXIF orientation, because their cameras "
                        "have no size and agree with neighboring photos only then: {}",
                        first_of(displayed, max_names)));
    warn_of_turns(scene, turns.found, true);
    warn_of_turns(scene, turns.unknown, false);
}

}  // namespace vantage
