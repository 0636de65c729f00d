#include "tests/real_inputs/scan.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <array>
#include <atomic>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>

#include "tests/image_file.h"

namespace vantage::real_inputs {
namespace {

namespace fs = std::filesystem;

constexpr int width = 64, height = 48;
constexpr double focal = 60;

struct Pose {
    Eigen::Matrix3d R;
    Eigen::Vector3d t;
};

/// Camera i looks at the origin from a distance of 6. Its x axis points right, y down and z forward.
Pose pose(std::size_t i) {
    const double angle = 0.5 * (double(i) - 1);
    const Eigen::Vector3d center = 6 * Eigen::Vector3d(std::sin(angle), -0.3, -std::cos(angle)).normalized();
    const Eigen::Vector3d z = -center.normalized(), x = Eigen::Vector3d::UnitY().cross(z).normalized();
    Pose p;
    p.R << x.transpose(), z.cross(x).transpose(), z.transpose();
    p.t = -p.R * center;
    return p;
}

template <class T>
void append(std::string& s, T v) {
    s.append(reinterpret_cast<const char*>(&v), sizeof v);
}

const std::array<std::array<int, 3>, 12> faces{{{0, 2, 1},
                                                {0, 3, 2},
                                                {4, 5, 6},
                                                {4, 6, 7},
                                                {0, 1, 5},
                                                {0, 5, 4},
                                                {1, 2, 6},
                                                {1, 6, 5},
                                                {2, 3, 7},
                                                {2, 7, 6},
                                                {3, 0, 4},
                                                {3, 4, 7}}};

Eigen::Vector3d corner(int i) {
    return {i % 4 == 1 || i % 4 == 2 ? 1. : -1., i % 4 >= 2 ? 1. : -1., i < 4 ? -1. : 1.};
}

std::string corner_text(int i, const Place& at = {}) {
    const Eigen::Vector3d p = at.scale * corner(i) + Eigen::Vector3d(at.x, at.y, at.z);
    return fmt::format("{} {} {}", p.x(), p.y(), p.z());
}

std::string jpeg_segment(int marker, const std::string& content) {
    const std::size_t length = content.size() + 2;
    return std::string{char(0xff), char(marker), char(length >> 8), char(length & 0xff)} + content;
}

bool is_below(const std::string& path, const std::string& folder) {
    return path == folder || path.starts_with(folder + "/");
}

}  // namespace

std::string slurp(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

void Scan::copy(const std::string& from, const std::string& to) {
    const auto before = files;
    for (const auto& [path, bytes] : before)
        if (is_below(path, from)) files[to + path.substr(from.size())] = bytes;
}

void Scan::remove(const std::string& path) {
    if (std::erase_if(files, [&](const auto& f) { return is_below(f.first, path); }) == 0)
        throw std::logic_error("the scan has no " + path);
}

void Scan::move(const std::string& from, const std::string& to) {
    std::map<std::string, std::string> moved;
    for (auto& [path, bytes] : files)
        moved[is_below(path, from) ? to + path.substr(from.size()) : path] = std::move(bytes);
    files = std::move(moved);
}

void Scan::replace(const std::string& path, const std::string& from, const std::string& to) {
    std::string& text = files.at(path);
    if (text.find(from) == text.npos) throw std::logic_error(path + " has no '" + from + "'");
    text = replaced(text, from, to);
}

void Scan::write(const fs::path& folder) const {
    fs::create_directories(folder);
    for (const std::string& f : folders) fs::create_directories(folder / f);
    for (const auto& [path, bytes] : files) {
        fs::create_directories((folder / path).parent_path());
        std::ofstream(folder / path, std::ios::binary) << bytes;
    }
    for (const auto& [path, target] : links) {
        fs::create_directories((folder / path).parent_path());
        fs::create_symlink(target, folder / path);
    }
}

std::string colmap_images(const Names& names) {
    std::string text = "# Image list with two lines of data per image\n";
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Pose p = pose(i);
        const Eigen::Quaterniond q(p.R);
        text += fmt::format("{} {} {} {} {} {} {} {} 1 {}\n\n", i + 1, q.w(), q.x(), q.y(), q.z(), p.t.x(),
                            p.t.y(), p.t.z(), names[i]);
    }
    return text;
}

std::string colmap_images_bin(const Names& names) {
    std::string bytes;
    append<std::uint64_t>(bytes, names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Pose p = pose(i);
        const Eigen::Quaterniond q(p.R);
        append<std::uint32_t>(bytes, std::uint32_t(i + 1));
        for (const double v : {q.w(), q.x(), q.y(), q.z(), p.t.x(), p.t.y(), p.t.z()}) append(bytes, v);
        append<std::uint32_t>(bytes, 1);
        bytes += names[i] + '\0';
        append<std::uint64_t>(bytes, 0);
    }
    return bytes;
}

std::string colmap_cameras_bin() {
    std::string bytes;
    append<std::uint64_t>(bytes, 1), append<std::uint32_t>(bytes, 1), append<std::int32_t>(bytes, 1);
    append<std::uint64_t>(bytes, width), append<std::uint64_t>(bytes, height);
    for (const double v : {focal, focal, width / 2., height / 2.}) append(bytes, v);
    return bytes;
}

std::string bundle(std::size_t cameras) {
    std::string text = fmt::format("# Bundle file v0.3\n{} 0\n", cameras);
    for (std::size_t i = 0; i < cameras; ++i) {
        const Pose p = pose(i);
        const Eigen::Matrix3d R = Eigen::Vector3d(1, -1, -1).asDiagonal() * p.R;
        const Eigen::Vector3d t = Eigen::Vector3d(1, -1, -1).asDiagonal() * p.t;
        text += fmt::format("{} 0 0\n", focal);
        for (int r = 0; r < 3; ++r) text += fmt::format("{} {} {}\n", R(r, 0), R(r, 1), R(r, 2));
        text += fmt::format("{} {} {}\n", t.x(), t.y(), t.z());
    }
    return text;
}

std::string meshlab(const Names& names) {
    std::string text =
        "<!DOCTYPE MeshLabDocument>\n<MeshLabProject>\n <MeshGroup>\n  <MLMesh label=\"mesh.ply\" "
        "filename=\"mesh.ply\"/>\n </MeshGroup>\n <RasterGroup>\n";
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Pose p = pose(i);
        const Eigen::Matrix3d R = Eigen::Vector3d(1, -1, -1).asDiagonal() * p.R;
        const Eigen::Vector3d c = p.R.transpose() * p.t;
        std::string rotation;
        for (int r = 0; r < 3; ++r) rotation += fmt::format("{} {} {} 0 ", R(r, 0), R(r, 1), R(r, 2));
        text += fmt::format(
            "  <MLRaster label=\"{}\">\n   <VCGCamera TranslationVector=\"{} {} {} 1\" LensDistortion=\"0 "
            "0\" "
            "ViewportPx=\"{} {}\" PixelSizeMm=\"1 1\" CenterPx=\"{} {}\" FocalMm=\"{}\" RotationMatrix=\"{}0 "
            "0 0 "
            "1\"/>\n   <Plane semantic=\"\" fileName=\"{}\"/>\n  </MLRaster>\n",
            names[i], c.x(), c.y(), c.z(), width, height, width / 2, height / 2, focal, rotation, names[i]);
    }
    return text + " </RasterGroup>\n</MeshLabProject>\n";
}

