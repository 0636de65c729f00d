#include "player/measure/bench/smoothness.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "base/cli/progress_line.h"
#include "base/cli/standard_output.h"
#include "base/files/make_folder.h"
#include "base/files/replace_file.h"
#include "base/files/side_by_side.h"
#include "base/gl/context.h"
#include "base/text/error.h"
#include "base/text/formatted.h"
#include "base/text/json_text.h"
#include "base/values/quantile.h"
#include "player/measure/bench/plot.h"

namespace vantage {
namespace {

RenderSettings shown_settings(const PackageReader& package, const SmoothnessOptions& o) {
    RenderSettings settings = render_settings(package, o.blending, Purpose::window);
    settings.loading = o.fades ? Loading::repeatable : Loading::complete;
    settings.points.show = false;  // colors are compared on the mesh
    settings.transparency = Transparency::off;
    return settings;
}

/// Median distance of the surfaces in the photos, used for views from a file, because the distances of their
/// targets are unknown.
double usual_distance(const PackageReader& package) {
    std::vector<double> distances;
    for (const package::PhotoRecord& p : package.photos())
        if (p.seen_distance > 0) distances.push_back(p.seen_distance);
    return distances.empty() ? 1 : quantile(std::move(distances), 0.5);
}

std::vector<Navigation> path_of(const PackageReader& package, const SmoothnessOptions& o) {
    const std::uint32_t image_set = image_set_settings(package, o.blending.image_sets).shown;
    const std::vector<std::uint32_t> photos = o.package.photos.empty()
                                                  ? photos_in_use(package, o.package, image_set)
                                                  : named_photos(package, o.package.photos);
    std::vector<Navigation> path =
        in_steps(o.path.empty() ? photo_stops(package, photos)
                                : recorded_stops(o.path, package, usual_distance(package)),
                 o.step * std::numbers::pi / 180);
    if (path.size() < 2)
        throw Error(Exit::input, (o.path.empty() ? package.path().string() : o.path) +
                                     ": a path with one view, expected at least two views");
    return path;
}

std::vector<std::uint32_t> planned_photos(const Renderer& renderer) {
    std::vector<std::uint32_t> out = numbers_of(renderer.planner().frame().plan().photos);
    std::ranges::sort(out);
    return out;
}

/// Draws the path's first view until no photo is fading.
void settle(Renderer& renderer, const View& view, const RenderSettings& settings,
            const std::vector<std::uint32_t>& photos) {
    constexpr int most = 60;
    for (int i = 0; i < most; ++i)
        if (renderer.draw(view, settings, photos, {}, (i - most) * frame_seconds).settled && i > 1) return;
}

/// Keeps the largest steps, largest first.
void keep_worst(std::vector<ShownStep>& shown, int most, std::size_t frame, const ColorStep& step,
                const SeenFrame& now, const SeenFrame& then) {
    const auto at = std::ranges::find_if(shown, [&](const ShownStep& s) { return s.patches < step.p99; });
    if (at == shown.end() && shown.size() >= std::size_t(most)) return;
    shown.insert(at, {frame, step.p99, picture_of(now), picture_of(then)});
    if (shown.size() > std::size_t(most)) shown.pop_back();
}

void write_steps(const std::filesystem::path& file, const std::vector<FrameStep>& steps) {
    std::ostringstream out;
    out << "frame,degrees,mean,p99,max,compared,photos,photos_changed,tiles_missing\n";
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const FrameStep& s = steps[i];
        out << i << ',' << s.color.degrees << ',' << s.color.mean << ',' << s.color.p99 << ',' << s.color.max
            << ',' << s.color.compared << ',' << s.photos << ',' << s.changed << ',' << s.tiles_missing
            << '\n';
    }
    replace_file(file, out.view());
}

std::size_t frames_with_tiles_missing(const std::vector<FrameStep>& steps) {
    return std::size_t(std::ranges::count_if(steps, [](const FrameStep& s) { return s.tiles_missing > 0; }));
}

nlohmann::json json_of(const Smoothness& s, const std::vector<FrameStep>& steps) {
    const auto of = [](const FrameStatistics& f, double per_degree) {
        return nlohmann::json{{"mean", f.mean}, {"p99", f.p99}, {"max", f.max}, {"per_degree", per_degree}};
    };
    return {{"steps", steps.size()},
            {"degrees", s.degrees},
            {"picture", of(s.mean, s.mean_per_degree)},
            {"patches", of(s.patches, s.patches_per_degree)},
            {"worst_frame", s.worst},
            {"frames_with_tiles_missing", frames_with_tiles_missing(steps)}};
}

void write_pictures(const std::filesystem::path& folder, const std::vector<ShownStep>& shown) {
    for (const ShownStep& s : shown) {
        const std::string name = formatted("step-%05zu.png", s.frame);
        write_png(folder / name, {3 * s.now.width,
                                  s.now.height,
                                  side_by_side(s.now.rgba, s.then.rgba, std::size_t(s.now.width)),
                                  {}});
    }
}

void plot(const std::filesystem::path& file, const std::vector<FrameStep>& steps) {
    Curve mean{"picture", {}}, patches{"worst 1 % of the picture", {}};
    for (const FrameStep& s : steps) {
        mean.values.push_back(s.color.mean);
        patches.values.push_back(s.color.p99);
    }
    write_plot(file, "change in the surface's color from frame to frame", "gray levels", {mean, patches});
}

void print(const Smoothness& s, const std::vector<FrameStep>& steps) {
    const auto row = [](const char* name, const FrameStatistics& f, double per_degree) {
        std::fprintf(text_output(),
                     "%-24s mean %6.3f  99 %% %6.3f  max %6.3f gray levels per frame  %6.3f per degree\n",
                     name, f.mean, f.p99, f.max, per_degree);
    };
    row("picture", s.mean, s.mean_per_degree);
    row("worst 1 % of the picture", s.patches, s.patches_per_degree);
    std::fprintf(text_output(), "%.1f degrees around the surface; worst after frame %zu\n", s.degrees,
                 s.worst);
    if (const std::size_t n = frames_with_tiles_missing(steps))
        std::fprintf(text_output(),
                     "%zu frames lacked tiles, because tiles are damaged or --graphics-memory is too small\n",
                     n);
}

}  // namespace

