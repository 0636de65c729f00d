#include "pipeline/synth/synthesize.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <atomic>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

#include "base/files/replace_file.h"
#include "base/text/photo_names.h"
#include "pipeline/formats/export_colmap.h"
#include "pipeline/formats/export_ply.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/run/for_each_photo.h"
#include "pipeline/synth/cast_photo.h"
#include "pipeline/synth/garden.h"
#include "pipeline/synth/glass_case.h"

namespace vantage {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double radians = std::numbers::pi / 180;

/// A uniformly distributed number in [-1, 1), with the same results on every platform.
double signed_unit(std::mt19937& engine) { return double(engine()) * 0x1p-31 - 1; }

/// The camera with a random rotation and shift, which displace points at `distance` by about `pixels` in
/// total.
Camera perturbed(Camera camera, double pixels, double distance, std::mt19937& engine) {
    const auto direction = [&] {
        const double z = signed_unit(engine), y = signed_unit(engine), x = signed_unit(engine);
        const Vector3d v(x, y, z);  // not drawn as arguments, whose order of evaluation is unspecified
        return Vector3d(v / std::max(v.norm(), 1e-3));
    };
    const double angle = pixels / camera.intrinsics.fx / std::numbers::sqrt2;
    const Vector3d axis = direction(), shift = direction() * angle * distance;
    Pose& pose = camera.cam_from_world;
    const Vector3d center = pose.center() + shift;
    pose.R = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix() * pose.R;
    pose.t = -pose.R * center;
    return camera;
}

std::vector<PhotoExposure> exposures(const SynthSpec& spec) {
    std::mt19937 engine(spec.seed + 2), balance(spec.seed + 3);
    std::vector<PhotoExposure> out;
    for (int i = 0; i < spec.photos.count; ++i) {
        const double stops = spec.exposure.stops * signed_unit(engine);
        PhotoExposure& e = out.emplace_back();
        for (double& g : e.gain) g = std::exp2(stops + spec.exposure.white_balance * signed_unit(balance));
        e.vignetting = spec.exposure.vignetting;
    }
    for (int i = 0; i < spec.infrared.count; ++i) {
        PhotoExposure& e = out.emplace_back();
        e.gain.fill(std::exp2(spec.infrared.stops));
        e.vignetting = spec.exposure.vignetting;
    }
    return out;
}

/// The image set of the photo with this number; infrared photos come last.
SynthImageSet image_set_of(const SynthSpec& spec, std::size_t photo) {
    return photo < std::size_t(spec.photos.count) ? SynthImageSet::visible : SynthImageSet::infrared;
}

void write_gains(const std::filesystem::path& file, std::span<const NamedCamera> photos,
                 std::span<const PhotoExposure> exposures) {
    std::ostringstream out;
    out << "photo,red,green,blue\n";
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const auto& g = exposures[i].gain;
        out << fmt::format("{},{},{},{}\n", photos[i].photo, g[0], g[1], g[2]);
    }
    replace_file(file, out.view());
}

std::filesystem::path depth_of(const NamedCamera& photo) {
    return std::filesystem::path("truth") / "depth" / (std::string(stem_of(photo.photo)) + ".exr");
}

/// If `height` is set, the mesh gets the height above the ground as a scalar field.
void write_model(const SynthModel& model, bool height, const std::filesystem::path& file) {
    std::vector<Vector3f> positions;
    for (const Vector3d& p : model.mesh.positions) positions.push_back(p.cast<float>());
    std::vector<float> heights;
    for (const Vector3f& p : positions) heights.push_back(p.z());
    std::vector<PlyField> fields;
    if (height) fields.push_back({"height", heights});
    write_ply(file, {.positions = positions,
                     .normals = model.mesh.normals,
                     .triangles = model.mesh.triangles,
                     .fields = fields,
                     .colors = model.mesh.colors});
}

}  // namespace

Pose look_at(const Vector3d& eye, const Vector3d& target) {
    Pose pose;
    const Vector3d z = (target - eye).normalized(), x = z.cross(Vector3d::UnitZ()).normalized();
    pose.R << x.transpose(), z.cross(x).transpose(), z.transpose();
    pose.t = -pose.R * eye;
    return pose;
}

