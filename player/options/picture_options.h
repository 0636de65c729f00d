#pragma once
#include <string>

namespace vantage {

class Command;

/// Pictures without a display.
struct PictureOptions {
    bool offscreen = false;
    std::string view;  ///< see parse_view
    std::string path;  ///< file, see read_path
    double scale = 1;
    bool panorama = false;  ///< of all directions
    int samples = 0;        ///< per side of a pixel; 0: depends on what is shown
};
void add_picture_options(const Command& command, PictureOptions& options);

}  // namespace vantage
