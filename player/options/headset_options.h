#pragma once

namespace vantage {

class Command;

struct HeadsetOptions {
    double unit_meters = 0;  ///< meters per scene unit; 0: from the measurements, otherwise unknown
};
void add_headset_options(const Command& command, HeadsetOptions& options);

}  // namespace vantage
