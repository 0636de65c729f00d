#pragma once
#include "player/render/render_settings.h"
#include "scene/story/story.h"

namespace vantage {

/// The background of a story, in the form used for rendering.
PlainBackground plain_background_of(const StoryBackground& background);

}  // namespace vantage
