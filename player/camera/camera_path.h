#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "player/camera/navigation.h"
#include "scene/package_reader.h"

namespace vantage {

/// A flight: one position per frame.
struct CameraPath {
    std::string name;
    std::vector<Navigation> frames;
};

/// From `start`: "still"; "orbit", 60 degrees to either side and back; "approach", to a third of the distance
/// and back; "jump", facing away from the model, then turned by 180 degrees at the middle frame; "flight",
/// smooth and random, reproducible by `seed`. Throws Error(usage) for any other name.
CameraPath scripted_path(const std::string& name, const Navigation& start, int frames, unsigned seed = 1);

/// The views in a file (see read_path), interpolated evenly to `frames` positions. Throws Error(input).
CameraPath recorded_path(const std::string& file, const PackageReader& package, int frames);

/// Writes positions in the format of read_path. Throws Error(storage).
void write_path(const std::filesystem::path& file, const std::vector<Navigation>& positions,
                const PackageReader& package);

/// Interpolates from `a` (share 0) to `b` (share 1); extrapolates beyond.
Navigation between(const Navigation& a, const Navigation& b, double share);

}  // namespace vantage
