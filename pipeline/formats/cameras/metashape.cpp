#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <string_view>

#include "base/text/error.h"
#include "pipeline/formats/camera_axes.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/formats/skipped_cameras.h"
#include "pipeline/formats/xml_file.h"

namespace vantage {
namespace {

Eigen::Matrix3d by_rows(const std::vector<double>& n, std::size_t columns) {
    Eigen::Matrix3d out;
    for (std::size_t i = 0; i < 9; ++i)
        out(Eigen::Index(i / 3), Eigen::Index(i % 3)) = n[i / 3 * columns + i % 3];
    return out;
}

/// The similarity of a matrix, which is given as 16 numbers in row-major order.
Similarity from_matrix(const XmlFile& file, pugi::xml_node transform) {
    const std::vector<double> n = file.numbers(transform, 16);
    Similarity out{by_rows(n, 4), {n[3], n[7], n[11]}, 1};
    out.scale = std::cbrt(out.R.determinant());
    if (!(out.scale > 0))
        file.fail(transform, "a rotation and a scale", "a matrix with a reflection, or none");
    out.R /= out.scale;
    return out;
}

/// The transform to the frame of the mesh; missing parts are the identity.
Similarity chunk_transform(const XmlFile& file, pugi::xml_node transform) {
    Similarity out;
    if (!transform) return out;
    const pugi::xml_node rotation = transform.child("rotation"), translation = transform.child("translation");
    if (!rotation && !translation && !transform.child("scale") && transform.text())
        return from_matrix(file, transform);
    if (rotation) out.R = by_rows(file.numbers(rotation, 9), 3);
    if (translation) {
        const std::vector<double> t = file.numbers(translation, 3);
        out.t = {t[0], t[1], t[2]};
    }
    out.scale = file.number(transform, "scale", 1);
    if (!(out.scale > 0)) file.fail(transform, "a scale above 0", std::to_string(out.scale));
    return out;
}

/// P1 and P2 of Metashape are p2 and p1 of OpenCV, but PhotoScan before 1.0 used OpenCV's order.
Camera calibrated(const XmlFile& file, pugi::xml_node c, pugi::xml_node size) {
    const auto value = [&](const char* name) { return file.number(c, name, 0); };
    Camera out;
    Intrinsics& k = out.intrinsics;
    if (!size) file.fail(c, "a <resolution> here or in its sensor", "none");
    k.width = file.size(size, file.attribute(size, "width"));
    k.height = file.size(size, file.attribute(size, "height"));
    const bool old = bool(c.child("fx"));
    k.fy = file.number(c, old ? "fy" : "f");
    k.fx = old ? value("fx") : k.fy + value("b1");
    k.cx = value("cx") + (old ? 0 : k.width / 2.0);
    k.cy = value("cy") + (old ? 0 : k.height / 2.0);
    if (!(k.fx > 0 && k.fy > 0)) file.fail(c, "a focal length above 0", std::to_string(k.fx));
    const double p1 = value(old ? "p1" : "p2"), p2 = value(old ? "p2" : "p1");
    out.lens = brown_lens({value("k1"), value("k2"), value("k3"), value("k4")}, p1, p2,
                          value(old ? "skew" : "b2") / k.fx);
    return out;
}

/// A sensor: a camera without a pose, or the reason why it is unusable.
struct Sensor {
    Camera camera;
    std::string why_not{};
};

/// A sensor that was never calibrated: it has only the camera's nominal values, in millimeters.
Sensor uncalibrated(const XmlFile& file, pugi::xml_node sensor) {
    const auto value = [&](const char* name, double otherwise) {
        const pugi::xml_node p = sensor.find_child_by_attribute("property", "name", name);
        return p ? file.attribute(p, "value") : otherwise;
    };
    const double focal = value("focal_length", 0), across = value("pixel_width", 0),
                 down = value("pixel_height", across);
    const pugi::xml_node size = sensor.child("resolution");
    const char* lacks = !(focal > 0)    ? "property focal_length"
                        : !(across > 0) ? "property pixel_width"
                        : !(down > 0)   ? "property pixel_height"
                        : !size         ? "resolution"
                                        : nullptr;
    if (lacks) return {{}, std::string("has no calibrated focal length, and no ") + lacks};
    Camera out;
    Intrinsics& k = out.intrinsics;
    k.width = file.size(size, file.attribute(size, "width"));
    k.height = file.size(size, file.attribute(size, "height"));
    k.fx = focal / across;
    k.fy = focal / down;
    k.cx = k.width / 2.0;
    k.cy = k.height / 2.0;
    return {out};
}

/// The reason why the lens of a sensor or a calibration is unusable; empty if it is usable.
std::string flaw_of(pugi::xml_node lens) {
    const std::string type = lens.attribute("type").value();
    if (!type.empty() && type != "frame") return "has a lens of type '" + type + "', expected 'frame'";
    if (lens.child("corrections")) return "has Fourier corrections, which are not supported";
    return {};
}

/// The <resolution> of the first of these nodes that has one.
pugi::xml_node size_of(std::initializer_list<pugi::xml_node> nodes) {
    for (const pugi::xml_node n : nodes)
        if (const pugi::xml_node size = n.child("resolution")) return size;
    return {};
}

Sensor read_sensor(const XmlFile& file, pugi::xml_node sensor) {
    pugi::xml_node best;
    for (const pugi::xml_node c : sensor.children("calibration"))
        if (!best || std::string_view(c.attribute("class").value()) == "adjusted") best = c;
    for (const pugi::xml_node lens : {sensor, best})
        if (const std::string flaw = flaw_of(lens); !flaw.empty()) return {{}, flaw};
    if (!best || !(best.child("f") || best.child("fx"))) return uncalibrated(file, sensor);
    if (sensor.child("rolling_shutter") || best.child("rolling_shutter"))
        return {{}, "has a rolling shutter, which is not supported"};
    return {calibrated(file, best, size_of({best, sensor}))};
}

bool is_enabled(pugi::xml_node camera) {
    const std::string_view value = camera.attribute("enabled").value();
    return value != "0" && value != "false";
}

/// The poses of a chunk, or of the collection that PhotoScan wrote before 1.0.
class Chunk {
  public:
    Chunk(const XmlFile& file, pugi::xml_node chunk) : file_(file), chunk_(chunk) {
        for (const pugi::xml_node s : chunk.child("sensors").children("sensor"))
            sensors_[s.attribute("id").value()] = s;
        own_ = chunk_transform(file, chunk.child("transform"));
        for (const pugi::xml_node c : chunk.child("components").children("component"))
            components_[c.attribute("id").value()] = chunk_transform(file, c.child("transform"));
        for (const pugi::xml_node c : chunk.child("cameras").children()) read(c, "");
    }
    void move_to(CameraSet& set) {
        set.entries = std::move(entries_);
        set.transform = first_;
        skipped_.tell(set.warnings);
        // In a coordinate system that is not local, camera positions are geocentric, but the mesh is exported
        // in projected coordinates.
        const std::string system = chunk_.child_value("reference");
        if (!system.empty() && !system.starts_with("LOCAL_CS"))
            set.warnings.push_back(
                "the chunk has the coordinate system " + system.substr(0, 60) +
                (system.size() > 60 ? "..." : "") +
                ": a mesh fits its cameras only if both are exported in local coordinates");
    }
    const SkippedCameras& skipped() const { return skipped_; }
    std::size_t posed() const { return entries_.size(); }
    std::string label() const { return chunk_.attribute("label").value(); }

