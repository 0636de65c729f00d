#pragma once
#include <cmath>
#include <filesystem>
#include <numbers>
#include <vector>

#include "pipeline/synth/garden.h"
#include "pipeline/synth/model_builder.h"
#include "tests/programs/scan_of_model.h"

/// Synthetic scans of five kinds, with z up. Each consists of a mesh, the worlds that the photos show, and
/// cameras.
namespace vantage::places {

using Eigen::Vector3d;

struct Place {
    SynthModel mesh;
    std::vector<SynthModel> worlds;  ///< each shown by an equal number of the photos, in order
    std::vector<Camera> cameras;
};

inline Camera camera_at(const Vector3d& eye, const Vector3d& target, double f = 380) {
    Camera c;
    c.intrinsics = {480, 360, f, f, 240, 180};
    c.cam_from_world = look_at(eye, target);
    return c;
}

/// Places `count` cameras on a ring about the z axis, at two heights, starting at an angle in radians.
inline std::vector<Camera> ring(int count, double radius, double low, double high, const Vector3d& target,
                                double from = 0, double arc = 2 * std::numbers::pi) {
    std::vector<Camera> out;
    for (int i = 0; i < count; ++i) {
        const double angle = from + arc * i / count;
        out.push_back(
            camera_at({radius * std::sin(angle), -radius * std::cos(angle), i % 2 ? high : low}, target));
    }
    return out;
}

/// A bust on a plinth.
inline void bust(ModelBuilder& b) {
    b.box({0, 0, 0.25}, {0.2, 0.15, 0.25}, Material::marble);
    b.box({0, 0, 0.6}, {0.1, 0.12, 0.1}, Material::brick);
    b.box({0.02, -0.12, 0.62}, {0.02, 0.03, 0.03}, Material::text);
}

/// The floor, walls and ceiling of a room, facing inward. With three walls, the side toward +x is open.
inline void room(ModelBuilder& b, const Vector3d& low, const Vector3d& size, bool ceiling = true,
                 int walls = 4) {
    const Vector3d x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
    b.quad(low, x, y, Material::paving);
    if (ceiling) b.quad(low + z, y, x, Material::plaster);
    b.quad(low, z, x, Material::brick);
    b.quad(low + y, x, z, Material::text);
    b.quad(low, y, z, Material::grating);
    if (walls == 4) b.quad(low + x, z, y, Material::window);
}

/// The model, rotated about a point.
inline SynthModel turned(SynthModel m, const Eigen::Matrix3d& R, const Vector3d& about) {
    for (Vector3d& p : m.mesh.positions) p = about + R * (p - about);
    for (Eigen::Vector3f& n : m.mesh.normals) n = R.cast<float>() * n;
    return m;
}

inline Eigen::Matrix3d turn(double angle, const Vector3d& axis) {
    return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

inline SynthModel joined(SynthModel a, const SynthModel& b) {
    const auto first = std::uint32_t(a.mesh.positions.size());
    a.mesh.positions.insert(a.mesh.positions.end(), b.mesh.positions.begin(), b.mesh.positions.end());
    a.mesh.normals.insert(a.mesh.normals.end(), b.mesh.normals.begin(), b.mesh.normals.end());
    for (auto t : b.mesh.triangles) {
        for (auto& corner : t) corner += first;
        a.mesh.triangles.push_back(t);
    }
    a.materials.insert(a.materials.end(), b.materials.begin(), b.materials.end());
    a.clouds |= b.clouds;
    return a;
}

inline SynthModel built(const auto& build) {
    ModelBuilder b{{}, 0};
    build(b);
    return std::move(b.model);
}

/// A room with a table, on which the bust stands off-center.
inline SynthModel study() {
    return built([](ModelBuilder& b) {
        room(b, {-2.6, -2.2, -0.9}, {4.9, 4.6, 2.9});
        b.box({0.1, 0.2, -0.05}, {0.8, 0.6, 0.05}, Material::paving);
        b.box({0.5, 0.45, 0.1}, {0.12, 0.08, 0.1}, Material::grating);
        b.box({-0.5, -0.1, 0.05}, {0.1, 0.06, 0.05}, Material::text);
    });
}

/// An object that is photographed from all sides, then laid on its back and photographed again.
inline Place moved_object() {
    Place p{built(bust), {}, ring(10, 1.5, 0.5, 1, {0, 0, 0.35})};
    const Vector3d about(0, 0, 0.35);
    const Eigen::Matrix3d laid = turn(std::numbers::pi / 2, Vector3d::UnitX());
    for (Camera c : ring(8, 1.4, 0.5, 0.9, about, 0.2)) {
        // In the object's frame, the room and the cameras are rotated.
        Pose& pose = c.cam_from_world;
        const Vector3d eye = about + laid * (pose.center() - about);
        pose.R = pose.R * laid.transpose();
        pose.t = -pose.R * eye;
        p.cameras.push_back(c);
    }
    p.cameras.resize(16);
    p.worlds = {joined(p.mesh, study()), joined(p.mesh, turned(study(), laid, about))};
    return p;
}

/// An object on a turntable in front of a fixed camera: in the object's frame, the room turns with each
/// photo.
inline Place turned_object() {
    Place p{built(bust), {}, ring(12, 1.5, 0.6, 0.6, {0, 0, 0.35})};
    for (int i = 0; i < 12; ++i)
        p.worlds.push_back(joined(
            p.mesh,
            turned(study(), turn(2 * std::numbers::pi * i / 12, Vector3d::UnitZ()), Vector3d::Zero())));
    return p;
}

/// A monument in a garden, photographed once all the way around.
inline Place monument() {
    Place p{built([](ModelBuilder& b) {
                b.box({0, 0, 1}, {1.5, 1.2, 1}, Material::marble);
                b.box({0, 0, 3}, {0.6, 0.6, 1}, Material::brick);
            }),
            {},
            ring(16, 9, 1.6, 2.4, {0, 0, 1.8})};
    ModelBuilder b{p.mesh, 0};
    add_garden(b, {.radius = 30, .hill = 8, .railing = 0});
    p.worlds = {b.model};
    return p;
}

/// Four facades around a courtyard, photographed from inside.
inline Place courtyard(bool open_side) {
    Place p{built([&](ModelBuilder& b) {
                room(b, {-8, -8, 0}, {16, 16, 7}, false, open_side ? 3 : 4);
                b.box({1, 2, 0.5}, {0.8, 0.8, 0.5}, Material::marble);
            }),
            {},
            {}};
    for (int i = 0; i < 16; ++i) {
        const double angle = 2 * std::numbers::pi * i / 16;
        const Vector3d out(std::sin(angle), -std::cos(angle), 0);
        p.cameras.push_back(camera_at(4.5 * out + Vector3d(0, 0, 1.6), -6 * out + Vector3d(0, 0, 4), 280));
    }
    ModelBuilder b{p.mesh, 0};
    if (open_side) add_garden(b, {.radius = 30, .hill = 8, .railing = 0});
    b.model.clouds = true;
    p.worlds = {b.model};
    return p;
}

/// Houses in aerial photos, which show more of the surroundings than the mesh contains.
inline Place block(double tilt) {
    Place p{built([](ModelBuilder& b) {
                b.quad({-30, -30, 0}, {60, 0, 0}, {0, 60, 0}, Material::paving);
                for (int i = 0; i < 9; ++i)
                    b.box({20.0 * (i % 3 - 1), 20.0 * (i / 3 - 1), 3.0 + i % 4}, {6, 5, 3.0 + i % 4},
                          i % 2 ? Material::brick : Material::roof);
            }),
            {},
            {}};
    for (int row = 0; row < 3; ++row)
        for (int i = 0; i < 5; ++i) {
            const Vector3d eye(12.0 * (i - 2), 14.0 * (row - 1) - tilt, 40);
            p.cameras.push_back(camera_at(eye, eye + Vector3d(0.01, tilt + 0.5, -40)));
        }
    ModelBuilder b{p.mesh, 0};
    add_garden(b, {.radius = 120, .hill = 12, .railing = 0});
    p.worlds = {b.model};
    return p;
}

inline void write(const std::filesystem::path& folder, const Place& place) {
    write_scan(folder, place.mesh, place.cameras, {}, place.worlds);
}

}  // namespace vantage::places
