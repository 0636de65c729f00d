#pragma once

#include "player/view/stereo.h"

namespace vantage {

class Command;

void add_stereo_options(const Command& command, StereoSettings& stereo);

}  // namespace vantage
