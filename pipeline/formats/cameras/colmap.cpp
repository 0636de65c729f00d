#include <array>
#include <cstring>
#include <map>
#include <optional>

#include "pipeline/formats/camera_axes.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/formats/tokens.h"
#include "pipeline/run/read_file.h"

namespace vantage {
namespace {

const ColmapModel models[] = {
    {"SIMPLE_PINHOLE", 3, {0, 0, 1, 2}, LensModel::none},
    {"PINHOLE", 4, {0, 1, 2, 3}, LensModel::none},
    {"SIMPLE_RADIAL", 4, {0, 0, 1, 2}, LensModel::opencv, {3}},
    {"RADIAL", 5, {0, 0, 1, 2}, LensModel::opencv, {3, 4}},
    {"OPENCV", 8, {0, 1, 2, 3}, LensModel::opencv, {4, 5, 6, 7}},
    {"OPENCV_FISHEYE", 8, {0, 1, 2, 3}, LensModel::fisheye, {4, 5, 6, 7}},
    {"FULL_OPENCV", 12, {0, 1, 2, 3}, LensModel::opencv, {4, 5, 6, 7, 8, 9, 10, 11}},
    {"FOV", 5, {0, 1, 2, 3}, LensModel::fov, {4}},
    {"SIMPLE_RADIAL_FISHEYE", 4, {0, 0, 1, 2}, LensModel::fisheye, {3}},
    {"RADIAL_FISHEYE", 5, {0, 0, 1, 2}, LensModel::fisheye, {3, 4}},
    {"THIN_PRISM_FISHEYE", 12, {0, 1, 2, 3}, LensModel::thin_prism, {4, 5, 6, 7, 8, 9, 10, 11}},
    {"RAD_TAN_THIN_PRISM_FISHEYE",
     16,
     {0, 1, 2, 3},
     LensModel::aria,
     {4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}},
    {"SIMPLE_DIVISION", 4, {0, 0, 1, 2}, LensModel::division, {3}},
    {"DIVISION", 5, {0, 1, 2, 3}, LensModel::division, {4}},
    {"SIMPLE_FISHEYE", 3, {0, 0, 1, 2}, LensModel::fisheye},
    {"FISHEYE", 4, {0, 1, 2, 3}, LensModel::fisheye},
    {"EUCM", 6, {0, 1, 2, 3}, LensModel::unified, {4, 5}},
};

Camera camera_of(const ColmapModel& m, int width, int height, const std::vector<double>& p) {
    const auto at = [&](int i) { return p[std::size_t(i)]; };
    Camera c;
    c.intrinsics = {width,
                    height,
                    at(m.focal_center[0]),
                    at(m.focal_center[1]),
                    at(m.focal_center[2]),
                    at(m.focal_center[3])};
    c.lens.model = m.lens;
    for (std::size_t i = 0; i < m.distortion.size(); ++i) c.lens.p[i] = at(m.distortion[i]);
    return c;
}

CameraSet not_empty(CameraSet set, const std::filesystem::path& images) {
    if (set.entries.empty())
        throw NoCamera(images.parent_path().string() + ": expected an image with a pose in " +
                       images.filename().string() + ", found none");
    return set;
}

/// A binary file, read sequentially; every read is bounds-checked.
class Bytes {
  public:
    explicit Bytes(std::filesystem::path file) : file_(std::move(file)), data_(read_text(file_)) {}
    template <class T>
    T read() {
        need(sizeof(T));
        T v;
        std::memcpy(&v, data_.data() + at_, sizeof v);
        at_ += sizeof v;
        return v;
    }
    std::string text() {
        const std::size_t end = data_.find('\0', at_);
        if (end == std::string::npos) need(data_.size());
        std::string out = data_.substr(at_, end - at_);
        at_ = end + 1;
        return out;
    }
    void skip(std::uint64_t count, std::uint64_t each) {
        if (count > (data_.size() - at_) / each) need(data_.size());
        at_ += count * each;
    }
    /// The number of following records, each of at least `each` bytes; checked against the file's size.
    std::uint64_t count(std::uint64_t each) {
        const auto n = read<std::uint64_t>();
        if (n > (data_.size() - at_) / each) need(data_.size());
        return n;
    }
    const std::filesystem::path& file() const { return file_; }