Smoothness smoothness_of(const std::vector<FrameStep>& steps) {
    std::vector<double> mean, patches;
    Smoothness out;
    double means = 0, worst_parts = 0;
    for (const FrameStep& s : steps) {
        mean.push_back(s.color.mean);
        patches.push_back(s.color.p99);
        out.degrees += s.color.degrees;
        means += s.color.mean;
        worst_parts += s.color.p99;
    }
    out.mean = frame_statistics(mean);
    out.patches = frame_statistics(patches);
    if (out.degrees > 0) {
        out.mean_per_degree = means / out.degrees;
        out.patches_per_degree = worst_parts / out.degrees;
    }
    out.worst = std::size_t(std::ranges::max_element(patches) - patches.begin());
    return out;
}

std::vector<FrameStep> fly_in_steps(const PackageReader& package, const SmoothnessOptions& o,
                                    const std::vector<Navigation>& path, FrameSize size,
                                    std::vector<ShownStep>& shown) {
    const std::vector<std::uint32_t> photos = photos_in_use(package, o.package);
    const RenderSettings settings = shown_settings(package, o);
    Renderer renderer(package, memory_budget(o.memory));
    settle(renderer, view_of(path.front(), size.width, size.height), settings, photos);
    std::vector<FrameStep> steps;
    SeenFrame now;
    std::vector<std::uint32_t> drawn;
    ProgressLine progress(ProgressStyle::automatic, 10);
    for (std::size_t i = 0; i < path.size(); ++i) {
        const View view = view_of(path[i], size.width, size.height);
        const FrameReport report = renderer.draw(view, settings, photos, {}, double(i) * frame_seconds);
        SeenFrame next = seen_frame(renderer, view);
        std::vector<std::uint32_t> next_drawn = planned_photos(renderer), changed;
        if (i > 0) {
            RenderSettings weighted = settings;
            weighted.weights_from = view;
            renderer.redraw(now.view, weighted);
            const SeenFrame then = seen_frame(renderer, now.view);
            std::ranges::set_symmetric_difference(drawn, next_drawn, std::back_inserter(changed));
            steps.push_back({color_step(renderer.scene(), now, then, next), next_drawn.size(), changed.size(),
                             report.tiles_missing});
            keep_worst(shown, o.worst, i - 1, steps.back().color, now, then);
        }
        now = std::move(next);
        drawn = std::move(next_drawn);
        progress.show({"frames", "", i + 1, path.size()});
    }
    return steps;
}

int run_smoothness(const PackageReader& package, const SmoothnessOptions& o) {
    const FrameSize size = o.output.size.empty() ? FrameSize{640, 360} : parse_size(o.output.size);
    const std::vector<Navigation> path = path_of(package, o);
    make_folder(o.folder);
    const gl::HeadlessContext context;
    std::fprintf(text_output(), "%s, %dx%d, %zu frames\n", gl::current_device().renderer.c_str(), size.width,
                 size.height, path.size());
    std::fflush(text_output());
    std::vector<ShownStep> shown;
    const std::vector<FrameStep> steps = fly_in_steps(package, o, path, size, shown);
    const Smoothness s = smoothness_of(steps);
    print(s, steps);
    write_steps(o.folder / "steps.csv", steps);
    const nlohmann::json summary = json_of(s, steps);
    replace_file(o.folder / "summary.json", json_text(summary) + "\n");
    results().update(summary);
    results()["folder"] = o.folder.string();
    plot(o.folder / "steps.svg", steps);
    write_pictures(o.folder, shown);
    return int(Exit::ok);
}

}  // namespace vantage
