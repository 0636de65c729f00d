#pragma once
#include <optional>
#include <string>
#include <vector>

#include "player/view.h"
#include "scene/package_reader.h"

namespace vantage {

/// A picture to take: its view and the name of its file, without extension.
struct Shot {
    std::string name;
    View view;
};

struct FrameSize {
    int width = 0, height = 0;
};
/// "1280x720". Throws Error(usage).
FrameSize parse_size(const std::string& text);

/// Photos by name (with or without extension), "all" for every one. Throws Error(usage) naming the unknown
/// one.
std::vector<std::uint32_t> named_photos(const PackageReader& package, const std::vector<std::string>& names);

/// From the photo's own camera: its exact intrinsics at `scale`, or in a frame of `size`, in which it fits
/// whole.
Shot photo_shot(const package::PhotoRecord& photo, std::optional<FrameSize> size, double scale);

/// "EX,EY,EZ,TX,TY,TZ" or with a vertical field of view in degrees as a seventh number (default 45), in the
/// input's coordinates; also separated by spaces. Throws Error(usage).
View parse_view(const std::string& text, const PackageReader& package, FrameSize size);

/// One view a line as in parse_view, empty lines and those that begin with # left out; named 0000, 0001, ...
/// Throws Error(input).
std::vector<Shot> read_path(const std::string& file, const PackageReader& package, FrameSize size);

}  // namespace vantage
