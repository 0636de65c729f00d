#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/text/error.h"
#include "base/text/lower_extension.h"
#include "base/values/nearest_rotation.h"
#include "pipeline/formats/camera_axes.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/formats/cameras/realitycapture/realitycapture.h"
#include "pipeline/formats/skipped_cameras.h"
#include "pipeline/formats/xml_file.h"
#include "pipeline/run/files_below.h"
#include "pipeline/run/read_file.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

/// A value of a sidecar: an attribute or an element, depending on the program's version.
struct Value {
    pugi::xml_node at;
    std::string text;
};
Value value_of(pugi::xml_node description, const char* name) {
    const std::string full = std::string("xcr:") + name;
    if (const pugi::xml_node child = description.child(full.c_str())) return {child, child.child_value()};
    return {description, description.attribute(full.c_str()).value()};
}

double number_of(const XmlFile& file, pugi::xml_node description, const char* name, double otherwise) {
    const Value v = value_of(description, name);
    return v.text.empty() ? otherwise : file.numbers(v.at, v.text, 1).front();
}

/// RealityCapture's part of a sidecar; other programs add their own.
pugi::xml_node description_of(const XmlFile& file) {
    const auto is_ours = [](const char* name) { return std::string_view(name).starts_with("xcr:"); };
    const pugi::xml_node parts = file.child("x:xmpmeta").child("rdf:RDF");
    for (const pugi::xml_node d : parts.children("rdf:Description"))
        if (std::ranges::any_of(d.attributes(), [&](pugi::xml_attribute a) { return is_ours(a.name()); }) ||
            std::ranges::any_of(d.children(), [&](pugi::xml_node n) { return is_ours(n.name()); }))
            return d;
    file.fail(parts, "an rdf:Description with xcr:Rotation", "none");
}

/// k1 k2 k3 k4 t1 t2; those that the model lacks are 0 or missing.
std::array<double, 6> coefficients_of(const XmlFile& file, pugi::xml_node description) {
    std::array<double, 6> out{};
    const Value v = value_of(description, "DistortionCoeficients");  // spelled so
    if (v.text.find_first_not_of(" \t\r\n") == v.text.npos) return out;
    std::ranges::copy(file.numbers(v.at, v.text, 6), out.begin());
    return out;
}

/// The camera of a sidecar; empty if the sidecar contains only a calibration.
std::optional<CameraSet::Entry> read_sidecar(const XmlFile& file, pugi::xml_node description,
                                             const std::string& photo) {
    const Value rotation = value_of(description, "Rotation"), position = value_of(description, "Position");
    if (rotation.text.empty() || position.text.empty()) return {};
    const std::vector<double> r = file.numbers(rotation.at, rotation.text, 9),
                              c = file.numbers(position.at, position.text, 3);
    CameraSet::Entry entry{photo, {}, CameraSet::Unit::longer_side};
    Intrinsics& k = entry.camera.intrinsics;
    const double film = 36;  // mm
    k.fx = number_of(file, description, "FocalLength35mm", 0) / film;
    k.fy = k.fx * number_of(file, description, "AspectRatio", 1);
    k.cx = number_of(file, description, "PrincipalPointU", 0);
    k.cy = number_of(file, description, "PrincipalPointV", 0);
    if (!(k.fx > 0)) file.fail(description, "xcr:FocalLength35mm above 0", "none");
    const std::string model = value_of(description, "DistortionModel").text;
    const auto lens = realitycapture_lens(model, coefficients_of(file, description),
                                          number_of(file, description, "Skew", 0) / k.fx);
    if (!lens)
        file.fail(description, "a distortion model among " + realitycapture_models(), "'" + model + "'");
    entry.camera.lens = *lens;
    Eigen::Matrix3d R;
    for (int i = 0; i < 9; ++i) R(i / 3, i % 3) = r[std::size_t(i)];
    R = nearest_orthogonal(R);  // the rotation of a prior may not be orthogonal
    entry.camera.cam_from_world = {R, -R * Eigen::Vector3d(c[0], c[1], c[2])};
    return entry;
}

}  // namespace

bool is_realitycapture_sidecar(const fs::path& file) {
    if (lower_extension(file) != ".xmp") return false;
    try {
        return read_text(file).find("capturingreality.com/ns/xcr") != std::string::npos;
    } catch (const Error&) {
        return false;
    }
}

std::vector<fs::path> realitycapture_sidecars(const fs::path& folder) {
    std::vector<fs::path> out = files_below(folder, 2);
    std::erase_if(out, [&](const fs::path& file) {
        const fs::path above = file.parent_path().parent_path();
        const bool is_below = file.lexically_relative(folder).has_parent_path();
        // A sidecar in a subfolder is a copy if the folder above contains one of the same name.
        return !is_realitycapture_sidecar(file) || (is_below && fs::exists(above / file.filename()));
    });
    return out;
}

CameraSet read_realitycapture_xmp(const fs::path& folder) {
    CameraSet set{"RealityCapture XMP", {}, {}};
    SkippedCameras skipped;
    std::size_t relative = 0;
    for (const fs::path& sidecar : realitycapture_sidecars(folder)) {
        const XmlFile file(sidecar);
        const pugi::xml_node description = description_of(file);
        const std::string photo = sidecar.lexically_relative(folder).replace_extension().generic_string();
        if (const auto entry = read_sidecar(file, description, photo))
            set.entries.push_back(*entry);
        else
            skipped.add(photo, "no pose in the sidecar");
        const std::string coordinates = value_of(description, "Coordinates").text;
        relative += coordinates == "relative" || coordinates == "rigid";
    }
    skipped.tell(set.warnings);
    if (relative > 0)
        set.warnings.push_back(std::to_string(relative) + " of " + std::to_string(set.entries.size()) +
                               " sidecars have relative coordinates: the mesh may be in another frame");
    if (set.entries.empty())
        throw NoCamera(folder.string() + ": expected an XMP sidecar with a pose, found none");
    return set;
}

}  // namespace vantage