  private:
    void need(std::size_t n) const {
        if (n > data_.size() - at_)
            throw Error(Exit::input, file_.string() + ": truncated at byte " + std::to_string(at_));
    }
    std::filesystem::path file_;
    std::string data_;
    std::size_t at_ = 0;
};

/// A camera in the list, or the reason why it is unusable.
struct ListedCamera {
    Camera camera;
    std::string flaw{};
};
using ListedCameras = std::map<std::uint32_t, ListedCamera>;

void add_image(CameraSet& set, const ListedCameras& cameras, std::uint32_t camera, const std::string& photo,
               const Pose& pose, const std::filesystem::path& file) {
    const auto it = cameras.find(camera);
    if (it == cameras.end())
        throw Error(Exit::input, file.string() + ": photo " + photo + " has camera " +
                                     std::to_string(camera) + ", which is not in the cameras file");
    if (!it->second.flaw.empty()) throw Error(Exit::input, it->second.flaw);
    Camera c = it->second.camera;
    c.cam_from_world = pose;
    set.entries.push_back({photo, c});
}

ListedCameras text_cameras(const std::filesystem::path& file) {
    Tokens in(file);
    ListedCameras cameras;
    for (;;) {
        if (in.skip_comment()) continue;
        if (in.at_end()) return cameras;
        const auto id = in.number<std::uint32_t>("a camera ID");
        const std::string wanted(in.word("a camera model"));
        const ColmapModel* model = nullptr;
        for (const ColmapModel& m : models)
            if (wanted == m.name) model = &m;
        if (!model) {  // an error only if an image has it
            cameras[id].flaw = in.flaw("a COLMAP camera model", "'" + wanted + "'");
            in.line();
            continue;
        }
        const int width = in.number<int>("a width"), height = in.number<int>("a height");
        std::vector<double> p;
        while (!in.at_line_end() && !in.at_comment()) p.push_back(in.number<double>("a camera parameter"));
        if (p.size() != model->parameters)
            in.fail(std::to_string(model->parameters) + " parameters of " + wanted, std::to_string(p.size()));
        cameras[id] = {camera_of(*model, width, height, p)};
        in.line();
    }
}

ListedCameras binary_cameras(const std::filesystem::path& file) {
    Bytes in(file);
    ListedCameras cameras;
    for (std::uint64_t n = in.count(24); n > 0; --n) {
        const auto id = in.read<std::uint32_t>();
        const auto model = in.read<std::int32_t>();
        if (model < 0 || std::size_t(model) >= std::size(models))
            throw Error(Exit::input, file.string() + ": camera model " + std::to_string(model) +
                                         " is unknown or not a perspective model");
        const auto width = in.read<std::uint64_t>(), height = in.read<std::uint64_t>();
        if (width > 1u << 20 || height > 1u << 20)
            throw Error(Exit::input,
                        file.string() + ": camera " + std::to_string(id) + " has an invalid size");
        std::vector<double> p(models[model].parameters);
        for (double& v : p) v = in.read<double>();
        cameras[id] = {camera_of(models[model], int(width), int(height), p)};
    }
    return cameras;
}

}  // namespace

std::span<const ColmapModel> colmap_models() { return models; }

CameraSet read_colmap_text(const std::filesystem::path& folder) {
    CameraSet set{"COLMAP text", {}, {}};
    const auto cameras = text_cameras(folder / "cameras.txt");
    Tokens in(folder / "images.txt");
    for (;;) {
        if (in.skip_comment()) continue;
        if (in.at_end()) return not_empty(std::move(set), folder / "images.txt");
        in.number<std::uint64_t>("an image ID");
        double q[4];
        Eigen::Vector3d t;
        for (double& v : q) v = in.number<double>("a quaternion");
        for (double& v : t) v = in.number<double>("a translation");
        const auto camera = in.number<std::uint32_t>("a camera ID");
        if (in.at_line_end()) in.fail("a photo name", "the end of the line");
        const std::string photo(in.line());
        in.line();  // the 2D points; may be empty
        add_image(set, cameras, camera, photo, from_colmap(q[0], q[1], q[2], q[3], t), folder / "images.txt");
    }
}

CameraSet read_colmap_binary(const std::filesystem::path& folder) {
    CameraSet set{"COLMAP binary", {}, {}};
    const auto cameras = binary_cameras(folder / "cameras.bin");
    Bytes in(folder / "images.bin");
    for (std::uint64_t n = in.count(64); n > 0; --n) {
        in.read<std::uint32_t>();
        double q[4];
        Eigen::Vector3d t;
        for (double& v : q) v = in.read<double>();
        for (double& v : t) v = in.read<double>();
        const auto camera = in.read<std::uint32_t>();
        const std::string photo = in.text();
        in.skip(in.read<std::uint64_t>(), 24);
        add_image(set, cameras, camera, photo, from_colmap(q[0], q[1], q[2], q[3], t), in.file());
    }
    return not_empty(std::move(set), in.file());
}

}  // namespace vantage
