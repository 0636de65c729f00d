#include "player/options/shown/blending_options.h"

#include <string>

#include "base/cli/command.h"
#include "base/text/error.h"
#include "player/render/passes/blend_table.h"
#include "player/view/shots.h"
#include "scene/package/contents/point_cloud.h"
#include "scene/package/package_shape.h"

namespace vantage {

void add_blending_options(const Command& c, BlendingOptions& o) {
    std::vector<std::pair<std::string, Blend>> blends;
    std::string help;
    for (const BlendRow& row : blend_table()) {
        blends.emplace_back(row.name, row.blend);
        help += (help.empty() ? "" : "; ") + std::string(row.name) + ": " + row.help;
    }
    RenderSettings& r = o.render;
    c.choice("--blend", r.blend, blends, help).group(blending_group);
    c.choice("--coordinates", r.coordinates,
             {{"auto", Coordinates::automatic},
              {"vertex", Coordinates::vertex},
              {"fragment", Coordinates::fragment}},
             "texture coordinates: auto (the package's effect), vertex, fragment")
        .group(blending_group);
    c.text("--exposure", o.exposure,
           "show colors with this photo's exposure (default: the mean exposure; from a photo's own camera, "
           "the exposure of that photo)")
        .type("PHOTO")
        .group(blending_group);
    c.flag("--original-colors", r.refined_colors,
           "original colors, without gains and vignetting correction; for comparison", false)
        .group(blending_group);
    c.flag("--thumbnails", r.thumbnails, "use only the coarsest levels of photos").group(blending_group);
    add_image_set_option(c, o.image_sets);
}

void add_blended_option(const Command& c, BlendingOptions& o) {
    c.integer("--max-photos", o.photos, 0, 1 << 20,
              "number of photos to blend, or more if necessary to cover the view; 0: all (default 4 in the "
              "window, all for pictures)")
        .group(blending_group);
}

void add_holes_option(const Command& c, BlendingOptions& o) {
    c.choice("--holes", o.holes, {"transparent", "shade"},
             "surfaces without photos: transparent (default for pictures without a background) or shade")
        .group(blending_group);
}

void add_background_option(const Command& c, BlendingOptions& o) {
    c.choice("--background", o.render.background,
             {{"on", ShowBackground::on}, {"dimmed", ShowBackground::dimmed}, {"off", ShowBackground::off}},
             "photographed background, if the package has one")
        .group(blending_group);
}

void add_transparency_option(const Command& c, BlendingOptions& o) {
    c.choice("--transparency", o.render.transparency,
             {{"exact", Transparency::exact},
              {"approximate", Transparency::approximate},
              {"off", Transparency::off}},
             "transparent surfaces: exact (sorted at each pixel), approximate (weighted sums: faster), off "
             "(not shown)")
        .group(blending_group);
}

RenderSettings render_settings(const PackageReader& package, const BlendingOptions& o, Purpose purpose) {
    RenderSettings r = o.render;
    r.weights.fov_normalization = effect_on(package.scene(), Effect::fov_normalization);
    r.image_sets = image_set_settings(package, o.image_sets);
    r.plain_background = plain_background_of(package.scene());
    r.photos = o.photos >= 0 ? o.photos : (purpose == Purpose::pictures ? 0 : window_photos);
    if (!o.exposure.empty()) r.exposure = named_photos(package, {o.exposure}).front();
    const bool fills_frame = purpose == Purpose::window || (effect_on(package.scene(), Effect::background) &&
                                                            r.background != ShowBackground::off);
    r.fill_holes = o.holes == "shade" || (o.holes.empty() && fills_frame);
    if (r.coordinates == Coordinates::vertex && !points_only(package.scene()) && !has_coordinates(package))
        throw Error(Exit::usage, package.path().string() +
                                     ": has no texture coordinates per vertex (--coordinates vertex); "
                                     "prepare it with --vertex-coordinates");
    return r;
}

}  // namespace vantage
