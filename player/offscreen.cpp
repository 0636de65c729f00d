#include "player/offscreen.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "gl/context.h"
#include "player/render/picture.h"
#include "player/shots.h"
#include "scene/error.h"
#include "scene/make_folder.h"

namespace vantage {
namespace {

std::vector<Shot> shots(const PackageReader& package, const Options& o) {
    std::optional<FrameSize> size;
    if (!o.size.empty()) size = parse_size(o.size);
    std::vector<Shot> out;
    for (const std::uint32_t p : named_photos(package, o.photos))
        out.push_back(photo_shot(package.photos()[p], size, o.scale));
    FrameSize frame = size.value_or(FrameSize{1280, 720});
    if (!size && o.scale != 1)
        frame = {std::max(1, int(std::lround(1280 * o.scale))), std::max(1, int(std::lround(720 * o.scale)))};
    if (!o.view.empty()) out.push_back({"view", parse_view(o.view, package, frame)});
    if (!o.path.empty())
        for (Shot& shot : read_path(o.path, package, frame)) out.push_back(std::move(shot));
    if (out.empty()) throw Error(Exit::usage, "--offscreen needs --photo, --view or --path");
    return out;
}

/// One PNG for one picture, unless the output is a folder; a folder for several.
std::filesystem::path picture_file(const Options& o, const std::string& name, std::size_t count) {
    const std::filesystem::path out = o.out.empty() ? (count == 1 ? name + ".png" : ".") : o.out;
    if (count == 1 && out.extension() == ".png" && !std::filesystem::is_directory(out)) return out;
    make_folder(out);
    return out / (name + ".png");
}

double seen_share(const Picture& p) {
    std::size_t seen = 0;
    for (std::size_t i = 3; i < p.rgba.size(); i += 4) seen += p.rgba[i] > 0;
    return p.rgba.empty() ? 0 : 4.0 * double(seen) / double(p.rgba.size());
}

}  // namespace

std::vector<std::uint32_t> photos_in_use(const PackageReader& package, const Options& o) {
    const std::vector<std::uint32_t> out = named_photos(package, o.exclude);
    std::vector<std::uint32_t> photos;
    for (std::uint32_t p = 0; p < package.photos().size(); ++p)
        if (std::find(out.begin(), out.end(), p) == out.end()) photos.push_back(p);
    return photos;
}

RenderSettings render_settings(const PackageReader& package, const Options& o) {
    RenderSettings r = o.render;
    r.weights.fov_normalisation = o.fov_normalisation == "auto"
                                      ? effect_on(package.scene(), Effect::fov_normalization)
                                      : o.fov_normalisation == "on";
    r.photos = o.photos_blended >= 0 ? o.photos_blended : (o.offscreen ? 0 : window_photos);
    if (!o.exposure.empty()) r.exposure = named_photos(package, {o.exposure}).front();
    r.fill_holes = o.holes == "shade" || (o.holes.empty() && !o.offscreen);
    return r;
}

MemoryBudget memory_budget(const Options& o) {
    constexpr std::uint64_t MiB = std::uint64_t(1) << 20;
    return {std::uint64_t(o.graphics_mib) * MiB, std::uint64_t(o.ring_mib) * MiB};
}

int run_offscreen(const PackageReader& package, const Options& o) {
    const std::vector<Shot> wanted = shots(package, o);
    const std::vector<std::uint32_t> photos = photos_in_use(package, o);
    const RenderSettings settings = render_settings(package, o);
    const gl::HeadlessContext context;
    Renderer renderer(package, memory_budget(o));
    const bool own_pixels = o.scale == 1 && o.size.empty() && o.view.empty() && o.path.empty();
    const int side = o.samples ? o.samples : own_pixels ? 1 : 2;
    std::size_t damaged = 0;
    for (const Shot& shot : wanted) {
        const auto start = std::chrono::steady_clock::now();
        const Picture picture = take_picture(renderer, shot.view, settings, photos, side);
        const auto file = picture_file(o, shot.name, wanted.size());
        write_png(file, picture);
        const double s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const FrameReport& r = picture.report;
        damaged = r.tiles_damaged;
        if (!o.quiet)
            std::printf("%s  %dx%d  %zu photos in %zu passes  %zu tiles%s  %.3f %% coloured  %.2f s\n",
                        file.c_str(), picture.width, picture.height, r.photos, r.passes, r.tiles,
                        r.tiles_missing ? (" (" + std::to_string(r.tiles_missing) + " missing)").c_str() : "",
                        100 * seen_share(picture), s);
        std::fflush(stdout);
    }
    if (!damaged) return int(Exit::ok);
    std::fprintf(
        stderr,
        "vantage-player: %s: %zu tiles have a wrong checksum and were left out (see vantage check --deep)\n",
        package.path().c_str(), damaged);
    return int(Exit::damaged);
}

}  // namespace vantage
