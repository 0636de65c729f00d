#include "pipeline/formats/meshes/assimp_reader.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <string_view>

#include "base/text/error.h"
#include "base/text/lower_extension.h"
#include "base/values/srgb.h"
#include "pipeline/formats/meshes/gltf.h"
#include "pipeline/formats/meshes/isolated_process.h"
#include "pipeline/formats/meshes/mesh_bytes.h"
#include "pipeline/formats/meshes/ply.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

/// Finds files whose names are percent-encoded in a glTF.
class FilesBeside : public Assimp::DefaultIOSystem {
  public:
    explicit FilesBeside(const fs::path& file) : folder_(file.parent_path()) {}

    Assimp::IOStream* Open(const char* name, const char* mode) override {
        const std::string prefix = folder_.empty() ? "" : folder_.string() + "/";
        std::string_view in_folder(name);
        if (in_folder.starts_with(prefix)) in_folder.remove_prefix(prefix.size());
        return DefaultIOSystem::Open(gltf_file(folder_, in_folder).c_str(), mode);
    }

  private:
    fs::path folder_;
};

Eigen::Vector3d vector(const aiVector3D& v) { return {double(v.x), double(v.y), double(v.z)}; }

Eigen::Affine3d affine(const aiMatrix4x4& m) {
    Eigen::Affine3d out;
    out.matrix() << double(m.a1), double(m.a2), double(m.a3), double(m.a4),  //
        double(m.b1), double(m.b2), double(m.b3), double(m.b4),              //
        double(m.c1), double(m.c2), double(m.c3), double(m.c4),              //
        0, 0, 0, 1;
    return out;
}

/// The accumulated transform of a node.
struct Placement {
    Eigen::Affine3d to_scene = Eigen::Affine3d::Identity();
    double rounding = 0;  ///< error of its transform and its ancestors' transforms, in units of the scene
};

/// Joins the meshes of a scene.
class Joiner {
  public:
    /// `nodes`: the transforms of all nodes, parents first, if known in double precision.
    Joiner(const aiScene& scene, std::span<const Eigen::Affine3d> nodes, bool linear_colors)
        : scene_(scene), nodes_(nodes), linear_colors_(linear_colors) {}

    void add(const aiNode& node, const Placement& parent) {
        const Placement here = placement(node, parent);
        for (const unsigned m : std::span(node.mMeshes, node.mNumMeshes)) add_mesh(*scene_.mMeshes[m], here);
        for (const aiNode* child : std::span(node.mChildren, node.mNumChildren)) add(*child, here);
    }
    /// Returns the joined mesh. Must be called after the last node has been added.
    AssimpMesh result() {
        if (next_ != nodes_.size()) throw std::runtime_error("nodes are missing");
        Mesh& mesh = out_.mesh;
        if (!mesh.colors.empty()) mesh.colors.resize(mesh.positions.size(), white);
        if (!mesh.normals.empty()) mesh.normals.resize(mesh.positions.size(), Eigen::Vector3f::Zero());
        return std::move(out_);
    }

  private:
    static constexpr std::array<std::uint8_t, 4> white{255, 255, 255, 255};
    static constexpr double half_step = 0.5 * double(std::numeric_limits<float>::epsilon());

    Placement placement(const aiNode& node, const Placement& parent) {
        if (!nodes_.empty()) {
            if (next_ == nodes_.size()) throw std::runtime_error("more nodes than the file has");
            return {parent.to_scene * nodes_[next_++], 0};
        }
        // The root is added by assimp, whose later versions rotate and scale it to convert to Y up and
        // meters.
        if (!node.mParent) return parent;
        const Eigen::Affine3d local = affine(node.mTransformation);
        return {
            parent.to_scene * local,
            parent.rounding + half_step * reach(parent.to_scene, local.translation().cwiseAbs().maxCoeff())};
    }
    /// An upper bound on the coordinates of a transformed point, without the translation, if its original
    /// coordinates are at most `size`.
    static double reach(const Eigen::Affine3d& transform, double size) {
        return size * transform.linear().cwiseAbs().rowwise().sum().maxCoeff();
    }
    void add_mesh(const aiMesh& from, const Placement& at) {
        Mesh& mesh = out_.mesh;
        const std::size_t first = mesh.positions.size();
        if (first + from.mNumVertices >= no_vertex) throw std::length_error("vertices");
        add_positions(from, at);
        if (from.HasNormals()) add_normals(from, at.to_scene.linear());
        if (from.HasVertexColors(0)) add_colors(from);
        const bool mirrored = at.to_scene.linear().determinant() < 0;
        const auto corner = [&](unsigned i) {
            return i < from.mNumVertices ? std::uint32_t(first + i) : no_vertex;
        };
        for (const aiFace& face : std::span(from.mFaces, from.mNumFaces)) {
            if (face.mNumIndices != 3) continue;
            mesh.triangles.push_back(
                {corner(face.mIndices[0]), corner(face.mIndices[1]), corner(face.mIndices[2])});
            if (mirrored) std::swap(mesh.triangles.back()[1], mesh.triangles.back()[2]);
        }
    }
    void add_positions(const aiMesh& from, const Placement& at) {
        double largest = 0;
        for (const aiVector3D& p : std::span(from.mVertices, from.mNumVertices)) {
            out_.mesh.positions.push_back(at.to_scene * vector(p));
            largest = std::max(largest, vector(p).cwiseAbs().maxCoeff());
        }
        out_.rounding = std::max(out_.rounding, at.rounding + half_step * reach(at.to_scene, largest));
    }
    /// Transforms normals by the inverse transpose, up to a factor: the cofactor matrix, which exists even if
    /// the transform flattens the mesh.
    void add_normals(const aiMesh& from, const Eigen::Matrix3d& m) {
        Eigen::Matrix3d cofactors;
        cofactors << m.col(1).cross(m.col(2)), m.col(2).cross(m.col(0)), m.col(0).cross(m.col(1));
        const double largest = cofactors.cwiseAbs().maxCoeff();
        if (largest > 0) cofactors /= m.determinant() < 0 ? -largest : largest;
        std::vector<Eigen::Vector3f>& normals = out_.mesh.normals;
        normals.resize(out_.mesh.positions.size() - from.mNumVertices, Eigen::Vector3f::Zero());
        for (const aiVector3D& n : std::span(from.mNormals, from.mNumVertices))
            normals.push_back((cofactors * vector(n)).cast<float>());
    }
    void add_colors(const aiMesh& from) {
        std::vector<std::array<std::uint8_t, 4>>& colors = out_.mesh.colors;
        colors.resize(out_.mesh.positions.size() - from.mNumVertices, white);
        const auto byte = [&](float v) {
            const double share = v > 0 ? std::min(double(v), 1.0) : 0.0;
            return std::uint8_t(std::lround(255 * (linear_colors_ ? srgb_from_linear(share) : share)));
        };
        for (const aiColor4D& c : std::span(from.mColors[0], from.mNumVertices))
            colors.push_back({byte(c.r), byte(c.g), byte(c.b), 255});
    }