void use_bundler(Scan& scan, const std::string& list) {
    scan.remove("sparse");
    scan["bundle.out"] = bundle();
    scan["list.txt"] = list;
}

void use_meshlab(Scan& scan, const Names& names) {
    scan.remove("sparse");
    scan["project.mlp"] = meshlab(names);
}

std::string box_ply_with(const std::string& properties, const std::string& values) {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n" +
        properties + "element face 12\nproperty list uchar int vertex_indices\nend_header\n";
    for (int i = 0; i < 8; ++i) text += corner_text(i) + " " + values + "\n";
    for (const auto& f : faces) text += fmt::format("3 {} {} {}\n", f[0], f[1], f[2]);
    return text;
}

std::string box_ply(const Place& place) {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 8\nproperty double x\nproperty double y\nproperty double z\n"
        "element face 12\nproperty list uchar int vertex_indices\nend_header\n";
    for (int i = 0; i < 8; ++i) text += corner_text(i, place) + "\n";
    for (const auto& f : faces) text += fmt::format("3 {} {} {}\n", f[0], f[1], f[2]);
    return text;
}

std::string box_obj(const std::string& colors) {
    std::string text = "# box\n";
    for (int i = 0; i < 8; ++i) text += "v " + corner_text(i) + colors + "\n";
    for (const auto& f : faces) text += fmt::format("f {} {} {}\n", f[0] + 1, f[1] + 1, f[2] + 1);
    return text;
}

std::string box_off(const std::string& header, const std::string& after_vertex,
                    const std::string& after_face) {
    std::string text = header;
    for (int i = 0; i < 8; ++i) text += corner_text(i) + after_vertex + "\n";
    for (const auto& f : faces) text += fmt::format("3 {} {} {}{}\n", f[0], f[1], f[2], after_face);
    return text;
}

std::string box_stl() {
    std::string text = "solid box\n";
    for (const auto& f : faces) {
        text += "facet normal 0 0 0\n outer loop\n";
        for (const int v : f) text += "  vertex " + corner_text(v) + "\n";
        text += " endloop\nendfacet\n";
    }
    return text + "endsolid box\n";
}

std::string box_stl_binary() {
    std::string bytes(80, ' ');
    append<std::uint32_t>(bytes, faces.size());
    for (const auto& f : faces) {
        for (int i = 0; i < 3; ++i) append(bytes, 0.0f);
        for (const int v : f)
            for (int i = 0; i < 3; ++i) append(bytes, float(corner(v)[i]));
        append<std::uint16_t>(bytes, 0);
    }
    return bytes;
}

