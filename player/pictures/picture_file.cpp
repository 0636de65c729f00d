#include "player/pictures/picture_file.h"

#include <algorithm>

#include "base/text/error.h"
#include "base/text/lower_extension.h"

namespace vantage {
namespace {

/// Extensions of pictures and videos: a name with one of these extensions names a file, not a folder.
constexpr const char* file_extensions[] = {".png", ".apng", ".jpg",  ".jpeg", ".jpe",  ".jxl", ".jp2",
                                           ".tif", ".tiff", ".webp", ".avif", ".heic", ".gif", ".bmp",
                                           ".tga", ".ppm",  ".exr",  ".hdr",  ".svg",  ".pdf", ".mp4",
                                           ".m4v", ".mov",  ".mkv",  ".avi",  ".webm"};

}  // namespace

void expect_folder_name(const std::filesystem::path& folder, const std::string& expected) {
    std::error_code error;
    if (std::filesystem::is_directory(folder, error)) return;
    if (std::ranges::count(file_extensions, lower_extension(folder)))
        throw Error(Exit::usage, folder.string() + ": expected " + expected);
}

std::filesystem::path picture_file(const std::string& output, const std::string& name, std::size_t count) {
    const std::filesystem::path out = output.empty() ? (count == 1 ? name + ".png" : ".") : output;
    std::error_code error;
    if (count == 1 && lower_extension(out) == ".png" && !std::filesystem::is_directory(out, error))
        return out;
    expect_folder_name(out, count == 1 ? "a name that ends with .png, the only picture format, or a folder"
                                       : "a folder, for " + std::to_string(count) + " pictures");
    return out / (name + ".png");
}

}  // namespace vantage
