#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "scene/package/contents/mesh.h"

namespace vantage {

/// A glTF 2.0 file, written according to the specification (Khronos 2021), with one buffer and hand-written
/// JSON.
struct GltfFile {
    std::string bytes;                            ///< of the buffer
    std::string views, accessors, meshes, nodes;  ///< the items of these JSON lists
    std::string roots = "0";                      ///< the root nodes of the scene
    std::string more;  ///< further members of the root object, each preceded by a comma

    /// Appends values of `n` numbers each to the buffer; returns the index of their accessor.
    template <class T, std::size_t n>
    std::string add(const std::vector<std::array<T, n>>& values) {
        constexpr const char* types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
        const std::string count = std::to_string(count_++),
                          size = std::to_string(values.size() * n * sizeof(T));
        item(views, "{\"buffer\": 0, \"byteOffset\": " + std::to_string(bytes.size()) +
                        ", \"byteLength\": " + size + "}");
        item(accessors, "{\"bufferView\": " + count + ", \"componentType\": " + component<T>() +
                            ", \"count\": " + std::to_string(values.size()) + ", \"type\": \"" +
                            types[n - 1] + "\"}");
        bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * n * sizeof(T));
        bytes.resize((bytes.size() + 3) / 4 * 4);
        return count;
    }
    /// Adds a mesh with one primitive that has the given members: attributes, indices, mode.
    void add_mesh(const std::string& primitive) { item(meshes, "{\"primitives\": [{" + primitive + "}]}"); }
    void add_node(const std::string& members) { item(nodes, "{" + members + "}"); }

    /// Returns the JSON. `uri` is the file that contains the buffer; it is empty for a .glb.
    std::string json(const std::string& uri = "") const {
        return "{\"asset\": {\"version\": \"2.0\"}, \"scene\": 0, \"scenes\": [{\"nodes\": [" + roots +
               "]}], \"nodes\": [" + nodes + "], \"meshes\": [" + meshes + "], \"accessors\": [" + accessors +
               "], \"bufferViews\": [" + views + "], \"buffers\": [{" +
               (uri.empty() ? "" : "\"uri\": \"" + uri + "\", ") +
               "\"byteLength\": " + std::to_string(bytes.size()) + "}]" + more + "}";
    }
    std::string glb() const {
        std::string text = json();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        const std::string chunks = word(std::uint32_t(text.size())) + "JSON" + text +
                                   word(std::uint32_t(bytes.size())) + std::string("BIN\0", 4) + bytes;
        return "glTF" + word(2) + word(std::uint32_t(12 + chunks.size())) + chunks;
    }

  private:
    template <class T>
    static std::string component() {
        if (sizeof(T) == 1) return "5121, \"normalized\": true";
        return sizeof(T) == 2 ? "5123" : std::is_integral_v<T> ? "5125" : "5126";
    }
    static void item(std::string& list, const std::string& text) {
        list += (list.empty() ? "" : ", ") + text;
    }
    static std::string word(std::uint32_t v) { return {reinterpret_cast<const char*>(&v), sizeof v}; }

    int count_ = 0;
};

/// A glTF file with positions as floats, normals if the mesh has any, and triangles, in one node without a
/// transform.
inline GltfFile gltf_of(const Mesh& mesh) {
    GltfFile out;
    std::vector<std::array<float, 3>> positions, normals;
    std::vector<std::array<std::uint32_t, 1>> corners;
    for (const Eigen::Vector3d& p : mesh.positions)
        positions.push_back({float(p.x()), float(p.y()), float(p.z())});
    for (const Eigen::Vector3f& n : mesh.normals) normals.push_back({n.x(), n.y(), n.z()});
    for (const auto& t : mesh.triangles)
        for (const std::uint32_t v : t) corners.push_back({v});
    std::string attributes = "\"POSITION\": " + out.add(positions);
    if (!normals.empty()) attributes += ", \"NORMAL\": " + out.add(normals);
    out.add_mesh("\"attributes\": {" + attributes + "}, \"indices\": " + out.add(corners));
    out.add_node("\"mesh\": 0");
    return out;
}

}  // namespace vantage
