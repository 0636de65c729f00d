#include "tests/bench/measure/pictures.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/gl/context.h"
#include "player/measure/bench/flight.h"
#include "player/measure/evaluation/picture_metrics.h"
#include "tests/bench/measure/exhibit.h"
#include "tests/bench/measure/timing.h"

namespace vantage::bench {
namespace {

std::vector<bool> both(std::vector<bool> a, const std::vector<bool>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] && b[i];
    return a;
}

/// Draws frames of one view as a window does, and waits for each frame to finish.
class Frames {
  public:
    Frames(Renderer& renderer, const TrueView& view, const PictureSetting& s)
        : renderer_(renderer),
          view_(view.view),
          settings_(s.settings),
          photos_(view.photos),
          side_(s.timed_whole ? s.side : 1),
          target_(make_flight_target(frame_size(view_))) {
        settings_.loading = Loading::streamed;
        renderer.resources().trials = s.trials;
    }
    FrameReport draw() const {
        // Milliseconds are passed where seconds are expected, so that no photo is still fading in.
        const double now =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
                .count();
        const FrameReport report = renderer_.draw(view_, settings_, photos_, {0, side_}, now);
        renderer_.show(view_, settings_, {target_.framebuffer.id()});
        glFinish();
        return report;
    }

  private:
    Renderer& renderer_;
    const View& view_;
    RenderSettings settings_;
    std::vector<std::uint32_t> photos_;
    int side_;
    FlightTarget target_;
};

/// The PSNR of a picture against the exact picture over the pixels that are colored in both pictures. No
/// gains are applied.
double psnr_against(const Picture& exact, const Picture& picture, const TrueView& view) {
    const auto scored = both(both(scored_pixels(exact, 0), scored_pixels(picture, 0)), view.seeable);
    return std::min(psnr_cap, score(exact, picture, scored).psnr);
}

/// The index of the exact setting with which to compare a curve, from the same curve if possible;
/// settings.size() if no setting is exact.
std::size_t exact_of(std::span<const PictureSetting> settings, const std::string& curve) {
    std::size_t found = settings.size();
    for (std::size_t i = settings.size(); i-- > 0;)
        if (settings[i].exact) found = i;
    for (std::size_t i = settings.size(); i-- > 0;)
        if (settings[i].exact && settings[i].curve == curve) found = i;
    return found;
}

std::string caption(const PictureSetting& s) { return s.curve + ": " + s.setting; }

void keep_extremes(const BenchScene& scene, std::span<const PictureSetting> settings,
                   const std::vector<Picture>& firsts, const std::filesystem::path& folder,
                   const std::string& tag, std::vector<Measurement>& out) {
    const auto psnr = [&](std::size_t i) { return out[i].values.at("psnr"); };
    std::size_t worst = 0, chosen = settings.size();
    for (std::size_t i = 0; i < out.size(); ++i) {
        if (psnr(i) < psnr(worst)) worst = i;
        if (settings[i].chosen) chosen = i;
    }
    std::size_t exact = exact_of(settings, settings[worst].curve);
    if (exact == settings.size())  // fall back to the best
        exact = std::size_t(
            std::ranges::max_element(out, {}, [](const Measurement& m) { return m.values.at("psnr"); }) -
            out.begin());
    const Window window = worst_window(firsts[exact], firsts[worst]);
    const std::string name = scene.name + "-" + tag;
    out[exact].exhibits.push_back(
        keep_exhibit(folder, name + "-truth", "truth", scene.views.front().truth, window));
    const auto keep = [&](std::size_t i, const char* what) {
        out[i].exhibits.push_back(
            keep_exhibit(folder, name + "-" + what, caption(settings[i]), firsts[i], window));
    };
    keep(exact, "best");
    if (worst != exact) keep(worst, "worst");
    if (chosen < settings.size() && chosen != exact && chosen != worst) keep(chosen, "chosen");
}

}  // namespace

