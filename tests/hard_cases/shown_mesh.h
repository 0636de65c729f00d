#pragma once
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <numeric>

#include "base/gl/context.h"
#include "base/text/error.h"
#include "base/values/tiling.h"
#include "pipeline/formats/meshes/read_mesh.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/reports/check.h"
#include "player/measure/bench/finite_targets.h"
#include "player/render/picture.h"
#include "scene/agreement/read_level.h"
#include "scene/package/package_reader.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

namespace vantage {

class Geometry : public TemporaryFolder {
  protected:
    using Type = package::Type;
    const gl::HeadlessContext context{gl::Debug::on};
    SceneInput scene;

    void SetUp() override {
        TemporaryFolder::SetUp();
        SynthSpec spec = spec_named("tiny");
        spec.photos.count = 2;
        spec.photos.arc = 25;
        spec.photos.samples = 1;
        spec.photos.width = 200;
        spec.photos.height = 150;
        spec.object.triangles = 1500;
        copy_scene(spec, dir / "scene");
        scene = read_scene(discover(dir / "scene"));
    }

    /// Writes a mesh, valid or not, to a PLY file.
    std::filesystem::path written(const Mesh& mesh) const {
        const std::filesystem::path file = dir / "mesh.ply";
        std::ofstream out(file, std::ios::binary);
        out << fmt::format("ply\nformat ascii 1.0\nelement vertex {}\n", mesh.positions.size());
        for (const char* name : {"double x", "double y", "double z"}) out << "property " << name << '\n';
        if (!mesh.normals.empty())
            for (const char* name : {"float nx", "float ny", "float nz"}) out << "property " << name << '\n';
        out << fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                           mesh.triangles.size());
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const Eigen::Vector3d& p = mesh.positions[v];
            out << fmt::format("{} {} {}", p.x(), p.y(), p.z());
            if (!mesh.normals.empty())
                out << fmt::format(" {} {} {}", mesh.normals[v].x(), mesh.normals[v].y(),
                                   mesh.normals[v].z());
            out << '\n';
        }
        for (const auto& t : mesh.triangles) out << fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
        return file;
    }

    struct Result {
        std::vector<std::string> warnings;
        std::vector<Picture> pictures;  ///< pictures from each photo's camera, in each blend mode
        std::vector<double> seen;       ///< fraction of the vertices that each photo sees
        std::size_t triangles = 0;
    };
    /// Reads, prepares, checks and renders a mesh. The package must be valid, and all values must be finite.
    Result shown(const Mesh& mesh, const std::function<void(SceneInput&)>& change = {}) {
        Result out;
        SceneInput with = scene;
        with.mesh = read_mesh(written(mesh), out.warnings);
        if (change) change(with);
        const std::filesystem::path file = dir / "a.vantage";
        PrepareSettings settings;
        settings.vertex_coordinates = true;
        prepare(with, settings, file, [](const Progress&) {});
        for (const Issue& i : check_package(file, {.deep = true})) ADD_FAILURE() << i.text;
        const PackageReader reader(file);
        expect_finite(reader);
        Renderer renderer(reader, {});
        std::vector<std::uint32_t> photos(reader.photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
        for (const std::uint32_t photo : photos) {
            out.seen.push_back(reader.photos()[photo].visible_vertices);
            for (const Blend blend : {Blend::lumigraph, Blend::average, Blend::best}) {
                RenderSettings s;
                s.blend = blend;
                s.fill_holes = true;
                out.pictures.push_back(
                    take_picture(renderer, view_of_photo(reader.photos()[photo], 1), s, photos, 1));
                EXPECT_EQ(count_non_finite(renderer.resources().targets).all(), 0u) << "blend " << int(blend);
            }
        }
        out.triangles = std::size_t(reader.scene().triangles);
        return out;
    }

    static void expect_all_finite(std::span<const float> values, const char* what) {
        EXPECT_TRUE(std::ranges::all_of(values, [](float v) { return std::isfinite(v); })) << what;
    }
    static void expect_finite(const PackageReader& reader) {
        const package::SceneRecord& s = reader.scene();
        EXPECT_TRUE(std::isfinite(s.reference_density) && s.reference_density > 0);
        expect_all_finite(reader.records<float>(Type::positions), "positions");
        expect_all_finite(reader.records<float>(Type::normals), "normals");
        for (const auto& c : reader.records<package::ClusterRecord>(Type::clusters))
            expect_all_finite({c.center, 8}, "clusters");
        for (std::uint32_t i = 0; i < reader.photos().size(); ++i) {
            const package::PhotoRecord& p = reader.photos()[i];
            for (const double v :
                 {p.corrected_direction[0], p.corrected_direction[1], p.corrected_direction[2], p.hull_area,
                  p.seen_distance, p.z_min, p.z_max, p.visible_vertices})
                EXPECT_TRUE(std::isfinite(v)) << p.name;
            EXPECT_NEAR(Eigen::Map<const Eigen::Vector3d>(p.corrected_direction).norm(), 1, 1e-6);
            expect_all_finite(reader.records<float>(Type::coordinates, i), "coordinates");
            const auto depth = read_level(reader, p, i, Type::depth, weight_map_level);
            for (std::size_t t = 0; t < depth.size(); t += 4) {
                float z;
                std::memcpy(&z, &depth[t], 4);
                ASSERT_TRUE(z > 0) << "depth of " << p.name;  // infinite if nothing is seen
            }
        }
    }

    /// Expects all but a few pixels of two pictures to be equal.
    static void expect_same(const std::vector<Picture>& a, const std::vector<Picture>& b) {
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            std::size_t differ = 0;
            for (std::size_t c = 0; c < a[i].rgba.size(); ++c)
                differ += std::abs(int(a[i].rgba[c]) - int(b[i].rgba[c])) > 6;
            EXPECT_LT(double(differ), 1e-3 * double(a[i].rgba.size())) << "picture " << i;
        }
    }

    static std::uint32_t add(Mesh& mesh, const Eigen::Vector3d& p) {
        mesh.positions.push_back(p);
        mesh.normals.emplace_back(0, 0, 1);
        return std::uint32_t(mesh.positions.size() - 1);
    }
    /// Takes its arguments by value, because they may be elements of the mesh.
    static void add(Mesh& mesh, Eigen::Vector3d a, Eigen::Vector3d b, Eigen::Vector3d c) {
        const std::uint32_t i = add(mesh, a), j = add(mesh, b), k = add(mesh, c);
        mesh.triangles.push_back({i, j, k});
    }
    void expect_rejected(const Mesh& mesh, const std::string& words) {
        try {
            shown(mesh);
            ADD_FAILURE() << "was accepted, expected: " << words;
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::input);
            const std::string text = e.what();
            EXPECT_NE(text.find(words), std::string::npos) << text;
            EXPECT_EQ(text.find('\n'), std::string::npos) << text;
            EXPECT_NE(text.find(".ply"), std::string::npos) << text;
        }
    }
};

}  // namespace vantage
