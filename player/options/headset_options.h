#pragma once

namespace vantage {

class Command;

struct HeadsetOptions {
    double unit_meters = 0;  ///< a scene unit; 0: as the measurements say, or else unknown
};
void add_headset_options(const Command& command, HeadsetOptions& options);

}  // namespace vantage
