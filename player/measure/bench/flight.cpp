#include "player/measure/bench/flight.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <functional>

#include "base/gl/context.h"
#include "player/composition/enlargement.h"
#include "player/composition/object_set.h"
#include "player/measure/bench/frame_timer.h"
#include "player/measure/bench/touched_texels.h"
#include "player/options/frame_goal.h"
#include "player/render/timing/pace.h"
#include "scene/package/contents/first_photo.h"

namespace vantage {
namespace {

using Clock = std::chrono::steady_clock;

/// Loads all data that the path needs, as far as memory allows.
void preload(ObjectSet& objects, const CameraPath& path, FrameSize size, RenderSettings settings,
             const std::vector<std::uint32_t>& photos) {
    settings.loading = Loading::complete;
    for (const Navigation& n : path.frames)
        objects.draw(view_of(n, size.width, size.height), settings, photos, {}, 0);
}

/// Draws a frame at `now` seconds, and shows it.
using DrawAndShow = std::function<void(const View& view, const RenderSettings& settings, double now)>;

/// Duration of a frame at rest, in milliseconds. It is measured after a coarse frame, as in a window that
/// shows its first picture.
double time_at_rest(const View& view, RenderSettings settings, FrameTimer& timer, const DrawAndShow& draw) {
    double ms = 0;
    for (int i = 0; i < 4; ++i) {
        const View drawn = i == 0 ? scaled(view, coarse_pace.scale) : view;
        settings.reduced = i == 0 && coarse_pace.reduced;
        timer.begin();
        draw(drawn, settings, i * frame_seconds);
        ms = timer.end();
    }
    return ms;
}

RenderSettings flight_settings(const PackageReader& package, const FlightOptions& o) {
    RenderSettings settings = render_settings(package, o.blending, Purpose::window);
    settings.points = point_settings(o.points);
    settings.fill_holes = true;
    settings.loading = Loading::streamed;
    settings.upload_bytes = o.memory.upload_bytes();
    return settings;
}

/// The view expected a quarter of a second after frame `i` if the motion continues; empty if the path jumps.
std::optional<View> expected_view(const CameraPath& path, int i, int jump, FrameSize size) {
    if (i == 0 || i == jump) return {};
    const Navigation& before = path.frames[std::size_t(i) - 1];
    return view_of(between(before, path.frames[std::size_t(i)], 8), size.width, size.height);
}

/// The process's memory, excluding the records of the measurement itself.
ProcessMemory memory_without(std::size_t records) {
    ProcessMemory memory = process_memory();
    memory.resident -= records * sizeof(FrameRecord);
    memory.anonymous -= records * sizeof(FrameRecord);
    return memory;
}

/// Records the number of frames and the time from frame `first` until the picture was exact.
void note_exact(Flight& flight, int first) {
    flight.frames_to_exact = int(flight.frames.size()) - 1 - first;
    for (auto f = std::size_t(first); f < flight.frames.size(); ++f)
        flight.ms_to_exact += flight.frames[f].ms;
}

}  // namespace

std::vector<double> frame_times(const Flight& f) {
    std::vector<double> ms;
    for (const FrameRecord& r : f.frames) ms.push_back(r.ms);
    return ms;
}

FlightTarget make_flight_target(FrameSize size) {
    FlightTarget t{size, gl::make_texture_2d("bench", GL_RGBA8, size.width, size.height), {}};
    t.framebuffer = gl::make_framebuffer("bench", std::array{t.color.id()}, 0);
    return t;
}

CameraPath path_named(const std::string& name, const PackageReader& package, const FlightOptions& o,
                      int repeat) {
    const int frames = o.minutes > 0 ? 1 << 20 : o.frames;
    if (std::filesystem::is_regular_file(name)) return recorded_path(name, package, frames);
    const std::uint32_t image_set = image_set_settings(package, o.blending.image_sets).shown,
                        first = o.package.photos.empty() ? first_photo(package, image_set)
                                                         : named_photos(package, o.package.photos).front();
    return scripted_path(name, home_of(package, first), frames, unsigned(repeat) + 1);
}

Flight fly(const PackageReader& package, const FlightOptions& o, const CameraPath& path,
           const std::string& mode, int repeat, const FlightTarget& target) {
    for (const SceneObject& object : o.scene)
        if (!o.warm) drop_from_page_cache(object.package);
    const std::vector<std::uint32_t> photos = photos_in_use(package, o.package);
    RenderSettings settings = flight_settings(package, o);
    const FrameSize size = target.size;
    settings.capacity = size;
    Renderer renderer(package, memory_budget(o.memory));
    ObjectSet objects(renderer, o.scene, memory_budget(o.memory));
    objects.use_trials({.whole_photos = mode == "whole"});
    if (mode == "resident") preload(objects, path, size, settings, photos);
    Flight flight{path.name, mode, repeat, {}};
    flight.frames.reserve(path.frames.size());
    FrameTimer timer(gl::current_device().software);
    Enlargement enlargement;
    enlargement.fit(size);
    const double goal = mode == "adaptive" ? frame_goal(o.fps) : 0;
    Pacing pacing;
    if (goal > 0) {
        const View first = view_of(path.frames[0], size.width, size.height);
        const auto draw = [&](const View& drawn, const RenderSettings& s, double now) {
            objects.draw(drawn, s, photos, {}, now);
            enlargement.show(objects, drawn, s, size, {target.framebuffer.id()});
        };
        pacing.pace = first_pace(time_at_rest(first, settings, timer, draw), goal);
    }
    renderer.resources().pass_clock.start();
    const auto begin = Clock::now();
    const std::chrono::duration<double, std::ratio<60>> minutes(o.minutes);
    const int frames = int(path.frames.size()), jump = path.name == "jump" ? frames / 2 : -1;
    const int stays_from = path.name == "still" ? 0 : jump;  // the view stays the same from there
    StreamedSoFar before;
    for (int i = 0; i < frames; ++i) {
        if (o.minutes > 0 && Clock::now() - begin > minutes) break;
        if (i == stays_from) before = objects.streamed();
        const double now = 1 + i * frame_seconds;
        const Pace pace = pacing.pace;
        const Navigation& camera = path.frames[std::size_t(i)];
        const View view = scaled(view_of(camera, size.width, size.height), pace.scale);
        const std::vector<View> eyes = views_of(o.stereo, view, (camera.target - camera.eye).norm());
        std::optional<View> next = expected_view(path, i, jump, size);
        if (next) next = scaled(*next, pace.scale);
        settings.reduced = pace.reduced;
        timer.begin();
        const auto show = [&](std::size_t eye) {
            enlargement.show(objects, eyes[eye], settings, size, {target.framebuffer.id(), false, eye});
        };
        const FrameReport report =
            objects.draw_eyes({eyes, settings, photos, {}, now, next ? &*next : nullptr}, show);
        const double ms = timer.end();
        gl::check("drawing a frame");
        flight.frames.push_back(
            {ms, pace.scale, report, gl::memory_held(), memory_without(flight.frames.size())});
        pacing = next_pacing(pacing, pace, ms, goal);
        const bool exact = objects.size() == 1 && report.tiles_missing == 0 &&
                           report.photos == renderer.planner().frame().plan().photos.size();
        if (stays_from >= 0 && i > stays_from && flight.frames_to_exact < 0 && exact) {
            note_exact(flight, stays_from);
            flight.streamed_to_exact = objects.streamed() - before;
            flight.touched_bytes = touched_bytes(renderer, view, settings, photos, now);
            if (o.until_exact) break;
        }
    }
    flight.pass_ms = renderer.resources().pass_clock.finish();
    flight.streamed = objects.streamed();
    flight.graphics_budget = objects.graphics_budget();
    return flight;
}

}  // namespace vantage
