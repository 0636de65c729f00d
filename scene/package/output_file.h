#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/checksum.h"

namespace vantage {

/// What the programs write: each kind replaces only files of the same kind that they have written; PNG and
/// EXR pictures, world files and videos, any file of their format.
enum class Product {
    package,
    page,
    trace,
    junit,
    ply,
    csv,
    plot,
    png,
    tiff,
    exr,
    jpeg,
    cameras,
    scene,
    world,
    video
};

/// A line of the header of a mesh written by these programs.
inline constexpr const char* ply_mark = "comment written by Vantage\n";

/// In a comment at the beginning of a photo written by these programs.
inline constexpr std::string_view jpeg_mark = "written by Vantage";

/// The first line of each of COLMAP's text files written by these programs.
inline constexpr const char* cameras_mark = "# COLMAP model written by Vantage\n";

/// The first line of a scene file written by these programs.
inline constexpr const char* scene_mark = "# scene written by Vantage\n";

/// What a command reads and must not overwrite.
struct Inputs {
    std::vector<std::filesystem::path> files;  ///< also other files that the command writes
    std::vector<FileIdentity> contents;        ///< of files whose place is unknown
};

/// The file to write so that `file` is written: `file`, or what it links to. A package also needs the names
/// under which it is written until it is complete. Every command asks before it does any work. Throws
/// Error(usage) if the file is an input, a folder, a device or a pipe, or, unless `force`, if it exists, has
/// content and is not of the kind to replace. `force`: the option --force, none if the command lacks it.
std::filesystem::path output_file(const std::filesystem::path& file, Product product, const Inputs& inputs,
                                  std::optional<bool> force);

/// A folder of results that are written together: its `mark` is a product that shows whose the folder is, and
/// the other files may be replaced if it is there. Throws Error(usage) like output_file() for the mark, or
/// if it does not exist and one of the others does, unless `force`.
void expect_result_folder(const std::filesystem::path& folder, const char* mark, Product product,
                          const std::vector<std::filesystem::path>& others, const Inputs& inputs, bool force);

/// The same for the PNG pictures in it whose names, without extension, `is_result`.
void expect_result_pictures(const std::filesystem::path& folder,
                            const std::function<bool(const std::string& name)>& is_result,
                            const Inputs& inputs, bool force);

}  // namespace vantage
