// Reads OBJ, STL, OFF, glTF, GLB and FBX meshes, and the materials of an OBJ. The first byte selects the
// format (o: OBJ, s: STL, f: OFF, g: glTF, b: GLB, x: FBX, m: MTL), and the rest is the file. Checks that
// indices are in range and normals finite, and that attributes have one value per vertex.
#include <cstdlib>

#include "base/text/error.h"
#include "pipeline/formats/meshes/read_mesh.h"
#include "tests/fuzz/support/fuzz_target.h"
#include "tests/fuzz/support/memory_file.h"

using namespace vantage;

FUZZ_TARGET(mesh)(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    static const fuzz::MemoryFolder folder;
    const char* name = data[0] == 'o' || data[0] == 'm' ? "mesh.obj"
                       : data[0] == 's'                 ? "mesh.stl"
                       : data[0] == 'g'                 ? "mesh.gltf"
                       : data[0] == 'b'                 ? "mesh.glb"
                       : data[0] == 'x'                 ? "mesh.fbx"
                                                        : "mesh.off";
    const std::string text(fuzz::text_of(data + 1, size - 1));
    folder.set("mesh.mtl", data[0] == 'm' ? text : "newmtl glass\nKd 0.1 0.5 1\nd 0.3\n");
    folder.set(name, data[0] == 'm' ? "mtllib mesh.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nusemtl glass\n"
                                      "f 1 2 3\nusemtl frame\nf 2 3 4\n"
                                    : text);
    try {
        std::vector<std::string> warnings;
        const Mesh mesh = read_mesh(folder.path() / name, warnings);
        for (const auto& t : mesh.triangles)
            for (const std::uint32_t v : t)
                if (v >= mesh.positions.size()) std::abort();
        if (!mesh.colors.empty() && mesh.colors.size() != mesh.positions.size()) std::abort();
        if (!mesh.normals.empty() && mesh.normals.size() != mesh.positions.size()) std::abort();
        for (const Eigen::Vector3f& n : mesh.normals)
            if (!n.allFinite()) std::abort();
    } catch (const Error&) {
    }
    return 0;
}
