#include "player/pictures/run_video.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/cli/progress_line.h"
#include "base/cli/standard_output.h"
#include "base/cli/stop_signals.h"
#include "base/files/make_folder.h"
#include "base/gl/context.h"
#include "base/text/error.h"
#include "player/composition/stereo_picture.h"
#include "player/options/tiles_not_shown.h"
#include "player/pictures/flight_frames.h"
#include "player/pictures/frame_files.h"
#include "player/pictures/picture_file.h"
#include "player/pictures/picture_legend.h"
#include "player/pictures/video_encoder.h"
#include "player/render/picture.h"
#include "player/tour/story_background.h"
#include "player/tour/story_views.h"
#include "scene/package/output_file.h"
#include "scene/package/package_inputs.h"
#include "scene/story/story_file.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

/// Size of each eye's picture.
FrameSize size_of_eye(const ShowOptions& o) {
    return o.output.size.empty() ? FrameSize{1280, 720} : parse_size(o.output.size);
}
FrameSize size_of_frame(const ShowOptions& o) { return stereo_size(o.stereo.mode, size_of_eye(o)); }

/// Destination of frames: one file, or one per frame.
struct Output {
    fs::path video;  ///< empty: `frames`
    std::vector<fs::path> frames;
};

/// Throws Error(usage) if a file must not be replaced or if no output is given.
Output output_of(const PackageReader& package, const ShowOptions& o, std::size_t count) {
    const fs::path out = o.output.file;
    if (out.empty()) throw Error(Exit::usage, "video: expected -o with FILE.mp4, FILE.webm or a folder");
    Inputs inputs = inputs_of(package);
    if (!o.pictures.path.empty()) inputs.files.emplace_back(o.pictures.path);
    if (const fs::path story = story_file_of(o.package.file); !story.empty()) inputs.files.push_back(story);
    if (is_video_file(out)) return {output_file(out, Product::video, inputs, o.output.force), {}};
    expect_folder_name(out, "FILE.mp4, FILE.webm or a folder");
    const std::string name = fs::path(o.package.file).stem().string();
    return {{}, frame_files(out, name, count, inputs, o.output.force)};
}

/// Renders frames one after the other.
class Frames {
  public:
    Frames(const PackageReader& package, const ShowOptions& o, const std::vector<SceneObject>& objects,
           const Story& story)
        : renderer_(package, memory_budget(o.memory)),
          objects_(renderer_, objects, memory_budget(o.memory)),
          stereo_(o.stereo),
          photos_(photos_in_use(package, o.package)),
          side_(o.pictures.samples ? o.pictures.samples : 2) {
        settings_ = render_settings(package, o.blending, Purpose::pictures);
        settings_.fill_holes = o.blending.holes != "transparent";
        settings_.field = field_settings(package, o.field);
        settings_.light = light_settings(o.light);
        settings_.points = point_settings(o.points);
        renderer_.hide(hidden_balls(story, input_axes(package)));
        if (story.background) settings_.plain_background = plain_background_of(*story.background);
        if (story.only_object) settings_.background = ShowBackground::off;
        has_legend_ = o.pictures.legend && stereo_.mode == StereoMode::off;
        // If only some photos are blended, the selection changes between frames, so photos fade in and out as
        // in the window.
        settings_.loading = settings_.photos == 0 ? Loading::complete : Loading::repeatable;
    }
    /// `now`: seconds since the first frame.
    Picture picture(const Navigation& camera, FrameSize size, double now) {
        const View view = view_of(camera, size.width, size.height);
        const std::vector<View> eyes = views_of(stereo_, view, (camera.target - camera.eye).norm());
        if (settings_.loading == Loading::repeatable && !settled_) settle(eyes, now);
        settled_ = true;
        Picture out = take_picture(objects_, pair_, stereo_.mode, eyes, {settings_, photos_, side_, now});
        const ScalarField* const field = renderer_.resources().fields.shown(settings_);
        if (has_legend_ && field) legend_.draw(out, *field, settings_.field);
        return out;
    }

