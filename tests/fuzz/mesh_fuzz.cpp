// OBJ, STL and OFF meshes. The first byte is the format (o: OBJ, s: STL, f: OFF), the rest the file. Checks
// that indices are in range and normals finite.
#include <cstdlib>

#include "pipeline/formats/import/mesh.h"
#include "scene/error.h"
#include "tests/fuzz/memory_file.h"

using namespace vantage;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    static const fuzz::MemoryFolder folder;
    const char* name = data[0] == 'o' ? "mesh.obj" : data[0] == 's' ? "mesh.stl" : "mesh.off";
    folder.set(name, fuzz::text_of(data + 1, size - 1));
    try {
        std::vector<std::string> warnings;
        const Mesh mesh = read_mesh(folder.path() / name, warnings);
        for (const auto& t : mesh.triangles)
            for (const std::uint32_t v : t)
                if (v >= mesh.positions.size()) std::abort();
        for (const Eigen::Vector3f& n : mesh.normals)
            if (!n.allFinite()) std::abort();
    } catch (const Error&) {
    }
    return 0;
}