GltfFile box_gltf(const Place& place) {
    Mesh box;
    for (int i = 0; i < 8; ++i)
        box.positions.push_back(place.scale * corner(i) + Eigen::Vector3d(place.x, place.y, place.z));
    for (const auto& f : faces)
        box.triangles.push_back({std::uint32_t(f[0]), std::uint32_t(f[1]), std::uint32_t(f[2])});
    return gltf_of(box);
}

std::string box_fbx() {
    std::string vertices, indices;
    for (int i = 0; i < 8; ++i)
        for (const double v : corner(i)) vertices += fmt::format("{}{}", vertices.empty() ? "" : ",", v);
    for (const auto& f : faces)
        indices += fmt::format("{}{},{},{}", indices.empty() ? "" : ",", f[0], f[1], ~f[2]);
    return "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\nFBXVersion: 7400\n}\n"
           "GlobalSettings:  {\nProperties70:  {\nP: \"UnitScaleFactor\", \"double\", \"Number\", "
           "\"\",1\n}\n}\n"
           "Objects:  {\nGeometry: 1, \"Geometry::\", \"Mesh\" {\nVertices: *24 {\na: " +
           vertices + "\n}\nPolygonVertexIndex: *36 {\na: " + indices +
           "\n}\n}\nModel: 2, \"Model::box\", \"Mesh\" {\nVersion: 232\n}\n}\n"
           "Connections:  {\nC: \"OO\",2,0\nC: \"OO\",1,2\n}\n";
}

std::string points_ply(std::size_t points) {
    std::string text = fmt::format(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float "
        "z\nend_header\n",
        points);
    for (std::size_t i = 0; i < points; ++i) text += corner_text(int(i % 8)) + "\n";
    return text;
}

/// OpenImageIO and OpenEXR start permanent threads, which would be missing in processes that are forked
/// later.
static bool in_a_fork(const std::function<bool()>& work) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(work() ? 0 : 1);
    int status = -1;
    return ::waitpid(child, &status, 0) == child && status == 0;
}

std::string photo(const std::string& extension, double r, double g, double b, int w, int h, int orientation) {
    static std::atomic<int> count{0};
    const fs::path file =
        fs::temp_directory_path() / fmt::format("vantage-photo-{}-{}{}", ::getpid(), ++count, extension);
    const bool is_float = extension == ".exr" || extension == ".hdr";
    OIIO::ImageSpec spec(w, h, 3, is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
    spec.attribute("Orientation", orientation);
    spec.attribute("Compression", extension == ".jpg" || extension == ".jpeg" ? "jpeg:97" : "zip");
    std::vector<float> pixels;
    for (int i = 0; i < w * h; ++i)
        for (const double v : {r, g, b})
            pixels.push_back(float(v) * (is_float || (i / 4 + i / w / 4) % 2 ? 1.f : 0.95f));
    if (!in_a_fork([&] { return write_image_file(file, spec, OIIO::TypeDesc::FLOAT, pixels.data()); }))
        throw std::runtime_error("cannot write " + file.string());
    const std::string bytes = slurp(file);
    fs::remove(file);
    return bytes;
}

std::string red(const std::string& extension) { return photo(extension, 0.8, 0.25, 0.2); }
std::string green(const std::string& extension) { return photo(extension, 0.25, 0.7, 0.25); }
std::string blue(const std::string& extension) { return photo(extension, 0.25, 0.3, 0.8); }

std::string with_metadata(const std::string& jpeg, std::size_t bytes) {
    std::string segments;
    for (std::size_t left = bytes; left > 0;) {
        const std::size_t n = std::min<std::size_t>(left, 65000);
        segments += jpeg_segment(0xe5, std::string(n, 'm'));
        left -= n;
    }
    return jpeg.substr(0, 2) + segments + jpeg.substr(2);
}

std::string with_profile(const std::string& jpeg, const std::string& icc) {
    return jpeg.substr(0, 2) + jpeg_segment(0xe2, std::string("ICC_PROFILE\0\1\1", 14) + icc) +
           jpeg.substr(2);
}

Scan standard_scan() {
    static const std::string a = red(), b = green(), c = blue();
    Scan scan;
    scan["images/A.jpg"] = a;
    scan["images/B.jpg"] = b;
    scan["images/C.jpg"] = c;
    scan["sparse/cameras.txt"] = fmt::format("# Camera list\n1 PINHOLE {} {} {} {} {} {}\n", width, height,
                                             focal, focal, width / 2, height / 2);
    scan["sparse/images.txt"] = colmap_images({"A.jpg", "B.jpg", "C.jpg"});
    scan["mesh.ply"] = box_ply();
    return scan;
}

}  // namespace vantage::real_inputs
