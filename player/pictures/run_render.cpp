#include "player/pictures/run_render.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "base/cli/progress_line.h"
#include "base/cli/standard_output.h"
#include "base/files/make_folder.h"
#include "base/files/png_rows.h"
#include "base/gl/context.h"
#include "base/text/error.h"
#include "player/composition/object_set.h"
#include "player/composition/panorama_picture.h"
#include "player/composition/stereo_picture.h"
#include "player/options/tiles_not_shown.h"
#include "player/pictures/picture_file.h"
#include "player/pictures/picture_legend.h"
#include "player/render/picture.h"
#include "player/survey/survey.h"
#include "player/view/shots.h"
#include "scene/package/output_file.h"
#include "scene/package/package_inputs.h"
#include "shaders/contract.h"

namespace vantage {
namespace {

std::vector<Shot> shots(const PackageReader& package, const ShowOptions& options) {
    const PictureOptions& o = options.pictures;
    std::optional<FrameSize> size;
    if (!options.output.size.empty()) size = parse_size(options.output.size);
    std::vector<Shot> out;
    const std::vector<std::string> stems = package.photo_stems();
    for (const std::uint32_t p : named_photos(package, options.package.photos))
        out.push_back(photo_shot(package.photos()[p], stems[p], size, o.scale));
    FrameSize frame = size.value_or(FrameSize{1280, 720});
    if (!size && o.scale != 1)
        frame = {std::max(1, int(std::lround(1280 * o.scale))), std::max(1, int(std::lround(720 * o.scale)))};
    if (!o.view.empty()) {
        auto [view, distance] = parse_view_and_distance(o.view, package, frame);
        out.push_back({.name = "view", .view = std::move(view), .distance = distance});
    }
    if (!o.path.empty())
        for (Shot& shot : read_path(o.path, package, frame)) out.push_back(std::move(shot));
    if (out.empty()) throw Error(Exit::usage, "render: expected --photo, --view or --path");
    return out;
}

/// A mono panorama includes the metadata that identify it to viewers; GPano has no field for stereo.
void write_picture(const std::filesystem::path& file, const Picture& picture, const ShowOptions& o) {
    if (!o.pictures.panorama || o.stereo.mode != StereoMode::off) return write_png(file, picture);
    PngRows out(file, picture.width, picture.height, panorama_xmp({picture.width, picture.height}));
    const std::size_t row = 4 * std::size_t(picture.width);
    for (std::size_t at = 0; at < picture.rgba.size(); at += row)
        out.add(std::span(picture.rgba).subspan(at, row));
    out.finish();
}

/// The files for all pictures, with links resolved. Throws Error(usage) if one of them must not be replaced,
/// or if two pictures have the same name.
std::vector<std::filesystem::path> picture_files(const PackageReader& package, const ShowOptions& o,
                                                 const std::vector<Shot>& shots) {
    Inputs inputs = inputs_of(package);
    if (!o.pictures.path.empty()) inputs.files.emplace_back(o.pictures.path);
    std::vector<std::filesystem::path> out;
    std::set<std::string> names;
    for (const Shot& shot : shots) {
        if (!names.insert(shot.name).second)
            throw Error(Exit::usage,
                        shot.name + ".png: two pictures have this name; render them in two runs");
        out.push_back(output_file(picture_file(o.output.file, shot.name, shots.size()), Product::png, inputs,
                                  o.output.force));
    }
    return out;
}

double colored_share(const Picture& p) {
    std::size_t colored = 0;
    for (std::size_t i = 3; i < p.rgba.size(); i += 4) colored += p.rgba[i] > 0;
    return p.rgba.empty() ? 0 : 4.0 * double(colored) / double(p.rgba.size());
}

std::string consisted_of(const FrameReport& r) {
    return "  " + std::to_string(r.photos) + " photos in " + std::to_string(r.passes) + " passes  " +
           std::to_string(r.tiles) + " tiles" +
           (r.tiles_missing ? " (" + std::to_string(r.tiles_missing) + " missing)" : "");
}

/// Renders a panorama for one or two eyes.
Picture panorama_of(ObjectSet& scene, StereoPicture& stereo, const PackageReader& package, const Shot& shot,
                    const PictureSpec& spec, const ShowOptions& o) {
    const FrameSize size = o.output.size.empty() ? FrameSize{4096, 2048} : parse_size(o.output.size);
    const Panorama middle = panorama_at(shot.view, up_of(package.scene()), size);
    if (o.stereo.mode == StereoMode::off) return take_panorama(scene, middle, spec);
    RenderSettings settings = spec.settings;
    settings.loading = Loading::sparing;  // hundreds of views need nearly the same tiles
    const StereoPanorama panorama =
        stereo_panorama(middle, eye_distance(o.stereo.eyes, shot.distance),
                        nearest_around(scene.meshes(), middle.eye, shot.distance));
    ProgressLine progress(ProgressStyle::automatic, 10);
    return take_stereo_panorama(scene, stereo, o.stereo.mode, panorama, {settings, spec.photos, spec.side},
                                [&](std::size_t done, std::size_t count) {
                                    progress.show({"slices", "", done, count});
                                });
}

/// Prints the values at the ends of the color map, if a field was shown.
void print_legend(const Renderer& renderer, const RenderSettings& settings) {
    const ScalarField* const field = renderer.resources().fields.shown(settings);
    if (!field) return;
    const auto [map, range, center] = field_legend(*field, settings.field);
    std::fprintf(text_output(), "field %s  %s to %s, %s%s\n", field->name.c_str(),
                 value_text(range.low, range).c_str(), value_text(range.high, range).c_str(), name_of(map),
                 settings.field.logarithmic ? ", logarithmic" : "");
}

}  // namespace

int run_render(const PackageReader& package, const ShowOptions& options,
               const std::vector<SceneObject>& objects) {
    const PictureOptions& o = options.pictures;
    if (o.scale != 1 && !options.output.size.empty())
        throw Error(Exit::usage, "--scale and --size: expected one of them");
    if (o.panorama && options.stereo.mode == StereoMode::checkerboard)
        throw Error(Exit::usage,
                    "--panorama with --stereo checkerboard: expected over-under, side-by-side or anaglyph");
    const std::vector<Shot> wanted = shots(package, options);
    const std::vector<std::filesystem::path> files = picture_files(package, options, wanted);
    const std::vector<std::uint32_t> photos = photos_in_use(package, options.package);
    RenderSettings settings = render_settings(package, options.blending, Purpose::pictures);
    settings.field = field_settings(package, options.field);
    settings.light = light_settings(options.light);
    settings.points = point_settings(options.points);
    const gl::HeadlessContext context;
    Renderer renderer(package, memory_budget(options.memory));
    ObjectSet scene(renderer, objects, memory_budget(options.memory));
    const bool own_pixels = o.scale == 1 && options.output.size.empty() && o.view.empty() && o.path.empty();
    const int side = o.samples ? o.samples : own_pixels ? 1 : 2;
    StereoPicture stereo;
    const auto picture_of_shot = [&](const Shot& shot) {
        if (o.panorama)
            return panorama_of(scene, stereo, package, shot, {settings, photos, o.samples ? o.samples : 1},
                               options);
        const std::vector<View> eyes = views_of(options.stereo, shot.view, shot.distance);
        return take_picture(scene, stereo, options.stereo.mode, eyes, {settings, photos, side});
    };
    PictureLegend legend;
    TilesNotShown lacking;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const Shot& shot = wanted[i];
        const std::filesystem::path& file = files[i];
        const auto start = std::chrono::steady_clock::now();
        if (shot.image_set && !options.blending.image_sets.given())
            settings.image_sets.shown = *shot.image_set;
        Picture picture = picture_of_shot(shot);
        const double colored = colored_share(picture);
        if (o.legend && !o.panorama && options.stereo.mode == StereoMode::off)
            if (const ScalarField* field = renderer.resources().fields.shown(settings))
                legend.draw(picture, *field, settings.field);
        if (i == 0) print_legend(renderer, settings);
        if (file.has_parent_path()) make_folder(file.parent_path());
        write_picture(file, picture, options);
        const double s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const FrameReport& r = picture.report;
        lacking.add(r);
        std::fprintf(text_output(), "%s  %dx%d%s  %.3f %% colored  %.2f s\n", file.c_str(), picture.width,
                     picture.height, o.panorama ? "" : consisted_of(r).c_str(), 100 * colored, s);
        results()["pictures"].push_back({{"file", file.string()},
                                         {"width", picture.width},
                                         {"height", picture.height},
                                         {"photos", r.photos},
                                         {"passes", r.passes},
                                         {"tiles", r.tiles},
                                         {"tiles_missing", r.tiles_missing},
                                         {"colored", colored},
                                         {"seconds", s}});
        if (r.fragments_approximated > 0)
            std::fprintf(stderr,
                         "vantage-player: %s: %zu of %zu transparent fragments are approximated, because "
                         "they exceed the memory or the limit of %d per pixel\n",
                         file.c_str(), r.fragments_approximated, r.fragments, shader::max_sorted_fragments);
        std::fflush(text_output());
    }
    return exit_for(package, lacking);
}

}  // namespace vantage
