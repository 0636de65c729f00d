#include "player/tour/story_background.h"

#include "base/values/srgb.h"

namespace vantage {
namespace {

std::array<float, 3> light_of(const StoryColor& color) {
    const auto& linear = linear_of_srgb_byte();
    return {float(linear[color[0]]), float(linear[color[1]]), float(linear[color[2]])};
}

}  // namespace

PlainBackground plain_background_of(const StoryBackground& b) {
    return {light_of(b.top), light_of(b.bottom), b.soft_edges};
}

}  // namespace vantage
