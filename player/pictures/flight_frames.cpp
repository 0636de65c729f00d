#include "player/pictures/flight_frames.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text/error.h"
#include "player/tour/story_views.h"
#include "player/view/camera_path.h"
#include "player/view/camera_spline.h"
#include "player/view/turntable.h"
#include "scene/story/story_file.h"

namespace vantage {
namespace {

constexpr double turn_seconds = 12, seconds_per_view = 3;

std::size_t frame_count(double seconds, double frame_rate) {
    constexpr double most = 1e6;
    const double count = std::round(seconds * frame_rate);
    if (!(count <= most))
        throw Error(
            Exit::usage,
            "the video would have more than a million frames, expected a smaller number for --seconds");
    return std::max<std::size_t>(1, std::size_t(count));
}

Navigation turntable_start(const PackageReader& package, const ShowOptions& o, FrameSize size) {
    const Eigen::Vector3d up = up_of(package.scene());
    if (!o.pictures.view.empty()) {
        const auto [view, distance] = parse_view_and_distance(o.pictures.view, package, size);
        return stand_at(view, up, distance);
    }
    if (!o.package.photos.empty())
        return stand_at(package.photos()[named_photos(package, o.package.photos).front()], up);
    return framed(package, double(size.width) / size.height);
}

std::vector<KeyView> tour_keys(const PackageReader& package, const Story& story,
                               const std::filesystem::path& file, const std::string& name) {
    const StoryTour* tour = tour_of(story, name);
    std::string tours;
    for (const StoryTour& t : story.tours) tours += (tours.empty() ? "" : ", ") + t.id;
    if (!tour)
        throw Error(Exit::usage, "--tour " + name + ": " + file.string() + " has no such tour, expected " +
                                     (tours.empty() ? "one of its tours, but it has none" : tours));
    return keys_of(story, tour->stops, {}, input_axes(package), file.string());
}

/// The first frame is at the first key, and the last frame is at the last key.
std::vector<Navigation> frames_along(const std::vector<KeyView>& keys, const VideoOptions& o) {
    const CameraSpline spline(keys);
    const double start = keys.front().seconds, length = spline.seconds() - start;
    const std::size_t steps = frame_count(o.seconds > 0 ? o.seconds : length, o.frame_rate);
    std::vector<Navigation> out;
    for (std::size_t i = 0; i <= steps; ++i)
        out.push_back(spline.at(start + length * double(i) / double(steps)));
    return out;
}

}  // namespace

Story story_beside(const std::filesystem::path& package) {
    const std::filesystem::path file = story_file_of(package);
    std::error_code error;
    if (file.empty() || !std::filesystem::exists(std::filesystem::symlink_status(file, error))) return {};
    return read_story(file).story;
}

std::vector<Navigation> flight_frames(const PackageReader& package, const ShowOptions& o, const Story& story,
                                      FrameSize size) {
    if (int(o.video.turntable) + int(!o.video.tour.empty()) + int(!o.pictures.path.empty()) != 1)
        throw Error(Exit::usage, "video: expected one of --turntable, --tour and --path");
    if (o.video.turntable) {
        const std::size_t count =
            frame_count(o.video.seconds > 0 ? o.video.seconds : turn_seconds, o.video.frame_rate);
        return turntable(turntable_start(package, o, size), int(count), {-o.video.arc / 2, o.video.arc / 2});
    }
    return frames_along(o.video.tour.empty()
                            ? path_keys(o.pictures.path, package, seconds_per_view)
                            : tour_keys(package, story, story_file_of(o.package.file), o.video.tour),
                        o.video);
}

}  // namespace vantage
