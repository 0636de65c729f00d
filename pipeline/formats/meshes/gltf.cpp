#include "pipeline/formats/meshes/gltf.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "base/text/error.h"
#include "base/text/located_json.h"
#include "base/text/lower_extension.h"
#include "pipeline/formats/json_file.h"
#include "pipeline/run/read_file.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most = std::size_t(1) << 24;  ///< buffers or nodes

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
    throw Error(Exit::input, file.string() + ": " + what);
}

/// The first chunk of a .glb (glTF 2.0, section 4.4), which holds its JSON.
std::string json_of_glb(const fs::path& file) {
    struct {
        std::array<char, 4> magic;
        std::uint32_t version, length, chunk_length;
        std::array<char, 4> chunk_type;
    } header{};
    const std::vector<std::byte> start = read_file(file, sizeof header);
    std::ranges::copy(start, reinterpret_cast<std::byte*>(&header));
    if (header.magic != std::array{'g', 'l', 'T', 'F'})
        fail(file, "is not a GLB file: expected glTF at its beginning");
    if (header.version != 2) fail(file, "glTF version " + std::to_string(header.version) + ", expected 2");
    if (header.length > fs::file_size(file) || header.chunk_length > header.length)
        fail(file, "is cut off: its header says " + std::to_string(header.length) +
                       " bytes, but the file has " + std::to_string(fs::file_size(file)));
    if (header.chunk_type != std::array{'J', 'S', 'O', 'N'}) fail(file, "does not begin with a JSON chunk");
    const std::vector<std::byte> bytes = read_file(file, sizeof header + header.chunk_length);
    const auto* text = reinterpret_cast<const char*>(bytes.data());
    return {text + sizeof header, text + bytes.size()};
}

/// Throws if the file requires extensions that assimp does not support. Extensions of materials, textures and
/// lights are ignored here.
void check_extensions(const fs::path& file, const LocatedJson& root) {
    if (!root.has("extensionsRequired")) return;
    for (const LocatedJson& item : root.at("extensionsRequired").items(most)) {
        const std::string name = item.text(200);
        const auto is_of = [&](const char* known) { return name.starts_with(known); };
        if (std::ranges::none_of(std::array{"KHR_draco_mesh_compression", "KHR_materials_", "KHR_texture_",
                                            "EXT_texture_", "KHR_lights_", "KHR_xmp"},
                                 is_of))
            fail(file,
                 "needs the glTF extension " + name + ", which is not supported; export the file without it");
    }
}

std::vector<fs::path> buffers_of(const fs::path& file, const LocatedJson& root) {
    std::vector<fs::path> out;
    if (!root.has("buffers")) return out;
    for (const LocatedJson& buffer : root.at("buffers").items(most)) {
        if (!buffer.is_object() || !buffer.has("uri")) continue;  // stored in the .glb itself
        const std::string uri = buffer.at("uri").text(std::string::npos);
        if (uri.starts_with("data:")) continue;
        const fs::path found = gltf_file(file.parent_path(), uri);
        const fs::path inside = found.lexically_normal().lexically_relative(
            file.parent_path().empty() ? "." : file.parent_path().lexically_normal());
        if (fs::path(uri).is_absolute() || inside.empty() || *inside.begin() == "..")
            buffer.at("uri").fail("a file in the folder of the glTF or below it");
        std::error_code error;
        if (!fs::is_regular_file(found, error))
            fail(file, "its buffer " + uri.substr(0, 200) + " is missing");
        out.push_back(found);
    }
    return out;
}

template <std::size_t N>
std::array<double, N> numbers(const LocatedJson& list) {
    const std::vector<LocatedJson> items = list.items(N);
    if (items.size() != N) list.fail("an array of " + std::to_string(N) + " numbers");
    std::array<double, N> out;
    for (std::size_t i = 0; i < N; ++i) out[i] = items[i].number(-max_value, max_value);
    return out;
}

Eigen::Affine3d transform_of(const LocatedJson& node) {
    Eigen::Affine3d out = Eigen::Affine3d::Identity();
    if (node.has("matrix")) {
        const auto m = numbers<16>(node.at("matrix"));
        out.affine() = Eigen::Map<const Eigen::Matrix4d>(m.data()).topRows<3>();
        return out;
    }
    if (node.has("translation")) out.translate(node.at("translation").vector());
    if (node.has("rotation")) {
        const auto [x, y, z, w] = numbers<4>(node.at("rotation"));
        out.rotate(Eigen::Quaterniond(w, x, y, z).normalized());
    }
    if (node.has("scale")) out.scale(node.at("scale").vector());
    return out;
}

/// The indices in a list, each below `count`.
std::vector<std::size_t> indices(const LocatedJson& object, const char* key, std::size_t count) {
    std::vector<std::size_t> out;
    if (object.has(key))
        for (const LocatedJson& item : object.at(key).items(most))
            out.push_back(std::size_t(item.number(0, double(count) - 1)));
    return out;
}

/// The transforms of the default scene.
std::vector<Eigen::Affine3d> transforms_of(const LocatedJson& root) {
    const std::vector<LocatedJson> scenes = root.at("scenes").items(most);
    if (scenes.empty()) root.at("scenes").fail("a scene");
    const LocatedJson& scene =
        scenes[root.has("scene") ? std::size_t(root.at("scene").number(0, double(scenes.size()) - 1)) : 0];
    const auto nodes = root.has("nodes") ? root.at("nodes").items(most) : std::vector<LocatedJson>();
    std::vector<Eigen::Affine3d> out;
    std::vector<bool> seen(nodes.size(), false);
    std::vector<std::size_t> open = indices(scene, "nodes", nodes.size());
    if (open.size() != 1) out.push_back(Eigen::Affine3d::Identity());  // assimp adds a common parent
    for (std::ranges::reverse(open); !open.empty();) {
        const std::size_t n = open.back();
        open.pop_back();
        if (seen[n]) nodes[n].fail("a node with one parent");
        seen[n] = true;
        out.push_back(transform_of(nodes[n]));
        const std::vector<std::size_t> children = indices(nodes[n], "children", nodes.size());
        open.insert(open.end(), children.rbegin(), children.rend());
    }
    return out;
}

}  // namespace

Gltf read_gltf(const fs::path& file) {
    const std::string name = file.string();
    const nlohmann::json json =
        parsed_json(lower_extension(file) == ".glb" ? json_of_glb(file) : read_plain_text(file), name);
    std::vector<std::string> unknown;
    const LocatedJson root(name, json, unknown);
    const std::string version = root.at("asset").at("version").text(20);
    if (!version.starts_with("2.")) fail(file, "glTF version " + version + ", expected 2.0");
    check_extensions(file, root);
    return {buffers_of(file, root), transforms_of(root)};
}

fs::path gltf_file(const fs::path& folder, std::string_view uri) {
    fs::path raw = folder / uri;
    if (std::error_code error; fs::exists(raw, error)) return raw;
    std::string decoded;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        std::uint8_t byte = 0;
        const char* code = uri.data() + i + 1;
        if (uri[i] == '%' && i + 2 < uri.size() &&
            std::from_chars(code, code + 2, byte, 16).ptr == code + 2) {
            decoded.push_back(char(byte));
            i += 2;
        } else
            decoded.push_back(uri[i]);
    }
    return folder / decoded;
}

}  // namespace vantage
