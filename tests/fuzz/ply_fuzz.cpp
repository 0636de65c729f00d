// Reads PLY meshes, as text and binary. Checks that every index is valid and that attributes have one value
// per vertex.
#include <cstdlib>

#include "base/text/error.h"
#include "pipeline/formats/meshes/read_mesh.h"
#include "tests/fuzz/support/fuzz_target.h"
#include "tests/fuzz/support/memory_file.h"

using namespace vantage;

FUZZ_TARGET(ply)(const std::uint8_t* data, std::size_t size) {
    static const fuzz::MemoryFolder folder;
    folder.set("mesh.ply", fuzz::text_of(data, size));
    try {
        std::vector<std::string> warnings;
        const Mesh mesh = read_mesh(folder.path() / "mesh.ply", warnings);
        for (const auto& t : mesh.triangles)
            for (const std::uint32_t v : t)
                if (v >= mesh.positions.size()) std::abort();
        const auto fits = [&](std::size_t n) { return n == 0 || n == mesh.positions.size(); };
        if (!fits(mesh.colors.size()) || !fits(mesh.normals.size())) std::abort();
        for (const auto& scalar : mesh.scalars)
            if (scalar.values.size() != mesh.positions.size()) std::abort();
    } catch (const Error&) {
    }
    return 0;
}