namespace {

/// The photos of all image sets; their names do not include the folders of the image sets.
std::vector<NamedCamera> place_image_set(const SynthSpec& spec) {
    const SynthSpec::Photos& s = spec.photos;
    std::mt19937 engine(spec.seed);
    std::vector<NamedCamera> photos;
    for (int i = 0; i < s.count; ++i) {
        const double along = s.count > 1 ? double(i) / (s.count - 1) - 0.5 : 0.0;
        const double angle = along * s.arc * radians;
        const Vector3d eye(s.radius * std::sin(angle), -s.radius * std::cos(angle), i % 2 ? s.high : s.low);
        const double up = signed_unit(engine) * 0.3, aside = signed_unit(engine) * 0.6;
        const Vector3d target(aside, -spec.object.distance / 2, 0.42 * spec.building.height + up);
        const double f = s.width / (2 * std::tan(s.fov / 2 * radians));
        Camera camera;
        // The principal point is off center, as in real cameras.
        camera.intrinsics = {
            s.width, s.height, f, f, s.width / 2.0 + 0.006 * s.width, s.height / 2.0 - 0.004 * s.width};
        if (spec.lens.k1 != 0 || spec.lens.k2 != 0)
            camera.lens = {LensModel::opencv, {spec.lens.k1, spec.lens.k2}};
        camera.cam_from_world = look_at(eye, target);
        photos.push_back({fmt::format("{:04}.jpg", i), camera});
    }
    return photos;
}

}  // namespace

std::vector<NamedCamera> place_cameras(const SynthSpec& spec) {
    std::vector<NamedCamera> photos = place_image_set(spec);
    if (spec.infrared.count == 0) return photos;
    for (NamedCamera& p : photos) p.photo = "visible/" + p.photo;
    SynthSpec infrared = spec;
    infrared.seed += 5;
    infrared.photos.count = spec.infrared.count;
    infrared.photos.width = spec.infrared.width;
    infrared.photos.height = spec.infrared.height;
    infrared.photos.fov = spec.infrared.fov;
    for (NamedCamera& p : place_image_set(infrared)) photos.push_back({"infrared/" + p.photo, p.camera});
    return photos;
}

std::vector<std::filesystem::path> synthesized_files(const SynthSpec& spec) {
    std::vector<std::filesystem::path> out{"mesh.ply"};
    for (const std::filesystem::path sparse : {"sparse", "truth/sparse"})
        for (const char* file : colmap_text_files) out.push_back(sparse / file);
    for (const NamedCamera& photo : place_cameras(spec)) {
        out.push_back(std::filesystem::path("images") / photo.photo);
        out.push_back(depth_of(photo));
    }
    return out;
}

void synthesize(const SynthSpec& spec, const std::filesystem::path& folder,
                const std::function<void(std::size_t, std::size_t)>& progress) {
    const SynthModel model = build_model(spec), world = build_world(spec);
    const RayScene rays(model.mesh), world_rays(world.mesh);
    const std::vector<NamedCamera> photos = place_cameras(spec);
    const std::vector<PhotoExposure> exposed = exposures(spec);
    std::vector<NamedCamera> written = photos;
    std::mt19937 engine(spec.seed + 1);
    for (NamedCamera& photo : written)
        if (spec.error.pixels > 0)
            photo.camera = perturbed(photo.camera, spec.error.pixels, spec.photos.radius, engine);
    for (const NamedCamera& photo : photos) {
        std::filesystem::create_directories((folder / "images" / photo.photo).parent_path());
        std::filesystem::create_directories((folder / depth_of(photo)).parent_path());
    }
    write_colmap_text(folder / "sparse", written);
    write_colmap_text(folder / "truth" / "sparse", photos);
    write_gains(folder / synth_mark, photos, exposed);
    SynthModel with_glass = model;
    add_glass_case(spec, with_glass);
    write_model(with_glass, spec.height_field, folder / "mesh.ply");
    std::atomic<std::size_t> done{0};
    for_each_photo(photos.size(), 0, [&](std::size_t i) {
        const Camera& camera = photos[i].camera;
        const Intrinsics& k = camera.intrinsics;
        const auto rgb =
            cast_photo(world, world_rays, camera, spec.photos.samples, exposed[i], image_set_of(spec, i));
        image_files().write(folder / "images" / photos[i].photo, k.width, k.height, 3, Sample::u8,
                            std::as_bytes(std::span(rgb)));
        const auto z = cast_depth(rays, camera);
        image_files().write(folder / depth_of(photos[i]), k.width, k.height, 1, Sample::f32,
                            std::as_bytes(std::span(z)));
        if (progress) progress(++done, photos.size());
    });
}

}  // namespace vantage
