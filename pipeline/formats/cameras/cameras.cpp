#include "pipeline/formats/cameras/cameras.h"

#include <algorithm>
#include <initializer_list>
#include <sstream>
#include <string_view>

#include "base/text/error.h"
#include "base/text/lower_extension.h"
#include "base/text/parse_number.h"
#include "pipeline/formats/cameras/realitycapture/realitycapture.h"
#include "pipeline/run/read_file.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

/// The folder of a camera format that consists of several files. `path` is the folder itself or one of its
/// files.
fs::path folder_of(const fs::path& path) { return fs::is_directory(path) ? path : path.parent_path(); }

bool is_colmap(const fs::path& path, const char* cameras) {
    const fs::path stem = path.stem();
    return (fs::is_directory(path) || stem == "cameras" || stem == "images") &&
           fs::exists(folder_of(path) / cameras);
}

/// The beginning of a file; empty if it cannot be read.
std::string beginning(const fs::path& file) {
    constexpr std::size_t looked_at = 1 << 16;
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return {};
    try {
        const std::vector<std::byte> bytes = read_file(file, looked_at);
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    } catch (const Error&) {
        return {};
    }
}

using Texts = std::initializer_list<std::string_view>;

/// Whether the beginning of a file contains a string from each list.
bool begins_with(const fs::path& file, std::initializer_list<Texts> lists) {
    const std::string begin = beginning(file);
    return std::ranges::all_of(lists, [&](const Texts& texts) {
        return std::ranges::any_of(texts,
                                   [&](std::string_view text) { return begin.find(text) != begin.npos; });
    });
}

/// Whether a file begins with Bundler's name, or with two whole numbers, as in versions before 0.3. Other
/// programs also write .out files.
bool is_bundler(const fs::path& file) {
    if (lower_extension(file) != ".out") return false;
    const std::string begin = beginning(file);
    if (begin.substr(0, 20).find("# Bundle") != begin.npos) return true;
    std::istringstream in(begin);
    std::string line;
    while (std::getline(in, line) &&
           (line.starts_with('#') || line.find_first_not_of(" \t\r") == line.npos)) {
    }
    std::istringstream words(line);
    std::string cameras, points, more;
    words >> cameras >> points;
    std::size_t number = 0;
    return parse_number(cameras, number) && parse_number(points, number) && !(words >> more);
}

bool is_json(const fs::path& file) { return lower_extension(file) == ".json"; }
bool is_xml(const fs::path& file) { return lower_extension(file) == ".xml"; }

constexpr const char* colmap_form = "folder (cameras and images, .bin or .txt)";