  private:
    /// Draws the first frame until no photo is fading.
    void settle(std::span<const View> eyes, double now) {
        constexpr int most = 60;
        for (int i = 0; i < most; ++i) {
            const FrameReport report =
                objects_.draw_eyes({eyes, settings_, photos_, {}, now + (i - most) / 30.0}, [](auto) {});
            if (report.settled && i > 1) return;
        }
    }

    gl::HeadlessContext context_;
    Renderer renderer_;
    ObjectSet objects_;
    StereoSettings stereo_;
    StereoPicture pair_;
    std::vector<std::uint32_t> photos_;
    RenderSettings settings_;
    int side_;
    bool settled_ = false, has_legend_ = false;
    PictureLegend legend_;
};

/// Renders all frames to the output. Returns their missing tiles.
TilesNotShown write_frames(Frames& frames, const std::vector<Navigation>& flight, const Output& output,
                           VideoEncoder* encoder, const ShowOptions& o, ProgressLine& progress) {
    const FrameSize size = size_of_eye(o);
    const std::atomic<bool>& stop = stop_on_signals(InFlight::abandoned);
    TilesNotShown lacking;
    progress.show({"frames", "", 0, flight.size()});
    for (std::size_t i = 0; i < flight.size(); ++i) {
        const Picture picture = frames.picture(flight[i], size, double(i) / o.video.frame_rate);
        lacking.add(picture.report);
        if (stop && !encoder)
            throw Error(Exit::interrupted, o.output.file + ": interrupted after " + std::to_string(i) +
                                               " of " + std::to_string(flight.size()) +
                                               " frames, which are complete");
        if (encoder)
            encoder->write(picture, stop);
        else
            write_png(output.frames[i], picture);
        progress.show({"frames", "", i + 1, flight.size()});
    }
    if (encoder) encoder->finish(stop);
    return lacking;
}

void print_result(const ShowOptions& o, std::size_t count, bool frames, double seconds) {
    const FrameSize size = size_of_frame(o);
    std::fprintf(text_output(), "%s  %dx%d  %zu frames  %.2f s at %g per second  rendered in %.1f s\n",
                 o.output.file.c_str(), size.width, size.height, count, double(count) / o.video.frame_rate,
                 o.video.frame_rate, seconds);
    const std::string name = fs::path(o.package.file).stem().string();
    if (const std::size_t more = frames ? frames_beyond(o.output.file, name, count) : 0)
        std::fprintf(stderr, "vantage-player: %s: contains %zu more frames, from a longer video\n",
                     o.output.file.c_str(), more);
    results().update({{"file", o.output.file},
                      {"width", size.width},
                      {"height", size.height},
                      {"frames", count},
                      {"frame_rate", o.video.frame_rate},
                      {"seconds", seconds}});
}

}  // namespace

int run_video(const PackageReader& package, const ShowOptions& o, const std::vector<SceneObject>& objects) {
    const FrameSize size = size_of_eye(o);
    const Story story = story_beside(o.package.file);
    const std::vector<Navigation> flight = flight_frames(package, o, story, size);
    const Output output = output_of(package, o, flight.size());
    const bool to_folder = output.video.empty();
    const fs::path& any = to_folder ? output.frames.front() : output.video;
    if (any.has_parent_path()) make_folder(any.parent_path());
    stop_on_signals(InFlight::abandoned);
    std::optional<VideoEncoder> encoder;
    const bool transparent = o.blending.holes == "transparent";
    const FrameSize frame = size_of_frame(o);
    if (!to_folder)
        encoder.emplace(output.video,
                        VideoFormat{frame.width, frame.height, o.video.frame_rate, transparent});
    Frames frames(package, o, objects, story);
    TilesNotShown lacking;
    double seconds = 0;
    {
        ProgressLine progress(ProgressStyle::automatic, 10);
        lacking = write_frames(frames, flight, output, encoder ? &*encoder : nullptr, o, progress);
        seconds = progress.seconds();
    }
    print_result(o, flight.size(), to_folder, seconds);
    return exit_for(package, lacking);
}

}  // namespace vantage
