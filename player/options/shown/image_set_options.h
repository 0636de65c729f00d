#pragma once
#include <string>

#include "player/render/render_settings.h"
#include "scene/package/package_reader.h"

namespace vantage {

class Command;

/// The image sets to show.
struct ImageSetOptions {
    std::string image_set;  ///< empty: the default
    std::string second;     ///< NAME or NAME=SHARE; empty: none
    ImageSetView view = ImageSetView::mix;
    bool given() const { return !(image_set + second).empty(); }
};
/// --image-set.
void add_image_set_option(const Command& command, ImageSetOptions& options);
/// The options for a second image set.
void add_second_image_set_options(const Command& command, ImageSetOptions& options);

/// Throws Error(usage) for an unknown image set or an invalid share.
ImageSetSettings image_set_settings(const PackageReader& package, const ImageSetOptions& options);

}  // namespace vantage
