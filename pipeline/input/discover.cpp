#include "pipeline/input/discover.h"

#include <algorithm>
#include <map>
#include <vector>

#include "pipeline/formats/import/cameras.h"
#include "scene/error.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

constexpr const char* stencil_suffix = ".mask.png";

std::string extension(const fs::path& file) {
    std::string e = file.extension().string();
    std::transform(e.begin(), e.end(), e.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return e;
}

bool is_one_of(const std::string& text, std::initializer_list<const char*> list) {
    return std::any_of(list.begin(), list.end(), [&](const char* s) { return text == s; });
}

std::vector<fs::path> files_below(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::recursive_directory_iterator it(folder, fs::directory_options::skip_permission_denied, error),
         end;
         !error && it != end; it.increment(error)) {
        if (it.depth() >= 2) it.disable_recursion_pending();
        if (it->is_regular_file()) files.push_back(it->path());
    }
    if (error) throw Error(Exit::input, folder.string() + ": cannot list the folder: " + error.message());
    std::sort(files.begin(), files.end());
    return files;
}

fs::path find_mesh(const std::vector<fs::path>& files) {
    fs::path best;
    std::uintmax_t best_rank = 0;
    for (const fs::path& f : files) {
        if (!is_one_of(extension(f), {".ply", ".obj", ".stl", ".off"})) continue;
        const std::uintmax_t rank = f.stem() == "mesh" ? ~std::uintmax_t(0) : fs::file_size(f);
        if (best.empty() || rank > best_rank) best = f, best_rank = rank;
    }
    return best;
}

/// Whether `file` is the first file of a folder in this format; the others lie next to it.
bool is_first_of(const CameraFormat& format, const fs::path& file) {
    return !format.files.empty() && file.filename() == format.files.front() &&
           std::ranges::all_of(format.files,
                               [&](const char* name) { return fs::exists(file.parent_path() / name); });
}

fs::path find_cameras(const std::vector<fs::path>& files) {
    for (const CameraFormat& format : camera_formats())
        for (const fs::path& f : files) {
            if (format.files.empty() && format.matches(f)) return f;
            if (is_first_of(format, f)) return f.parent_path();
        }
    return {};
}

fs::path find_photos(const std::vector<fs::path>& files) {
    std::map<fs::path, std::size_t> count;
    for (const fs::path& f : files)
        if (is_photo(f)) ++count[f.parent_path()];
    // The folder's name takes precedence over the number of images: folders of masks or depth maps may hold
    // more.
    const auto rank = [](const auto& c) {
        return std::pair(is_one_of(c.first.filename().string(), {"images", "photos"}), c.second);
    };
    const auto best = std::ranges::max_element(count, {}, rank);
    return best == count.end() ? fs::path() : best->first;
}

}  // namespace

fs::path find_stencil(const fs::path& photo) {
    const fs::path folder = photo.parent_path(), masks = folder.parent_path() / "masks";
    for (const fs::path& name : {photo.filename(), photo.stem()})
        for (const fs::path& candidate :
             {folder / (name.string() + stencil_suffix), masks / (name.string() + ".png")})
            if (fs::is_regular_file(candidate)) return candidate;
    return {};
}

bool is_photo(const fs::path& file) {
    if (file.filename().string().ends_with(stencil_suffix)) return false;
    return is_one_of(extension(file), {".jpg", ".jpeg", ".png", ".tif", ".tiff", ".exr", ".webp", ".bmp",
                                       ".jp2", ".cr2", ".nef", ".arw", ".dng", ".ppm", ".hdr"});
}

InputFiles discover(const fs::path& folder) {
    if (!fs::is_directory(folder)) throw Error(Exit::input, folder.string() + ": not a folder");
    const std::vector<fs::path> files = files_below(folder);
    const InputFiles found{find_mesh(files), find_cameras(files), find_photos(files)};
    if (found.mesh.empty())
        throw Error(Exit::input, folder.string() + ": no mesh found (PLY, OBJ, STL, OFF)");
    if (found.cameras.empty())
        throw Error(Exit::input, folder.string() + ": no cameras found; expected " + camera_format_names());
    if (found.photos.empty()) throw Error(Exit::input, folder.string() + ": no photos found");
    return found;
}

std::vector<fs::path> camera_files(const fs::path& cameras) {
    if (!fs::is_directory(cameras)) return {cameras};
    std::vector<fs::path> files;
    for (const CameraFormat& format : camera_formats())
        for (const char* name : format.files)
            if (fs::exists(cameras / name)) files.push_back(cameras / name);
    return files;
}

}  // namespace vantage
