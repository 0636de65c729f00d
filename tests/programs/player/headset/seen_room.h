#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "player/headset/locomotion/room_pose.h"
#include "player/plan/plan_scene.h"
#include "player/view/view.h"

namespace vantage {

using Eigen::Vector3d;
using nlohmann::json;

/// The scene as seen from the eyes' positions in the room, computed by hand. The room is level, its -z axis
/// is the photo's viewing direction, and the head was at the photo's camera when tracking started.
struct Room {
    Eigen::Matrix3d axes;
    Vector3d at;
    double scale;

    Room(const package::PhotoRecord& photo, const Vector3d& up, const Vector3d& head, double units_per_meter)
        : scale(units_per_meter) {
        const Pose camera = view_of_photo(photo, 1).cam_from_origin;
        const Vector3d ahead = camera.R.row(2), z = -(ahead - up * up.dot(ahead)).normalized();
        axes << up.cross(z), up, z;
        at = camera.center() - scale * (axes * head);
    }
    Vector3d in_scene(const Vector3d& p) const { return at + scale * (axes * p); }
    Vector3d in_room(const Vector3d& p) const { return axes.transpose() * (p - at) / scale; }
    /// The scene's view for `submitted`, which is a view from frames.jsonl.
    View view(const json& submitted) const {
        const auto& p = submitted["position"];
        const auto& q = submitted["orientation"];
        const auto tangent = [&](int i) { return std::tan(submitted["fov"][std::size_t(i)].get<double>()); };
        const int width = submitted["rect"][2], height = submitted["rect"][3];
        View out;
        Intrinsics& k = out.intrinsics;
        k.width = width, k.height = height;
        k.fx = width / (tangent(1) - tangent(0));
        k.fy = height / (tangent(2) - tangent(3));
        k.cx = -tangent(0) * k.fx;
        k.cy = tangent(2) * k.fy;
        const Eigen::Quaterniond turn(q[3].get<double>(), q[0].get<double>(), q[1].get<double>(),
                                      q[2].get<double>());
        const Eigen::Matrix3d eye_in_scene = axes * turn.normalized().toRotationMatrix();
        out.cam_from_origin.R << eye_in_scene.col(0).transpose(), -eye_in_scene.col(1).transpose(),
            -eye_in_scene.col(2).transpose();
        out.cam_from_origin.t =
            -out.cam_from_origin.R * in_scene({p[0].get<double>(), p[1].get<double>(), p[2].get<double>()});
        return out;
    }
};

/// The pose of an eye in frames.jsonl.
inline RoomPose eye_pose(const json& view) {
    const auto number = [&](const char* of, std::size_t i) { return double(view[of][i].get<float>()); };
    return {Eigen::Quaterniond(number("orientation", 3), number("orientation", 0), number("orientation", 1),
                               number("orientation", 2))
                .normalized(),
            {number("position", 0), number("position", 1), number("position", 2)}};
}

/// The head's pose, midway between two eyes.
inline RoomPose head_between(const json& views) {
    const RoomPose left = eye_pose(views[0]), right = eye_pose(views[1]);
    return {left.turn.slerp(0.5, right.turn), (left.at + right.at) / 2};
}

/// The distance in meters along the eye's axis at a pixel of a saved depth picture. The pixel is counted from
/// the upper left corner; `submitted` is the picture's view.
inline double distance_at(const fs::path& pfm, const json& submitted, int x, int y) {
    std::ifstream in(pfm, std::ios::binary);
    std::string kind;
    int width = 0, height = 0;
    double order = 0;
    in >> kind >> width >> height >> order;
    in.get();
    std::vector<float> rows(std::size_t(width) * std::size_t(height));
    in.read(reinterpret_cast<char*>(rows.data()), std::streamsize(rows.size() * sizeof(float)));
    const double depth = double(rows.at(std::size_t(height - 1 - y) * std::size_t(width) + std::size_t(x)));
    const auto limit = [&](const char* name) {
        const json& at = submitted["depth"][name];
        return at.is_string() ? std::numeric_limits<double>::infinity() : at.get<double>();
    };
    return 1 / (1 / limit("near") + depth * (1 / limit("far") - 1 / limit("near")));
}
inline double middle_distance(const fs::path& pfm, const json& submitted) {
    return distance_at(pfm, submitted, submitted["rect"][2].get<int>() / 2,
                       submitted["rect"][3].get<int>() / 2);
}

using Corners = std::array<Vector3d, 3>;

/// The distance along a ray to a triangle; infinity if the ray misses the triangle.
inline double meets(const Vector3d& from, const Vector3d& along, const Corners& c) {
    Eigen::Matrix3d m;
    m << c[1] - c[0], c[2] - c[0], -along;
    const Vector3d x = m.fullPivLu().solve(from - c[0]);
    const bool inside =
        std::abs(m.determinant()) > 1e-14 && x[0] >= 0 && x[1] >= 0 && x[0] + x[1] <= 1 && x[2] > 0;
    return inside ? x[2] : std::numeric_limits<double>::infinity();
}

/// The triangles of the mesh, without the background.
inline std::vector<Corners> triangles_of(const PlanScene& scene) {
    std::vector<Corners> mesh;
    for (const package::ClusterRecord& c :
         std::span(scene.clusters)
             .first(std::min<std::size_t>(scene.first_surrounding, scene.clusters.size())))
        for (std::size_t t = c.first_triangle; t < c.first_triangle + c.triangles; ++t) {
            Corners& corners = mesh.emplace_back();
            for (std::size_t k = 0; k < 3; ++k)
                corners[k] = scene.positions[scene.indices[3 * t + k]].cast<double>();
        }
    return mesh;
}

/// The distance to a moved mesh along a view's axis at a pixel; infinity if the pixel's ray misses the mesh.
inline double distance_by_hand(const View& view, int x, int y, const std::vector<Corners>& mesh,
                               const Vector3d& moved = Vector3d::Zero()) {
    const Intrinsics& k = view.intrinsics;
    const Vector3d along =
        view.cam_from_origin.R.transpose() * Vector3d((x + 0.5 - k.cx) / k.fx, (y + 0.5 - k.cy) / k.fy, 1);
    double out = std::numeric_limits<double>::infinity();
    for (const Corners& c : mesh) out = std::min(out, meets(view.cam_from_origin.center() - moved, along, c));
    return out;
}

}  // namespace vantage