PictureErrors picture_errors(std::span<const TrueView> views, std::span<const Picture> pictures) {
    PictureErrors out;
    const double share = 1.0 / double(std::max<std::size_t>(1, views.size()));
    for (std::size_t v = 0; v < views.size(); ++v) {
        const TrueView& view = views[v];
        const auto scored =
            both(both(scored_pixels(pictures[v]), scored_pixels(view.truth, 0)), view.seeable);
        const PictureScore s = score(view.truth, pictures[v], scored);
        std::size_t seeable = 0, holes = 0;
        for (std::size_t i = 0; i < view.seeable.size(); ++i) {
            seeable += view.seeable[i];
            holes += view.seeable[i] && pictures[v].rgba[4 * i + 3] < 128;
        }
        out.psnr += share * std::min(psnr_cap, s.psnr_gain);
        out.ssim += share * s.ssim;
        out.worst += share * s.worst;
        out.uncolored += share * 100 * double(holes) / double(std::max<std::size_t>(1, seeable));
    }
    return out;
}

std::vector<Picture> render_views(Renderer& renderer, const BenchScene& scene, const PictureSetting& s) {
    RenderSettings settings = s.settings;
    settings.loading = Loading::complete;
    renderer.resources().trials = s.trials;
    std::vector<Picture> out;
    for (const TrueView& v : scene.views)
        out.push_back(take_picture(renderer, v.view, settings, v.photos, s.side));
    return out;
}

void settle(Renderer& renderer, const TrueView& view, const PictureSetting& s) {
    const Frames frames(renderer, view, s);
    for (int n = 0; n < 1000; ++n) {
        const FrameReport r = frames.draw();
        if (r.tiles_missing == 0 && r.photos == renderer.planner().frame().plan().photos.size()) return;
    }
}

double time_frame(Renderer& renderer, const TrueView& view, const PictureSetting& s) {
    settle(renderer, view, s);
    const Frames frames(renderer, view, s);
    // Samples are drawn one after another, and all take the same time.
    return milliseconds([&] { frames.draw(); }) * (s.timed_whole ? s.side * s.side : 1);
}

std::vector<Measurement> measure_pictures(const std::filesystem::path& file, const BenchScene& scene,
                                          const Effort& effort, std::span<const PictureSetting> settings,
                                          const std::filesystem::path& folder, const std::string& tag) {
    const PackageReader package(file);
    const gl::HeadlessContext context;
    Renderer renderer(package, ample_memory());
    std::vector<Measurement> out;
    std::vector<std::vector<Picture>> pictures;
    for (const PictureSetting& s : settings) {
        pictures.push_back(render_views(renderer, scene, s));
        const PictureErrors e = picture_errors(scene.views, pictures.back());
        double photos = 0;
        for (const Picture& p : pictures.back())
            photos += double(p.report.photos) / double(scene.views.size());
        out.push_back({"", "", s.curve, s.setting, s.exact, s.chosen, s.known, {}});
        out.back().values.merge(std::map<std::string, double>{{"psnr", e.psnr},
                                                              {"ssim", e.ssim},
                                                              {"worst", e.worst},
                                                              {"uncoloured", e.uncolored},
                                                              {"photos", photos}});
    }
    for (std::size_t i = 0; i < out.size(); ++i) {
        const std::size_t of = exact_of(settings, settings[i].curve);
        if (of == settings.size()) continue;
        const std::vector<Picture>& exact = pictures[of];
        double sum = 0;
        for (std::size_t v = 0; v < exact.size(); ++v)
            sum += psnr_against(exact[v], pictures[i][v], scene.views[v]);
        out[i].values["psnr_exact"] = sum / double(exact.size());
    }
    std::vector<Picture> firsts;
    for (const auto& p : pictures) firsts.push_back(p.front());
    keep_extremes(scene, settings, firsts, folder, tag, out);
    std::vector<std::size_t> timed;
    for (std::size_t i = 0; i < settings.size(); ++i)
        if (settings[i].timed) timed.push_back(i);
    const std::vector<double> ms = medians_in_turn(timed.size(), effort.repeats, [&](std::size_t i) {
        return time_frame(renderer, scene.views.front(), settings[timed[i]]);
    });
    for (std::size_t i = 0; i < timed.size(); ++i) out[timed[i]].values["frame_ms"] = ms[i];
    return out;
}

MemoryBudget ample_memory() { return {std::uint64_t(6) << 30, std::uint64_t(64) << 20}; }

}  // namespace vantage::bench
