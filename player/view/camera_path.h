#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "player/view/camera_spline.h"
#include "player/view/navigation.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// A flight with one position per frame.
struct CameraPath {
    std::string name;
    std::vector<Navigation> frames;
};

/// From `start`: "still"; "orbit", 60 degrees to either side and back; "approach", to a third of the distance
/// and back; "jump", facing away from the model and then turned by 180 degrees at the middle frame; "flight",
/// smooth and random, reproducible with `seed`. Throws Error(usage) if the name is none of these.
CameraPath scripted_path(const std::string& name, const Navigation& start, int frames, unsigned seed = 1);

/// The views in a file (see read_path), interpolated evenly to `frames` positions. Throws Error(input).
CameraPath recorded_path(const std::string& file, const PackageReader& package, int frames);

/// The views in a file with their times (see read_path). Views without times are `seconds` apart. Throws
/// Error(input).
std::vector<KeyView> path_keys(const std::string& file, const PackageReader& package, double seconds);

/// The views in a file (see read_path), with targets at `distance`. Throws Error(input).
std::vector<Navigation> recorded_stops(const std::string& file, const PackageReader& package,
                                       double distance = 1);

/// Stops at the photos' cameras, starting at the first camera and always continuing to the nearest remaining
/// one. Photos without pixels are skipped.
std::vector<Navigation> photo_stops(const PackageReader& package, std::span<const std::uint32_t> photos);

/// Positions along straight lines from stop to stop, in equal steps of at most `step` radians. The size of a
/// step is the camera's rotation or its movement around its target, whichever is larger. Throws Error(usage)
/// if there would be more than a million frames.
std::vector<Navigation> in_steps(const std::vector<Navigation>& stops, double step);

/// A position in the format of parse_view(), with commas.
std::string view_text(const Navigation& position, const PackageReader& package);

/// Writes positions in the format of read_path, each with an image set unless `image_sets` is empty. If
/// `per_second`, the number of positions per second, is given, also writes times. Throws Error(storage).
void write_path(const std::filesystem::path& file, const std::vector<Navigation>& positions,
                const PackageReader& package, std::span<const std::string> image_sets = {},
                std::optional<double> per_second = {});

/// Interpolates from `a` (share 0) to `b` (share 1), and extrapolates beyond them.
Navigation between(const Navigation& a, const Navigation& b, double share);

}  // namespace vantage
