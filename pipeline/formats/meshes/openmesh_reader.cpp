#include "pipeline/formats/meshes/openmesh_reader.h"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <algorithm>
#include <span>
#include <stdexcept>

#include "base/text/error.h"
#include "pipeline/formats/meshes/isolated_process.h"
#include "pipeline/formats/meshes/mesh_bytes.h"
#include "pipeline/formats/meshes/ply.h"
#include "pipeline/formats/meshes/read_mesh.h"

namespace vantage {
namespace {

using namespace OpenMesh;

std::uint8_t to_byte(float v) { return std::uint8_t(std::clamp(v, 0.0f, 1.0f) * 255 + 0.5f); }

/// Collects the mesh from OpenMesh's readers unchanged. The readers trust the counts in the file and read on
/// past its end, so std::length_error is thrown if there are more elements than a file of `bytes` bytes can
/// contain.
class Collector : public IO::BaseImporter {
  public:
    Mesh mesh;

    explicit Collector(std::uint64_t bytes) : max_numbers_(bytes / 2) {}  // the shortest is "0 "

    VertexHandle add_vertex(const Vec3f& p) override { return add_vertex(Vec3d(p)); }
    VertexHandle add_vertex(const Vec3d& p) override {
        if (mesh.positions.size() >= max_numbers_ / 3) throw std::length_error("vertices");
        mesh.positions.emplace_back(p[0], p[1], p[2]);
        return VertexHandle(int(mesh.positions.size()) - 1);
    }
    VertexHandle add_vertex() override { return add_vertex(Vec3d(0, 0, 0)); }
    FaceHandle add_face(const VHandles& corners) override {
        if (faces_ >= max_numbers_ || corners.size() > max_numbers_ - mesh.triangles.size())
            throw std::length_error("corners");
        const auto at = [&](std::size_t i) {
            return exists(corners[i]) ? std::uint32_t(corners[i].idx()) : no_vertex;
        };
        for (std::size_t i = 2; i < corners.size(); ++i) mesh.triangles.push_back({at(0), at(i - 1), at(i)});
        return FaceHandle(int(faces_++));
    }
    void set_point(VertexHandle v, const Vec3f& p) override {
        if (exists(v)) mesh.positions[std::size_t(v.idx())] = {double(p[0]), double(p[1]), double(p[2])};
    }
    void set_normal(VertexHandle v, const Vec3f& n) override {
        if (!exists(v)) return;
        mesh.normals.resize(mesh.positions.size(), Eigen::Vector3f::Zero());
        mesh.normals[std::size_t(v.idx())] = {n[0], n[1], n[2]};
    }
    void set_normal(VertexHandle v, const Vec3d& n) override { set_normal(v, Vec3f(n)); }
    void set_color(VertexHandle v, const Vec4uc& c) override {
        if (!exists(v)) return;
        mesh.colors.resize(mesh.positions.size(), {255, 255, 255, 255});
        mesh.colors[std::size_t(v.idx())] = {c[0], c[1], c[2], c[3]};
    }
    void set_color(VertexHandle v, const Vec3uc& c) override { set_color(v, Vec4uc(c[0], c[1], c[2], 255)); }
    void set_color(VertexHandle v, const Vec4f& c) override {
        set_color(v, Vec4uc(to_byte(c[0]), to_byte(c[1]), to_byte(c[2]), to_byte(c[3])));
    }
    void set_color(VertexHandle v, const Vec3f& c) override { set_color(v, Vec4f(c[0], c[1], c[2], 1)); }
    std::size_t n_vertices() const override { return mesh.positions.size(); }
    std::size_t n_faces() const override { return faces_; }
    std::size_t n_edges() const override { return 0; }

    // Parts of a mesh that are not used.
    HalfedgeHandle add_edge(VertexHandle, VertexHandle) override { return HalfedgeHandle(); }
    FaceHandle add_face(HalfedgeHandle) override { return FaceHandle(); }
    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec2f>&) override {}
    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec3f>&) override {}
    void set_face_texindex(FaceHandle, int) override {}
    void set_halfedge(VertexHandle, HalfedgeHandle) override {}
    void set_texcoord(VertexHandle, const Vec2f&) override {}
    void set_texcoord(VertexHandle, const Vec3f&) override {}
    void set_texcoord(HalfedgeHandle, const Vec2f&) override {}
    void set_texcoord(HalfedgeHandle, const Vec3f&) override {}
    void set_status(VertexHandle, const Attributes::StatusInfo&) override {}
    void set_status(HalfedgeHandle, const Attributes::StatusInfo&) override {}
    void set_status(EdgeHandle, const Attributes::StatusInfo&) override {}
    void set_status(FaceHandle, const Attributes::StatusInfo&) override {}
    void set_next(HalfedgeHandle, HalfedgeHandle) override {}
    void set_face(HalfedgeHandle, FaceHandle) override {}
    void request_face_texcoords2D() override {}
    void set_color(EdgeHandle, const Vec3uc&) override {}
    void set_color(EdgeHandle, const Vec4uc&) override {}
    void set_color(EdgeHandle, const Vec3f&) override {}
    void set_color(EdgeHandle, const Vec4f&) override {}
    void set_normal(FaceHandle, const Vec3f&) override {}
    void set_normal(FaceHandle, const Vec3d&) override {}
    void set_color(FaceHandle, const Vec3uc&) override {}
    void set_color(FaceHandle, const Vec4uc&) override {}
    void set_color(FaceHandle, const Vec3f&) override {}
    void set_color(FaceHandle, const Vec4f&) override {}
    void add_texture_information(int, std::string) override {}

  private:
    bool exists(VertexHandle v) const { return v.idx() >= 0 && std::size_t(v.idx()) < mesh.positions.size(); }
    std::uint64_t max_numbers_, faces_ = 0;
};

}  // namespace

Mesh read_with_openmesh(const std::filesystem::path& file) {
    const std::uint64_t size = std::filesystem::file_size(file);
    const ProcessLimits limits{.bytes = (std::uint64_t(4) << 20) + 64 * size,
                               .seconds = 60 + unsigned(size / 100'000)};
    const auto bytes = run_isolated(limits, [&] {
        Collector in(size);
        IO::Options options = IO::Options::VertexNormal | IO::Options::VertexColor;
        if (!IO::IOManager().read(file.string(), in, options)) return std::vector<std::byte>();
        std::vector<std::byte> out;
        append(out, in.mesh);
        return out;
    });
    if (bytes.empty())
        throw Error(Exit::input, file.string() + ": not a readable mesh; expected " + mesh_format_names);
    Mesh mesh;
    std::span<const std::byte> rest(bytes);
    take(rest, mesh);
    if (!mesh.colors.empty()) mesh.colors.resize(mesh.positions.size(), {255, 255, 255, 255});
    return mesh;
}

}  // namespace vantage
