#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "player/view/frame_size.h"
#include "player/view/view.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// A picture to take: its view, and its file name without extension.
struct Shot {
    std::string name;
    View view;
    std::optional<std::uint32_t> image_set{};  ///< nullopt: unspecified
    std::optional<double> at{};                ///< seconds after the flight begins; nullopt if unspecified
    double distance = 1;                       ///< distance from the eye to its target
};

/// "1280x720". Throws Error(usage).
FrameSize parse_size(const std::string& text);

/// The indices of photos given by name (with or without extension), without duplicates; "all" stands for
/// every photo. Throws Error(usage) if a name is unknown or ambiguous.
std::vector<std::uint32_t> named_photos(const PackageReader& package, const std::vector<std::string>& names);

/// A shot from the photo's own camera, with its intrinsics at `scale`, or with the whole photo fitted into
/// `size`. `name`: the picture's name.
Shot photo_shot(const package::PhotoRecord& photo, const std::string& name, std::optional<FrameSize> size,
                double scale);

/// "EX,EY,EZ,TX,TY,TZ", eye and target in input coordinates; optionally the vertical field of view in degrees
/// (default 45), and the roll, a clockwise rotation of the camera in degrees (default 0). Numbers are
/// separated by commas or spaces. Throws Error(usage).
View parse_view(const std::string& text, const PackageReader& package, FrameSize size);

/// The same view as parse_view() returns, and the distance from the eye to the target.
std::pair<View, double> parse_view_and_distance(const std::string& text, const PackageReader& package,
                                                FrameSize size);

/// Reads one view per line, as in parse_view(). A view may be followed by at=SECONDS for its time in a
/// flight, and by image-set=NAME for an image set. Empty lines and lines that start with # are skipped. Named
/// 0000, 0001, ... Throws Error(input), for example if the times are not in order.
std::vector<Shot> read_path(const std::string& file, const PackageReader& package, FrameSize size);

}  // namespace vantage
