#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/checksum.h"

namespace vantage {

/// Kinds of output files. A new file replaces only files of the same kind that these programs wrote. PNG and
/// EXR pictures, world files and videos replace any file of their format.
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

/// A header line in meshes written by these programs.
inline constexpr const char* ply_mark = "comment written by Vantage\n";

/// Part of a comment at the beginning of photos written by these programs.
inline constexpr std::string_view jpeg_mark = "written by Vantage";

/// The first line of COLMAP text files written by these programs.
inline constexpr const char* cameras_mark = "# COLMAP model written by Vantage\n";

/// The first line of scene files written by these programs.
inline constexpr const char* scene_mark = "# scene written by Vantage\n";

/// Files that a command reads and must not overwrite.
struct Inputs {
    std::vector<std::filesystem::path> files;  ///< including other outputs of the command
    std::vector<FileIdentity> contents;        ///< identities of files whose paths are unknown
};

/// The file to write: `file` or, if it is a link, its target. For a package, also checks the names under
/// which the package is written until it is complete. Every command calls this before it does any work.
/// Throws Error(usage) if the file is an input, a folder, a device or a pipe. Unless `force` is set, also
/// throws Error(usage) if the file exists, has content and is not of a kind that may be replaced. `force`:
/// the value of the option --force; empty if the command does not have it.
std::filesystem::path output_file(const std::filesystem::path& file, Product product, const Inputs& inputs,
                                  std::optional<bool> force);

/// Checks a folder of results that are written together. If the folder contains the file `mark`, which is of
/// the kind `product`, then this command wrote the results, and the other files may be replaced. Throws
/// Error(usage) if output_file() throws it for the mark. Unless `force` is set, also throws Error(usage) if
/// the mark is missing but one of the other files exists.
void expect_result_folder(const std::filesystem::path& folder, const char* mark, Product product,
                          const std::vector<std::filesystem::path>& others, const Inputs& inputs, bool force);

/// Like expect_result_folder(), for the PNG pictures in the folder whose names, without the extension,
/// satisfy `is_result`.
void expect_result_pictures(const std::filesystem::path& folder,
                            const std::function<bool(const std::string& name)>& is_result,
                            const Inputs& inputs, bool force);

}  // namespace vantage
