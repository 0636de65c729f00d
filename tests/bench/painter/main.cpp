// Measures the cost of transparent triangles: compares the painter's algorithm on a BSP tree with per-pixel
// fragment lists and with weighted sums. Prints a table in Markdown.
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <optional>
#include <random>

#include "base/gl/context.h"
#include "base/text/error.h"
#include "pipeline/formats/meshes/read_mesh.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/until_stopped.h"
#include "pipeline/synth/synthesize.h"
#include "player/render/picture.h"
#include "tests/bench/painter/bsp_tree.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr std::size_t max_polygons = 8'000'000;

/// The duration of `work` in seconds: the fastest of `runs` runs.
template <class Work>
double seconds(int runs, const Work& work) {
    double best = 1e300;
    for (int i = 0; i < runs; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work();
        best =
            std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return best;
}

/// Randomly oriented triangles of equal size in a cube. The more triangles there are, the more of them
/// intersect each other.
Mesh random_triangles(std::size_t count) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto point = [&] { return Vector3d(unit(random), unit(random), unit(random)); };
    constexpr double size = 0.5;
    Mesh m;
    for (std::uint32_t t = 0; t < count; ++t) {
        const Vector3d middle = 2 * point() + Vector3d(0, 0, 2.5);
        for (int i = 0; i < 3; ++i) m.positions.push_back(middle + size * point());
        m.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    return m;
}

struct Tree {
    std::size_t polygons;
    bool complete;
    double build, traverse;  ///< seconds
};

Tree partitioned(const Mesh& mesh) {
    std::vector<BspTree::Triangle> triangles;
    for (const auto& t : mesh.triangles)
        triangles.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
    std::optional<BspTree> tree;
    Tree out{};
    out.build = seconds(1, [&] { tree.emplace(triangles, 1, max_polygons); });
    std::size_t corners = 0;
    out.traverse = seconds(3, [&] {
        tree->back_to_front({0, -14, 2.5}, [&](const PaintedPolygon& p) { corners += p.corners.size(); });
    });
    out.polygons = tree->polygons(), out.complete = tree->complete() && corners > 0;
    return out;
}

/// Seconds per frame at 1280 x 720, and fragment counts.
struct Frames {
    double exact, approximate, off;
    FrameReport report;
};

Frames drawn(SceneInput input, const Mesh& mesh, const fs::path& file) {
    input.mesh = mesh;
    input.mesh.scalars.clear();
    input.mesh.colors.assign(mesh.positions.size(), {255, 255, 255, 128});
    if (input.mesh.normals.empty()) input.mesh.normals.assign(mesh.positions.size(), {0, -1, 0});
    PrepareSettings settings;
    settings.validate = false;
    settings.effects[Effect::background] = EffectChoice::off;
    fs::remove(file);
    prepare(input, settings, file, [](const Progress&) {});
    const PackageReader package(file);
    const Eigen::AlignedBox3d box = bounds_from_origin(package.scene());
    const View view =
        view_towards(Vector3d(0, -1.6, 0) * box.diagonal().norm(), {0, 0, 0}, {0, 0, 1}, 40, 1280, 720);
    Renderer renderer(package, MemoryBudget{});
    std::vector<std::uint32_t> photos(package.photos().size());
    std::iota(photos.begin(), photos.end(), 0u);
    Frames out{};
    for (const Transparency mode : {Transparency::off, Transparency::approximate, Transparency::exact}) {
        RenderSettings s;
        s.transparency = mode;
        const auto frame = [&] {
            out.report = renderer.draw(view, s, photos, {}, 0);
            glFinish();
        };
        frame();  // compiles the programs
        (mode == Transparency::exact         ? out.exact
         : mode == Transparency::approximate ? out.approximate
                                             : out.off) = seconds(5, frame);
    }
    return out;
}

void print_row(const std::string& name, const Mesh& mesh, const SceneInput& input, const fs::path& file) {
    const Tree tree = partitioned(mesh);
    const Frames frames = drawn(input, mesh, file);
    fmt::print(
        "| {} | {} | {}{} | {:.1f} | {:.2f} s | {:.1f} ms | {:.0f} ms | {:.0f} ms | {:.0f} ms | {} | {} |\n",
        name, mesh.triangles.size(), tree.complete ? "" : "over ", tree.polygons,
        double(tree.polygons) / double(mesh.triangles.size()), tree.build, 1000 * tree.traverse,
        1000 * frames.off, 1000 * frames.exact, 1000 * frames.approximate, frames.report.fragments,
        frames.report.fragments_approximated);
    std::fflush(stdout);
}

int run(int argc, char** argv) {
    const fs::path folder = fs::temp_directory_path() / fmt::format("painter-bench-{}", ::getpid());
    synthesize(read_spec(VANTAGE_SOURCE_DIR "/data/tiny.toml"), folder / "scene", {});
    const SceneInput input = read_scene(discover(folder / "scene"));
    const gl::HeadlessContext context;
    fmt::print(
        "{}\n\n| mesh | triangles | polygons of the tree | per triangle | build | traverse | frame "
        "without | exact | approximate | fragments | of these approximated "
        "|\n|---|---|---|---|---|---|---|---|---|---|---|\n",
        gl::current_device().renderer);
    for (const std::size_t n : {100, 1000, 3000, 10'000})
        print_row("random", random_triangles(n), input, folder / "random.vantage");
    for (int i = 1; i < argc; ++i) {
        std::vector<std::string> warnings;
        print_row(fs::absolute(argv[i]).parent_path().filename().string(), read_mesh(argv[i], warnings),
                  input, folder / "mesh.vantage");
    }
    fs::remove_all(folder);
    return 0;
}

}  // namespace
}  // namespace vantage

int main(int argc, char** argv) {
    try {
        return vantage::run(argc, argv);
    } catch (const std::exception& e) {
        fmt::print(stderr, "painter-bench: {}\n", e.what());
        return 1;
    }
}
