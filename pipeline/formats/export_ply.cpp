#include "pipeline/formats/export_ply.h"

#include <fmt/format.h>

#include <ostream>

#include "base/files/replace_file.h"
#include "scene/package/output_file.h"

namespace vantage {
namespace {

std::string properties(std::span<const PlyField> fields) {
    std::string out;
    for (const PlyField& field : fields) {
        std::string name = field.name.empty() ? "_" : field.name;
        for (char& c : name)
            if (!(c > ' ' && c <= '~')) c = '_';
        out += "property float " + name + "\n";
    }
    return out;
}

}  // namespace

void write_ply(const std::filesystem::path& file, const PlyMesh& mesh) {
    const char* const color_properties =
        mesh.colors.empty() ? ""
                            : "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                              "property uchar alpha\n";
    replace_file(file, [&](std::ostream& out) {
        out << fmt::format(
            "ply\nformat binary_little_endian 1.0\n{}element vertex {}\nproperty double x\nproperty double "
            "y\n"
            "property double z\nproperty float nx\nproperty float ny\nproperty float nz\n{}{}element face "
            "{}\n"
            "property list uchar int vertex_indices\nend_header\n",
            ply_mark, mesh.positions.size(), color_properties, properties(mesh.fields),
            mesh.triangles.size());
        const auto put = [&](const auto& v) { out.write(reinterpret_cast<const char*>(&v), sizeof v); };
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            put(Eigen::Vector3d(mesh.origin + mesh.positions[i].cast<double>()));
            put(mesh.normals[i]);
            if (!mesh.colors.empty()) put(mesh.colors[i]);
            for (const PlyField& field : mesh.fields) put(field.values[i]);
        }
        for (const auto& t : mesh.triangles) {
            put(std::uint8_t(3));
            put(t);
        }
    });
}

void write_points_ply(const std::filesystem::path& file, std::uint64_t count,
                      const std::function<void(const std::function<void(const PlyPoint&)>&)>& each) {
    replace_file(file, [&](std::ostream& out) {
        out << fmt::format(
            "ply\nformat binary_little_endian 1.0\n{}element vertex {}\nproperty double x\nproperty double "
            "y\n"
            "property double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
            ply_mark, count);
        each([&](const PlyPoint& p) {
            out.write(reinterpret_cast<const char*>(p.position.data()), 24);
            out.write(reinterpret_cast<const char*>(p.color.data()), 3);
        });
    });
}

}  // namespace vantage
