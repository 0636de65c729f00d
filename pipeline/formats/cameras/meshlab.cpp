#include <pugixml.hpp>
#include <sstream>

#include "base/text/error.h"
#include "pipeline/formats/camera_axes.h"
#include "pipeline/formats/cameras/cameras.h"

namespace vantage {
namespace {

/// The numbers in an attribute of a camera. Throws Error(input) if there are fewer than `count` of them.
std::vector<double> numbers(const std::filesystem::path& file, const pugi::xml_node& camera, const char* name,
                            std::size_t count) {
    std::istringstream in(camera.attribute(name).value());
    in.imbue(std::locale::classic());
    std::vector<double> values;
    for (double v; in >> v;) values.push_back(v);
    if (values.size() < count)
        throw Error(Exit::input, file.string() + ": " + camera.parent().attribute("label").value() +
                                     ": expected " + std::to_string(count) + " numbers in " + name +
                                     ", found '" + camera.attribute(name).value() + "'");
    return values;
}

CameraSet::Entry read_raster(const std::filesystem::path& file, const pugi::xml_node& raster,
                             std::vector<std::string>& warnings) {
    const pugi::xml_node camera = raster.child("VCGCamera"), plane = raster.child("Plane");
    const std::string label = raster.attribute("label").value();
    const auto read = [&](const char* name, std::size_t count) { return numbers(file, camera, name, count); };
    const auto viewport = read("ViewportPx", 2), pixel_size = read("PixelSizeMm", 2),
               focal = read("FocalMm", 1), center = read("CenterPx", 2),
               rotation = read("RotationMatrix", 16), translation = read("TranslationVector", 3);
    for (const double v : viewport)
        if (!(v >= 1 && v <= 1 << 20))
            throw Error(Exit::input, file.string() + ": " + label + ": ViewportPx is not a valid photo size");
    CameraSet::Entry entry{plane ? plane.attribute("fileName").value() : label, {}};
    entry.camera.intrinsics = {int(viewport[0]),         int(viewport[1]), focal[0] / pixel_size[0],
                               focal[0] / pixel_size[1], center[0],        center[1]};
    Eigen::Matrix3d R;
    for (int i = 0; i < 9; ++i) R(i / 3, i % 3) = rotation[std::size_t(i / 3 * 4 + i % 3)];
    entry.camera.cam_from_world = from_meshlab(R, {translation[0], translation[1], translation[2]});
    if (camera.attribute("CameraType").as_int() != 0)
        throw Error(Exit::input,
                    file.string() + ": " + label + ": expected a perspective camera (CameraType 0)");
    const auto lens = read("LensDistortion", 2);
    if (lens[0] != 0 || lens[1] != 0)
        warnings.push_back(label + ": lens distortion ignored, as in MeshLab's own projections");
    return entry;
}

/// Whether the project transforms the mesh.
bool is_transformed(const pugi::xml_node& mesh) {
    std::istringstream in(mesh.child_value("MLMatrix44"));
    in.imbue(std::locale::classic());
    int i = 0;
    for (double v; in >> v; ++i)
        if (v != (i % 5 == 0 ? 1 : 0)) return true;
    return false;
}

}  // namespace

CameraSet read_meshlab(const std::filesystem::path& file) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_file(file.c_str());
    const pugi::xml_node project = document.child("MeshLabProject");
    if (!parsed || !project)
        throw Error(Exit::input, file.string() + ": expected a MeshLab project: " + parsed.description());
    CameraSet set{"MeshLab", {}, {}};
    for (const pugi::xml_node mesh : project.child("MeshGroup").children("MLMesh"))
        if (is_transformed(mesh))
            throw Error(Exit::input,
                        file.string() + ": " + mesh.attribute("label").value() +
                            ": transformed by its MLMatrix44; expected a mesh saved with the matrix applied");
    for (const pugi::xml_node raster : project.child("RasterGroup").children("MLRaster"))
        if (raster.child("VCGCamera"))
            set.entries.push_back(read_raster(file, raster, set.warnings));
        else
            set.warnings.push_back(std::string(raster.attribute("label").value()) +
                                   ": has no camera; skipped");
    if (set.entries.empty()) throw NoCamera(file.string() + ": expected a raster with a camera, found none");
    return set;
}

}  // namespace vantage
