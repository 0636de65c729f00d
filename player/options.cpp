#include "player/options.h"

#include "cli/real_range.h"

namespace vantage {
namespace {

void add_blending(CLI::App& app, RenderSettings& r) {
    const std::string group = "Blending";
    app.add_option("--blend", r.blend,
                   "lumigraph: by the angle between the rays to viewer and photo, fading at borders; "
                   "average: by distance, angle and all masks; best: each point from one photo")
        ->transform(CLI::CheckedTransformer(std::map<std::string, Blend>{
            {"average", Blend::average}, {"lumigraph", Blend::lumigraph}, {"best", Blend::best}}))
        ->default_str("lumigraph")
        ->group(group);
    app.add_option("--coordinates", r.coordinates,
                   "texture coordinates: auto (as the package says), vertex, fragment")
        ->transform(
            CLI::CheckedTransformer(std::map<std::string, Coordinates>{{"auto", Coordinates::automatic},
                                                                       {"vertex", Coordinates::vertex},
                                                                       {"fragment", Coordinates::fragment}}))
        ->default_str("auto")
        ->group(group);
    app.add_option("--lod-bias", r.lod_bias, "levels of detail coarser, or finer where negative")
        ->check(real_range(-8.0, 16.0))
        ->capture_default_str()
        ->group(group);
    app.add_flag("!--bilinear", r.trilinear, "each sample from one level of detail instead of two")
        ->group(group);
    app.add_option("--anisotropy", r.anisotropy,
                   "taps along a sample's longer side where a photo sees the surface at a slant")
        ->check(CLI::Range(1, 16))
        ->capture_default_str()
        ->group(group);
    app.add_flag("--half-float", r.half_sums, "sums of a pass in half precision")->group(group);
    app.add_flag("--thumbnails", r.thumbnails, "nothing finer than thumbnails")->group(group);
    app.add_option("--photos-per-pass", r.photos_per_pass, "photos blended at once")
        ->check(CLI::Range(1, most_photos_per_pass))
        ->capture_default_str()
        ->group(group);
    app.add_option("--exponent", r.weights.exponent, "how strongly near photos are preferred")
        ->check(real_range(0.0, 64.0))
        ->capture_default_str()
        ->group(group);
    app.add_option("--sharpness", r.weights.sharpness,
                   "radians between rays at which a photo counts 1/e; smaller is sharper")
        ->check(real_range(0.005, 3.0))
        ->capture_default_str()
        ->group(group);
    app.add_flag("!--original-colors", r.refined_colors,
                 "photos as they were exposed, not made to agree; to compare")
        ->group(group);
    app.add_flag("--consensus", r.consensus, "what disagrees with the mean of all counts less")->group(group);
    app.add_option(
           "--choose", r.choice,
           "photos to blend: cover (every surface gets one that sees it, the best first), nearest, "
           "direction (those that look as the viewer does), normals (and more against what they leave)")
        ->transform(CLI::CheckedTransformer(std::map<std::string, Choice>{{"cover", Choice::cover},
                                                                          {"nearest", Choice::nearest},
                                                                          {"direction", Choice::direction},
                                                                          {"normals", Choice::normals}}))
        ->default_str("cover")
        ->group(group);
    app.add_option("--show", r.show,
                   "colors, or as false colours: sources (which photo), coverage (how many)")
        ->transform(CLI::CheckedTransformer(std::map<std::string, Show>{
            {"colors", Show::colors}, {"sources", Show::sources}, {"coverage", Show::coverage}}))
        ->default_str("colors")
        ->group(group);
    app.add_flag("--angle-per-photo", r.weights.angle_per_photo,
                 "weigh by the angle between viewing directions, not between rays at the surface")
        ->group(group);
    const auto off = [&](const char* name, bool& weight, const char* help) {
        app.add_flag_callback(
               name, [&weight] { weight = false; }, help)
            ->group(group);
    };
    off("--no-distance", r.weights.distance, "switch the distance weight off");
    off("--no-angle", r.weights.angle, "switch the angle weight off");
    off("--no-angle-mask", r.weights.angle_mask, "switch the angle mask off");
    off("--no-depth-mask", r.weights.depth_mask, "switch the depth mask off");
    off("--no-border-mask", r.weights.border_mask, "switch the border mask off");
    off("--no-consensus-mask", r.weights.consensus_mask,
        "switch the consensus mask off: show what single photos show and others contradict");
}

}  // namespace

void add_options(CLI::App& app, Options& o) {
    app.add_option("FILE", o.package, "the package to show")->required();
    app.add_flag("--list", o.list, "name the photos and leave");
    app.add_option("--exclude", o.exclude, "photos that are not blended")->delimiter(',');
    app.add_option("--size", o.size,
                   "WIDTHxHEIGHT of window or pictures (default 1280x720, or the photo's size)");
    app.add_option("--samples", o.samples,
                   "samples along a pixel's side (default 1 in the window and from a photo's own camera at "
                   "full size, else 2)")
        ->check(CLI::Range(1, 8));
    app.add_option("--holes", o.holes, "what no photo shows: transparent (default offscreen) or shade")
        ->check(CLI::IsMember({"transparent", "shade"}));
    app.add_option("--fov-normalisation", o.fov_normalisation,
                   "compare distances as if all fields of view were one: auto, on, off")
        ->check(CLI::IsMember({"auto", "on", "off"}))
        ->capture_default_str();
    app.add_option("--exposure", o.exposure,
                   "show colours as this photo was exposed (else as the mean photo, and from a photo's own "
                   "camera as that one)");
    const std::string pictures = "Pictures without a display";
    app.add_flag("--offscreen", o.offscreen, "render to PNG instead of opening a window")->group(pictures);
    app.add_option("--photo", o.photos, "from this photo's own camera; several, or 'all'")
        ->delimiter(',')
        ->group(pictures);
    app.add_option("--view", o.view, "from EX,EY,EZ towards TX,TY,TZ, perhaps with a vertical field of view")
        ->group(pictures);
    app.add_option("--path", o.path, "a file of views, one a line as for --view")->group(pictures);
    app.add_option("--scale", o.scale, "picture size as a share of the photo's")
        ->check(real_range(0.001, 8.0))
        ->capture_default_str()
        ->group(pictures);
    app.add_option("-o,--output", o.out, "PNG file, or folder for several pictures")->group(pictures);
    app.add_flag("-q,--quiet", o.quiet, "no word unless something is wrong")->group(pictures);
    app.add_option("--blended", o.photos_blended,
                   "photos to blend, more where the view needs more to be covered; 0: all (default 4 in the "
                   "window, all for pictures)")
        ->check(CLI::Range(0, 1 << 20));
    app.add_option("--graphics-memory", o.graphics_mib,
                   "MiB of graphics memory to keep to (default by the size of the window)")
        ->check(CLI::Range(16u, 1u << 20));
    app.add_option("--memory", o.ring_mib, "MiB of memory that tiles pass through on their way")
        ->check(CLI::Range(1u, 4096u))
        ->capture_default_str();
    const std::string window = "Window";
    app.add_option("--upload", o.upload_kib, "KiB that a frame uploads at most")
        ->check(CLI::Range(256u, 1u << 22))
        ->capture_default_str()
        ->group(window);
    app.add_option("--frames", o.frames, "close after this many frames")
        ->check(CLI::Range(0, 1 << 30))
        ->group(window);
    app.add_flag("--fresh", o.fresh, "start with the defaults, and remember nothing")->group(window);
    app.add_option("--controls", o.controls,
                   "keep in this file where each control is, for scripts: name, x, y, width, height")
        ->group(window);
    app.add_option("--screenshot", o.screenshot, "save the last frame before closing")->group(window);
    add_blending(app, o.render);
    app.footer(
        "Examples:\n"
        "  vantage-player chapel.vantage\n"
        "  vantage-player chapel.vantage --offscreen --photo 0003 -o 0003.png\n"
        "  vantage-player chapel.vantage --offscreen --photo all --scale 0.5 --blend best -o pictures\n"
        "  vantage-player chapel.vantage --offscreen --view 4,-9,2,0,0,1,40 --size 1920x1080 -o view.png\n"
        "  vantage-player bench --help, evaluate --help, verify --help\n"
        "Exit codes: 0 well, 2 usage, 3 input, 4 damaged package, 6 storage, 7 graphics.");
}

}  // namespace vantage