    const aiScene& scene_;
    std::span<const Eigen::Affine3d> nodes_;
    bool linear_colors_;
    std::size_t next_ = 0;  ///< index into nodes_
    AssimpMesh out_;
};

/// Removes all importers except those for files with this extension, which is given without its dot.
void keep_importers_of(const std::string& extension, Assimp::Importer& importer) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;)
        if (std::string_view(importer.GetImporterInfo(i)->mFileExtensions).find(extension) ==
            std::string_view::npos)
            importer.UnregisterLoader(importer.GetImporter(i));
}

/// A message from assimp on one line.
std::string one_line(std::string text) {
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    return text.substr(0, 200);
}

/// The unit that an FBX states, in cm; 0 if there is none.
double unit_of(const aiScene& scene) {
    float cm = 0;
    return scene.mMetaData && scene.mMetaData->Get("UnitScaleFactor", cm) ? double(cm) : 0;
}

/// The result of the reading process: an error, or the mesh.
std::vector<std::byte> read_here(const fs::path& file, const Gltf& gltf) {
    Assimp::Importer importer;
    importer.SetIOHandler(new FilesBeside(file));  // the importer deletes it
    const std::string extension = lower_extension(file).substr(1);
    keep_importers_of(extension, importer);
    for (const char* of_no_use : {AI_CONFIG_IMPORT_FBX_READ_MATERIALS, AI_CONFIG_IMPORT_FBX_READ_TEXTURES,
                                  AI_CONFIG_IMPORT_FBX_READ_LIGHTS, AI_CONFIG_IMPORT_FBX_READ_CAMERAS,
                                  AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS, AI_CONFIG_IMPORT_FBX_READ_WEIGHTS})
        importer.SetPropertyBool(of_no_use, false);
    const aiScene* scene = importer.ReadFile(file.string(), aiProcess_Triangulate);
    const std::string error = scene ? "" : one_line(importer.GetErrorString());
    std::vector<std::byte> out;
    append(out, std::vector<char>(error.begin(), error.end()));
    if (!scene) return out;
    Joiner joiner(*scene, gltf.nodes, extension != "fbx");
    if (scene->mRootNode) joiner.add(*scene->mRootNode, {});
    const AssimpMesh found = joiner.result();
    append(out, std::vector<double>{found.rounding, unit_of(*scene)});
    append(out, found.mesh);
    return out;
}

}  // namespace

AssimpMesh read_with_assimp(const fs::path& file) {
    const Gltf gltf = lower_extension(file) == ".fbx" ? Gltf{} : read_gltf(file);
    std::uint64_t size = fs::file_size(file);
    for (const fs::path& buffer : gltf.buffers) size += fs::file_size(buffer);
    // Draco and compressed FBX may need hundreds of bytes of memory per byte of the file.
    const ProcessLimits limits{.bytes = (std::uint64_t(256) << 20) + 1024 * size,
                               .seconds = 60 + unsigned(size / 100'000)};
    const std::vector<std::byte> answer = run_isolated(limits, [&] { return read_here(file, gltf); });
    if (answer.empty())
        throw Error(Exit::input, file.string() + ": cannot be read: it is damaged or too large");
    std::span<const std::byte> rest(answer);
    std::vector<char> error;
    take(rest, error);
    if (!error.empty())
        throw Error(Exit::input,
                    file.string() + ": cannot be read: " + std::string(error.begin(), error.end()));
    std::vector<double> numbers;
    take(rest, numbers);
    AssimpMesh out{{}, numbers.at(0), numbers.at(1), gltf.buffers};
    take(rest, out.mesh);
    return out;
}

}  // namespace vantage
