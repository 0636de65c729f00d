#pragma once
#include <string>

namespace vantage {

class Command;

/// A video along --turntable, --tour or PictureOptions::path.
struct VideoOptions {
    bool turntable = false;
    double arc = 360;        ///< degrees, for the turntable
    std::string tour;        ///< id or title; empty: none
    double seconds = 0;      ///< 0: the duration of the tour or path; 12 for a turntable
    double frame_rate = 30;  ///< per second
};
void add_video_options(const Command& command, VideoOptions& options);

}  // namespace vantage