const CameraFormat formats[] = {
    {.name = "COLMAP",
     .form = colmap_form,
     .files = {"cameras.bin", "images.bin"},
     .matches = [](const fs::path& p) { return p.extension() != ".txt" && is_colmap(p, "cameras.bin"); },
     .read = [](const fs::path& p) { return read_colmap_binary(folder_of(p)); }},
    {.name = "COLMAP",
     .form = colmap_form,
     .files = {"cameras.txt", "images.txt"},
     .matches = [](const fs::path& p) { return is_colmap(p, "cameras.txt"); },
     .read = [](const fs::path& p) { return read_colmap_text(folder_of(p)); }},
    {.name = "Metashape",
     .form = "cameras .xml",
     .files = {},
     .matches =
         [](const fs::path& p) {
             return is_xml(p) &&
                    begins_with(p, {{"<document", "<collection>"}, {"<chunk ", "<chunk>", "<collection>"}});
         },
     .read = read_metashape},
    {.name = "RealityCapture",
     .form = ".xmp sidecars",
     .files = {},
     .matches =
         [](const fs::path& p) {
             return fs::is_directory(p) ? !realitycapture_sidecars(p).empty() : is_realitycapture_sidecar(p);
         },
     .read = [](const fs::path& p) { return read_realitycapture_xmp(folder_of(p)); },
     .companions = [](const fs::path& p) { return realitycapture_sidecars(folder_of(p)); },
     .one_per_photo = true},
    {.name = "RealityCapture",
     .form = ".csv",
     .files = {},
     .matches = is_realitycapture_csv,
     .read = read_realitycapture_csv},
    {.name = "Meshroom",
     .form = ".sfm",
     .files = {},
     .matches =
         [](const fs::path& p) {
             return lower_extension(p) == ".sfm" || (is_json(p) && begins_with(p, {{"\"intrinsicId\""}}));
         },
     .read = read_meshroom},
    {.name = "OpenMVG",
     .form = "sfm_data.json",
     .files = {},
     .matches = [](const fs::path& p) { return is_json(p) && begins_with(p, {{"\"sfm_data_version\""}}); },
     .read = read_openmvg},
    {.name = "OpenSfM",
     .form = "reconstruction.json",
     .files = {},
     .matches =
         [](const fs::path& p) {
             return is_json(p) && begins_with(p, {{"\"projection_type\""}, {"\"shots\"", "\"cameras\""}});
         },
     .read = read_opensfm},
    {.name = "nerfstudio",
     .form = "transforms.json",
     .files = {},
     .matches = [](const fs::path& p) { return is_json(p) && begins_with(p, {{"\"transform_matrix\""}}); },
     .read = read_transforms},
    {.name = "Blocks Exchange",
     .form = ".xml",
     .files = {},
     .matches = [](const fs::path& p) { return is_xml(p) && begins_with(p, {{"<BlocksExchange"}}); },
     .read = read_blocks_exchange},
    {.name = "Bundler",
     .form = ".out",
     .files = {},
     .matches = is_bundler,
     .read = read_bundler,
     .companions = [](const fs::path& p) { return std::vector{bundler_list(p)}; }},
    {.name = "MeshLab",
     .form = ".mlp",
     .files = {},
     .matches = [](const fs::path& p) { return lower_extension(p) == ".mlp"; },
     .read = read_meshlab},
    {.name = "MatchMover",
     .form = ".rzml",
     .files = {},
     .matches = [](const fs::path& p) { return lower_extension(p) == ".rzml"; },
     .read = read_matchmover},
};

/// The first format that matches; null if none does.
const CameraFormat* format_of(const fs::path& path) {
    const auto format = std::ranges::find_if(formats, [&](const CameraFormat& f) { return f.matches(path); });
    return format == std::end(formats) ? nullptr : format;
}

}  // namespace

std::span<const CameraFormat> camera_formats() { return formats; }

std::string camera_format_names() {
    std::string names;
    for (const CameraFormat& f : formats) {
        const std::string name = std::string(f.name) + " " + f.form;
        if (names.ends_with(name)) continue;  // COLMAP, binary and text
        names += (names.empty() ? "" : ", ") + name;
    }
    return names;
}

std::vector<fs::path> camera_files(const fs::path& path) {
    const CameraFormat* format = format_of(path);
    if (!format) return {path};
    std::vector<fs::path> files;
    for (const char* name : format->files) files.push_back(folder_of(path) / name);
    if (format->files.empty() && !format->one_per_photo) files.push_back(path);
    if (format->companions) std::ranges::move(format->companions(path), std::back_inserter(files));
    std::erase_if(files, [](const fs::path& file) { return !fs::exists(file); });
    return files;
}

CameraSet read_cameras(const fs::path& path) {
    if (const CameraFormat* format = format_of(path)) return format->read(path);
    if (lower_extension(path) == ".out") return read_bundler(path);  // reports a file that is not Bundler's
    const std::string expected = "expected " + camera_format_names();
    if (lower_extension(path) == ".rz3" || lower_extension(path) == ".rzi")
        throw Error(Exit::input,
                    path.string() +
                        ": this REALVIZ format has no public description: export .rzml instead, or "
                        "use another program; " +
                        expected);
    throw Error(Exit::input, path.string() + ": not a known camera format; " + expected);
}

}  // namespace vantage
