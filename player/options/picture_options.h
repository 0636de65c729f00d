#pragma once
#include <string>

namespace vantage {

class Command;

/// Views and quality of pictures.
struct PictureOptions {
    std::string view;  ///< see parse_view
    std::string path;  ///< file, see read_path
    double scale = 1;
    bool panorama = false;  ///< covers all directions
    int samples = 0;        ///< per side of a pixel; 0: depends on the content
    bool legend = true;     ///< legend of a scalar field, in sufficiently large pictures
};
void add_view_option(const Command& command, PictureOptions& options);
void add_path_option(const Command& command, PictureOptions& options, const std::string& help);
void add_samples_option(const Command& command, PictureOptions& options);
void add_legend_option(const Command& command, PictureOptions& options);
/// --scale and --panorama.
void add_picture_options(const Command& command, PictureOptions& options);

}  // namespace vantage
