#pragma once
#include <string>

#include "player/options/shown/image_set_options.h"
#include "player/render/render_settings.h"
#include "scene/package/package_reader.h"

namespace vantage {

class Command;

/// Which photos to blend, and how.
struct BlendingOptions {
    RenderSettings render;
    int photos = -1;  ///< number of photos to blend; -1: default, 0: all
    std::string holes, exposure;
    ImageSetOptions image_sets;
    bool given = false;  ///< an option of blending_group was on the command line
};
inline constexpr const char* blending_group = "Blending";
/// The common options of commands that draw photos, with --image-set.
void add_blending_options(const Command& command, BlendingOptions& options);
void add_blended_option(const Command& command, BlendingOptions& options);
void add_holes_option(const Command& command, BlendingOptions& options);
void add_background_option(const Command& command, BlendingOptions& options);
void add_transparency_option(const Command& command, BlendingOptions& options);

/// Determines defaults: a window blends few photos and shades holes; pictures blend all photos and have
/// transparent holes.
enum class Purpose { window, pictures };

/// The settings from the options, completed with the package's effects and defaults. Throws Error(usage) for
/// an unknown photo.
RenderSettings render_settings(const PackageReader& package, const BlendingOptions& options, Purpose purpose);

}  // namespace vantage
