#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "scene/camera/camera.h"

namespace vantage {

/// A photo's camera.
struct NamedCamera {
    std::string photo;  ///< file name
    Camera camera;
};

/// The files of a model in COLMAP's text format.
inline constexpr const char* colmap_text_files[] = {"cameras.txt", "images.txt", "points3D.txt"};

/// Whether COLMAP can express the lens: all but `brown` and `matchmover`.
bool has_colmap_model(const Lens& lens);

/// Writes the `colmap_text_files`, with one camera per photo and no points, in full double precision. Throws
/// Error(storage), and Error(input) for a lens without a COLMAP model. `comment` contains lines that begin
/// with #, which are written at the top of each file.
void write_colmap_text(const std::filesystem::path& folder, std::span<const NamedCamera> photos,
                       const std::string& comment = "");

}  // namespace vantage
