#include "player/options/blending_options.h"

#include <map>
#include <string>

#include "cli/real_range.h"
#include "player/camera/shots.h"
#include "player/render/blend_table.h"
#include "points/point_cloud.h"
#include "scene/error.h"
#include "scene/package_shape.h"

namespace vantage {
namespace {

const char* const group = "Blending";

void add_choices(CLI::App& app, RenderSettings& r) {
    std::map<std::string, Blend> blends;
    std::string help;
    for (const BlendRow& row : blend_table()) {
        blends[row.name] = row.blend;
        help += (help.empty() ? "" : "; ") + std::string(row.name) + ": " + row.help;
    }
    app.add_option("--blend", r.blend, help)
        ->transform(CLI::CheckedTransformer(blends))
        ->default_str(blend_row(r.blend).name)
        ->group(group);
    app.add_option("--coordinates", r.coordinates,
                   "texture coordinates: auto (the package's effect), vertex, fragment")
        ->transform(
            CLI::CheckedTransformer(std::map<std::string, Coordinates>{{"auto", Coordinates::automatic},
                                                                       {"vertex", Coordinates::vertex},
                                                                       {"fragment", Coordinates::fragment}}))
        ->default_str("auto")
        ->group(group);
    app.add_option("--choose", r.choice,
                   "photos to blend: cover (each surface gets one that sees it, the best first), nearest")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, Choice>{{"cover", Choice::cover}, {"nearest", Choice::nearest}}))
        ->default_str("cover")
        ->group(group);
    app.add_option("--show", r.show,
                   "colors, or false colors: sources (which photo), coverage (how many photos)")
        ->transform(CLI::CheckedTransformer(std::map<std::string, Show>{
            {"colors", Show::colors}, {"sources", Show::sources}, {"coverage", Show::coverage}}))
        ->default_str("colors")
        ->group(group);
    app.add_option("--surroundings", r.surroundings,
                   "what photos show beside the mesh, if the package has it: on, dimmed, off")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, ShowSurroundings>{{"on", ShowSurroundings::on},
                                                    {"dimmed", ShowSurroundings::dimmed},
                                                    {"off", ShowSurroundings::off}}))
        ->default_str("on")
        ->group(group);
    app.add_option("--transparency", r.transparency,
                   "transparent surfaces: exact (sorted at each pixel), approximate (weighted sums: faster), "
                   "off (not shown)")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, Transparency>{{"exact", Transparency::exact},
                                                {"approximate", Transparency::approximate},
                                                {"off", Transparency::off}}))
        ->default_str("exact")
        ->group(group);
}

void add_sampling(CLI::App& app, RenderSettings& r) {
    app.add_option("--lod-bias", r.lod_bias, "coarser by this many levels of detail; negative: finer")
        ->check(real_range(-8.0, 16.0))
        ->capture_default_str()
        ->group(group);
    app.add_flag("!--bilinear", r.trilinear, "sample one level of detail instead of two")->group(group);
    app.add_option("--anisotropy", r.anisotropy,
                   "taps along the longer side of a sample's footprint, for surfaces slanted in the photo")
        ->check(CLI::Range(1, 16))
        ->capture_default_str()
        ->group(group);
    app.add_flag("--thumbnails", r.thumbnails, "use only thumbnails")->group(group);
    app.add_option("--photos-per-pass", r.photos_per_pass, "photos blended per pass")
        ->check(CLI::Range(1, most_photos_per_pass))
        ->capture_default_str()
        ->group(group);
}

void add_weights(CLI::App& app, RenderSettings& r) {
    app.add_option("--exponent", r.weights.exponent, "how strongly near photos are preferred")
        ->check(real_range(0.0, 64.0))
        ->capture_default_str()
        ->group(group);
    app.add_option("--sharpness", r.weights.sharpness,
                   "angle between rays, in radians, at which the weight is 1/e; smaller is sharper")
        ->check(real_range(0.005, 3.0))
        ->capture_default_str()
        ->group(group);
    app.add_flag("!--original-colors", r.refined_colors,
                 "photos as exposed, without gains and falloff; for comparison")
        ->group(group);
    app.add_flag("--consensus", r.consensus, "less weight for colors far from the mean of all photos")
        ->group(group);
    app.add_flag("--angle-per-photo", r.weights.angle_per_photo,
                 "weight by the angle between viewing directions, not between rays at the surface")
        ->group(group);
    const auto off = [&](const char* name, bool& weight, const char* help) {
        app.add_flag_callback(
               name, [&weight] { weight = false; }, help)
            ->group(group);
    };
    off("--no-distance", r.weights.distance, "disable the distance weight");
    off("--no-angle", r.weights.angle, "disable the angle weight");
    off("--no-angle-mask", r.weights.angle_mask, "disable the angle mask");
    off("--no-depth-mask", r.weights.depth_mask, "disable the depth mask");
    off("--no-border-mask", r.weights.border_mask, "disable the border mask");
    off("--no-consensus-mask", r.weights.consensus_mask,
        "disable the consensus mask: show what single photos show and others contradict");
}

}  // namespace

void add_blending_options(CLI::App& app, BlendingOptions& o) {
    app.add_option("--blended", o.photos,
                   "photos to blend; more if the view needs more to be covered; 0: all (default 4 in the "
                   "window, all for pictures)")
        ->check(CLI::Range(0, 1 << 20));
    app.add_option("--holes", o.holes,
                   "what no photo shows: transparent (default for pictures without surroundings) or shade")
        ->check(CLI::IsMember({"transparent", "shade"}));
    app.add_option("--exposure", o.exposure,
                   "show colors with this photo's exposure (default: the mean photo's, or from a photo's own "
                   "camera that photo's)");
    const CLI::IsMember switch_values({"auto", "on", "off"});
    app.add_option("--fov-normalization", o.fov_normalization,
                   "compare distances as if all fields of view were equal: auto, on, off")
        ->check(switch_values)
        ->capture_default_str();
    app.add_option("--fov-normalisation", o.fov_normalization)->check(switch_values)->group("");
    add_band_option(app, o.bands);
    add_choices(app, o.render);
    add_sampling(app, o.render);
    add_weights(app, o.render);
    app.parse_complete_callback([&app, &o] {
        for (const CLI::Option* option : app.get_options())
            o.given |= option->get_group() == group && option->count() > 0;
    });
}

RenderSettings render_settings(const PackageReader& package, const BlendingOptions& o, Purpose purpose) {
    RenderSettings r = o.render;
    r.weights.fov_normalization = o.fov_normalization == "auto"
                                      ? effect_on(package.scene(), Effect::fov_normalization)
                                      : o.fov_normalization == "on";
    r.bands = band_settings(package, o.bands);
    r.photos = o.photos >= 0 ? o.photos : (purpose == Purpose::pictures ? 0 : window_photos);
    if (!o.exposure.empty()) r.exposure = named_photos(package, {o.exposure}).front();
    const bool fills_frame =
        purpose == Purpose::window ||
        (effect_on(package.scene(), Effect::surroundings) && r.surroundings != ShowSurroundings::off);
    r.fill_holes = o.holes == "shade" || (o.holes.empty() && fills_frame);
    if (r.coordinates == Coordinates::vertex && !points_only(package.scene()) && !has_coordinates(package))
        throw Error(Exit::usage, package.path().string() +
                                     ": has no texture coordinates per vertex (--coordinates vertex); "
                                     "prepare it with --vertex-coordinates");
    return r;
}

}  // namespace vantage
