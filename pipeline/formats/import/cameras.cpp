#include "pipeline/formats/import/cameras.h"

#include "scene/error.h"

namespace vantage {

CameraSet read_cameras(const std::filesystem::path& path) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::is_directory(path) ? path : path.parent_path();
    const std::string stem = path.stem().string(), extension = path.extension().string();
    const bool colmap = fs::is_directory(path) || stem == "cameras" || stem == "images";
    if (colmap && extension != ".txt" && fs::exists(folder / "cameras.bin"))
        return read_colmap_binary(folder);
    if (colmap && fs::exists(folder / "cameras.txt")) return read_colmap_text(folder);
    if (extension == ".out") return read_bundler(path);
    if (extension == ".mlp") return read_meshlab(path);
    if (extension == ".rz3")
        throw Error(Exit::input,
                    path.string() +
                        ": REALVIZ cameras are not supported, because no public documentation states the "
                        "axes, the order of rotations and the unit of the focal length; expected "
                        "COLMAP, Bundler or MeshLab cameras");
    throw Error(Exit::input, path.string() +
                                 ": expected a COLMAP folder (cameras and images, .bin or .txt), "
                                 "a Bundler .out or a MeshLab .mlp file");
}

}  // namespace vantage
