#include "pipeline/formats/import/cameras.h"

#include <algorithm>

#include "scene/error.h"
#include "values/lower_extension.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

/// COLMAP's folder; `path` is the folder itself or one of its files.
fs::path colmap_folder(const fs::path& path) { return fs::is_directory(path) ? path : path.parent_path(); }

bool is_colmap(const fs::path& path, const char* cameras) {
    const fs::path stem = path.stem();
    return (fs::is_directory(path) || stem == "cameras" || stem == "images") &&
           fs::exists(colmap_folder(path) / cameras);
}

constexpr const char* colmap_form = "folder (cameras and images, .bin or .txt)";

const CameraFormat formats[] = {
    {.name = "COLMAP",
     .form = colmap_form,
     .files = {"cameras.bin", "images.bin"},
     .matches = [](const fs::path& p) { return p.extension() != ".txt" && is_colmap(p, "cameras.bin"); },
     .read = [](const fs::path& p) { return read_colmap_binary(colmap_folder(p)); }},
    {.name = "COLMAP",
     .form = colmap_form,
     .files = {"cameras.txt", "images.txt"},
     .matches = [](const fs::path& p) { return is_colmap(p, "cameras.txt"); },
     .read = [](const fs::path& p) { return read_colmap_text(colmap_folder(p)); }},
    {.name = "Bundler",
     .form = ".out",
     .files = {},
     .matches = [](const fs::path& p) { return lower_extension(p) == ".out"; },
     .read = read_bundler,
     .companions = [](const fs::path& p) { return std::vector{bundler_list(p)}; }},
    {.name = "MeshLab",
     .form = ".mlp",
     .files = {},
     .matches = [](const fs::path& p) { return lower_extension(p) == ".mlp"; },
     .read = read_meshlab},
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
    for (const char* name : format->files) files.push_back(colmap_folder(path) / name);
    if (format->files.empty()) files.push_back(path);
    if (format->companions) std::ranges::move(format->companions(path), std::back_inserter(files));
    std::erase_if(files, [](const fs::path& file) { return !fs::exists(file); });
    return files;
}

CameraSet read_cameras(const fs::path& path) {
    if (const CameraFormat* format = format_of(path)) return format->read(path);
    const std::string expected = "expected " + camera_format_names();
    if (path.extension() == ".rz3")
        throw Error(Exit::input,
                    path.string() +
                        ": REALVIZ cameras are not supported, because no public documentation states the "
                        "axes, the order of rotations and the unit of the focal length; " +
                        expected);
    throw Error(Exit::input, path.string() + ": not a known camera format; " + expected);
}

}  // namespace vantage
