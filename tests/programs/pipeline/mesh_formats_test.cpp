// Tests that a real scan gives the same package if its mesh is in another format.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <sstream>

#include "pipeline/formats/meshes/read_mesh.h"
#include "scene/package/package_reader.h"
#include "tests/datasets.h"
#include "tests/gltf_file.h"
#include "tests/temporary_folder.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

class MeshFormats : public TemporaryFolder {
  protected:
    /// The program's output.
    std::string run(const std::string& words, int expected = 0) const {
        const fs::path says = dir / "says";
        const int status =
            std::system((VANTAGE_PROGRAM " " + words + " >" + says.string() + " 2>&1").c_str());
        EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, expected) << slurp(says);
        return slurp(says);
    }
    /// Prepares the scan in a folder that already contains the mesh.
    fs::path prepared(const fs::path& folder, const fs::path& scan) const {
        for (const char* part : {"images", "sparse"}) fs::create_symlink(scan / part, folder / part);
        const fs::path package = folder.string() + ".vantage";
        run("prepare " + folder.string() + " -o " + package.string() + " --no-report --refine off");
        return package;
    }
};

TEST_F(MeshFormats, MakeTheSamePackageOfARealScan) {
    VANTAGE_DATASET(real, "sceaux-small");
    const fs::path scan = fs::absolute(real);
    for (const char* folder : {"ply", "glb"}) fs::create_directories(dir / folder);
    fs::create_symlink(scan / "mesh.ply", dir / "ply/mesh.ply");
    std::vector<std::string> warnings;
    std::ofstream(dir / "glb/mesh.glb", std::ios::binary)
        << gltf_of(read_mesh(scan / "mesh.ply", warnings)).glb();
    const fs::path ply = prepared(dir / "ply", scan), glb = prepared(dir / "glb", scan);

    std::istringstream differences(run("diff " + ply.string() + " " + glb.string(), int(Exit::different)));
    for (std::string line; std::getline(differences, line);)
        EXPECT_TRUE(line.starts_with("inputs: ") || line == "model: normals: different") << line;
    // The normals have been normalized again, so they may differ slightly.
    const PackageReader one(ply), other(glb);
    const auto a = one.records<Eigen::Vector3f>(package::Type::normals),
               b = other.records<Eigen::Vector3f>(package::Type::normals);
    for (std::size_t v = 0; v < a.size(); ++v) ASSERT_LT((a[v] - b[v]).norm(), 1e-6f) << v;
}

}  // namespace
}  // namespace vantage
