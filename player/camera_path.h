#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "player/navigation.h"
#include "scene/package_reader.h"

namespace vantage {

/// A flight, a position a frame.
struct CameraPath {
    std::string name;
    std::vector<Navigation> frames;
};

/// From where `start` stands: "still"; "orbit", 60 degrees to either side and back; "approach", to a third of
/// the distance and back; "jump", away from the model and, halfway, at once around by 180 degrees; "flight",
/// random but smooth, the same for the same `seed`. Throws Error(usage) for another name.
CameraPath scripted_path(const std::string& name, const Navigation& start, int frames, unsigned seed = 1);

/// A camera path file as read_path reads it, spread evenly over `frames` positions. Throws Error(input).
CameraPath recorded_path(const std::string& file, const PackageReader& package, int frames);

/// Writes positions as read_path reads them. Throws Error(storage).
void write_path(const std::filesystem::path& file, const std::vector<Navigation>& positions,
                const PackageReader& package);

/// Between two positions, `share` of the way.
Navigation between(const Navigation& a, const Navigation& b, double share);

}  // namespace vantage
