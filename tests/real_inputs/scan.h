#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/gltf_file.h"

namespace vantage::real_inputs {

/// An in-memory copy of a scan on disk. Paths are relative to the scan's folder; files are stored as bytes.
struct Scan {
    std::map<std::string, std::string> files;
    std::map<std::string, std::string> links;  ///< symbolic links: targets by path
    std::set<std::string> folders;             ///< empty folders

    std::string& operator[](const std::string& path) { return files[path]; }
    /// Renames a file, or a folder with everything in it.
    void move(const std::string& from, const std::string& to);
    /// Copies a file, or a folder with everything in it.
    void copy(const std::string& from, const std::string& to);
    void remove(const std::string& path);
    /// Replaces every occurrence of `from` in a file. Throws std::logic_error if there is none.
    void replace(const std::string& path, const std::string& from, const std::string& to);
    void write(const std::filesystem::path& folder) const;
};

std::string slurp(const std::filesystem::path& file);

/// The text with every occurrence of `from` replaced with `to`.
std::string replaced(std::string text, const std::string& from, const std::string& to);

/// The scan that every row changes. It contains `images/` with A.jpg (red), B.jpg (green) and C.jpg (blue),
/// all 64x48, `sparse/` with their cameras in COLMAP's text format, and mesh.ply, which is a box of 12
/// triangles.
Scan standard_scan();

using Names = std::vector<std::string>;

/// COLMAP's images.txt for the cameras of photos A, B and C, in this order and under these names.
std::string colmap_images(const Names& names);
/// COLMAP's images.bin and cameras.bin for the same cameras.
std::string colmap_images_bin(const Names& names);
std::string colmap_cameras_bin();
/// A Bundler file with this number of cameras.
std::string bundle(std::size_t cameras = 3);
/// A MeshLab project with these file names.
std::string meshlab(const Names& names);
/// Replaces the cameras with a Bundler file and this list.txt.
void use_bundler(Scan& scan, const std::string& list);
void use_meshlab(Scan& scan, const Names& names);

/// A transform of the box's corners, x = scale * corner + (x, y, z).
struct Place {
    double scale = 1, x = 0, y = 0, z = 0;
};
std::string box_ply(const Place& place = {});
std::string box_obj(const std::string& colors = "");  ///< `colors` is appended to each vertex
std::string box_off(const std::string& header = "OFF\n8 12 0\n", const std::string& after_vertex = "",
                    const std::string& after_face = "");
/// The box as PLY with additional vertex properties, given by their header lines and the values of each
/// vertex.
std::string box_ply_with(const std::string& properties, const std::string& values);
std::string box_stl();
std::string box_stl_binary();
GltfFile box_gltf(const Place& place = {});
std::string box_fbx();  ///< FBX in text form, with centimeters as the unit
/// A PLY with `points` points and no faces, like COLMAP's fused.ply. The points repeat the box's corners.
std::string points_ply(std::size_t points = 1000);

/// A photo of one color in the format of the extension: ".jpg", ".png", ".tif", ".exr", ".hdr", ...
/// The values are stored unchanged: as sRGB, or as linear light if the format stores linear light.
std::string photo(const std::string& extension, double r, double g, double b, int width = 64, int height = 48,
                  int orientation = 1);
std::string red(const std::string& extension = ".jpg");
std::string green(const std::string& extension = ".jpg");
std::string blue(const std::string& extension = ".jpg");
/// The JPEG with this number of metadata bytes before the image size.
std::string with_metadata(const std::string& jpeg, std::size_t bytes);
/// The JPEG with an ICC profile of less than 64 KB.
std::string with_profile(const std::string& jpeg, const std::string& icc);

}  // namespace vantage::real_inputs