  private:
    /// Cameras may be in groups, possibly the folders of their photos.
    void read(pugi::xml_node node, const std::string& group) {
        if (std::string_view(node.name()) == "group") {
            const std::string own = node.attribute("label").value();
            for (const pugi::xml_node c : node.children())
                read(c, own.empty() ? group : group.empty() ? own : group + "/" + own);
        }
        if (std::string_view(node.name()) != "camera") return;
        const std::string photo = node.attribute("label").value();
        if (!is_enabled(node)) return skipped_.add(photo, "disabled");
        if (node.attribute("master_id")) return skipped_.add(photo, "a rig's further camera");
        if (!node.child("transform")) return skipped_.add(photo, "no pose");
        const Sensor sensor = sensor_of(node);
        if (!sensor.why_not.empty()) return skipped_.add(photo, sensor.why_not);
        Camera camera = sensor.camera;
        camera.cam_from_world = pose_of(node);
        if (entries_.empty()) first_ = transform_of(node);
        entries_.push_back({.photo = photo, .camera = camera, .group = group});
    }
    Sensor sensor_of(pugi::xml_node camera) {
        const std::string id = camera.attribute("sensor_id").value();
        const auto found = sensors_.find(id);
        if (const pugi::xml_node own = camera.child("calibration")) {
            const pugi::xml_node sensor = found == sensors_.end() ? pugi::xml_node() : found->second;
            for (const pugi::xml_node lens : {own, sensor})
                if (const std::string flaw = flaw_of(lens); !flaw.empty())
                    return {{}, "its calibration " + flaw};
            return {calibrated(file_, own, size_of({own, camera, sensor}))};
        }
        if (found == sensors_.end()) file_.fail(camera, "the sensor that sensor_id names", "none");
        const auto [sensor, first] = read_.try_emplace(id);
        if (first) {
            sensor->second = read_sensor(file_, found->second);
            std::string& why = sensor->second.why_not;
            if (!why.empty()) why = "its sensor " + id + " " + why;
        }
        return sensor->second;
    }
    /// The transform from the chunk to the mesh.
    const Similarity& transform_of(pugi::xml_node camera) const {
        const auto component = components_.find(camera.attribute("component_id").value());
        return component == components_.end() ? own_ : component->second;
    }
    Pose pose_of(pugi::xml_node camera) const {
        const Similarity& world = transform_of(camera);
        const Similarity in_chunk = from_matrix(file_, camera.child("transform"));
        return from_camera_to_world(world.R * in_chunk.R, world(in_chunk.t));
    }

    const XmlFile& file_;
    pugi::xml_node chunk_;
    std::map<std::string, pugi::xml_node> sensors_;
    std::map<std::string, Sensor> read_;  ///< the sensors of posed cameras
    std::map<std::string, Similarity> components_;
    Similarity own_, first_;
    std::vector<CameraSet::Entry> entries_;
    SkippedCameras skipped_;
};

}  // namespace

CameraSet read_metashape(const std::filesystem::path& path) {
    const XmlFile file(path);
    std::vector<Chunk> chunks;
    for (const pugi::xml_node c : file.child("document").children("chunk")) chunks.emplace_back(file, c);
    if (const pugi::xml_node old = file.child("collection")) chunks.emplace_back(file, old);
    if (chunks.empty())
        throw NoCamera(path.string() + ": expected cameras of Metashape (a chunk), found none");
    const auto most = std::ranges::max_element(chunks, {}, &Chunk::posed);
    CameraSet set{"Metashape", {}, {}};
    for (const Chunk& c : chunks)
        if (&c != &*most && c.posed() > 0)
            set.warnings.push_back("chunk '" + c.label() + "': not used, has " + std::to_string(c.posed()) +
                                   " cameras; '" + most->label() + "' has " + std::to_string(most->posed()));
    if (most->posed() == 0) most->skipped().fail(path);
    most->move_to(set);
    return set;
}

}  // namespace vantage
