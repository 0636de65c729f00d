#include "player/headset/headset_marks.h"

#include <algorithm>

#include "player/interface/overlays/photo_frustum.h"
#include "player/interface/sections/image_set_section.h"

namespace vantage {
namespace {

using Eigen::Vector3d;

constexpr MarkColor white{1, 1, 1, 1}, faded{1, 1, 1, 0}, blue{0.36f, 0.72f, 1, 0.95f},
    red{0.95f, 0.35f, 0.3f, 0.9f}, yellow{1, 0.8f, 0.27f, 1}, gray{0.75f, 0.78f, 0.82f, 0.9f};

constexpr double hands_breadth = 0.15;  ///< meters

MarkSize meters(const Stance& stance, double length) { return {length * stance.scale, 1.5}; }

MarkColor color_of(MeasureLook look) {
    return look == MeasureLook::selected ? blue : look == MeasureLook::finished ? yellow : white;
}

/// Whether a photo is shown as a picture. A photo is not shown as a picture while the viewer is at its
/// camera.
bool is_in_scene(const PlanScene& scene, std::uint32_t photo, const Session& s, const Vector3d& eye,
                 const Stance& stance) {
    const package::PhotoRecord& p = scene.photos[photo];
    const bool stands_there = (scene.poses[photo].center() - eye).norm() < hands_breadth * stance.scale;
    return is_shown(s.settings.image_sets, p) && p.levels && !stands_there;
}

/// The distance at which a ray intersects a parallelogram, given by three corners; nullopt if they do not
/// intersect.
std::optional<double> meets(const Ray& ray, const Vector3d& corner, const Vector3d& right,
                            const Vector3d& below) {
    const Vector3d a = right - corner, b = below - corner, across = ray.along.cross(b);
    const double volume = a.dot(across);
    if (!(std::abs(volume) > 0)) return {};
    const Vector3d from = ray.from - corner, other = from.cross(a);
    const double u = from.dot(across) / volume, v = ray.along.dot(other) / volume,
                 distance = b.dot(other) / volume;
    if (!(u >= 0 && u <= 1 && v >= 0 && v <= 1 && distance > 0)) return {};
    return distance;
}

/// The photos that are shown as pictures, nearest first.
std::vector<std::uint32_t> photos_in_scene(const PlanScene& scene, const Session& s, const Vector3d& eye,
                                           const Stance& stance) {
    std::vector<std::uint32_t> out;
    for (std::uint32_t i = 0; i < scene.photos.size(); ++i)
        if (is_in_scene(scene, i, s, eye, stance)) out.push_back(i);
    std::ranges::sort(out, {}, [&](std::uint32_t i) { return (scene.poses[i].center() - eye).norm(); });
    return out;
}

void add_frame(Marks& marks, const PhotoFrustum& f, MarkSize width, const MarkColor& color) {
    for (std::size_t c = 0; c < 4; ++c) {
        add_line(marks, f.corner[c], f.corner[(c + 1) % 4], width, color);
        add_line(marks, f.center, f.corner[c], width, {color[0], color[1], color[2], 0.4f * color[3]});
    }
}

}  // namespace

void add_hand(Marks& marks, const Stance& stance, const Hand& hand, double length, bool meets) {
    if (hand.grip) add_ball(marks, in_scene(stance, hand.grip->at), meters(stance, 0.02), gray);
    if (!hand.aim) return;
    const Vector3d from = in_scene(stance, hand.aim->at),
                   to = in_scene(stance, hand.aim->at + hand.aim->ahead() * length);
    add_line(marks, from, to, {0.0015 * stance.scale, 1.5}, faded, white);
    if (meets) add_dot(marks, stance, hand, length);
}

void add_dot(Marks& marks, const Stance& stance, const Hand& hand, double length) {
    const Vector3d at = in_scene(stance, hand.aim->at + hand.aim->ahead() * length);
    add_ball(marks, at, {0, 4}, hand.select ? blue : white);
}

void add_arc(Marks& marks, const Stance& stance, const TeleportArc& arc) {
    const MarkColor color = arc.landing ? blue : red;
    add_path(marks, arc.points, meters(stance, 0.015), color, color);
    if (!arc.landing) return;
    const double m = stance.scale;
    const Vector3d at = *arc.landing + stance.up() * 0.005 * m;
    add_ring(marks, at, stance.up(), 0.22 * m, 0.26 * m, color);
    add_ring(marks, at, stance.up(), 0, 0.22 * m, {color[0], color[1], color[2], 0.25f});
}

void add_measurement(Marks& marks, const Stance& stance, const DrawnMeasurement& d, const Vector3d& origin,
                     const Vector3d& up) {
    const std::vector<Vector3d> points = points_from(d.measurement, origin);
    const MarkColor color = color_of(d.look);
    for (const auto& [from, to] : lines_of(d.measurement.measure, points, up))
        add_line(marks, from, to, meters(stance, 0.004), color);
    for (const Vector3d& p : points) add_ball(marks, p, meters(stance, 0.006), color);
}

void add_photos(Marks& marks, const Stance& stance, Renderer& renderer, const Session& s, const Vector3d& eye,
                std::optional<std::uint32_t> pointed_at) {
    const PlanScene& scene = renderer.scene();
    const Residency& residency = renderer.resources().store.residency();
    // The other half of the thumbnail slots remains available for blended photos.
    const std::size_t pictures = residency.layout().thumbnails / 2;
    std::size_t wanted = 0;
    for (const std::uint32_t i : photos_in_scene(scene, s, eye, stance)) {
        if (wanted++ < pictures) renderer.planner().tiles().want_thumbnail(i);
        const PhotoFrustum f = photo_frustum(scene, i);
        const package::PhotoRecord& p = scene.photos[i];
        if (const auto layer = residency.thumbnail_layer(i)) {
            const MarkPicture picture{
                residency.thumbnails(),
                int(*layer),
                {0, 0, float(p.thumbnail_width) / float(residency.layout().thumbnail_width),
                 float(p.thumbnail_height) / float(residency.layout().thumbnail_height)},
                true};
            add_picture(marks, f.corner[0], f.corner[1], f.corner[3], picture, white);
        }
        const bool pointed = pointed_at == i;
        add_frame(marks, f, meters(stance, pointed ? 0.006 : 0.002), pointed ? white : gray);
    }
}

void add_note(Marks& marks, const Stance& stance, const Vector3d& at, bool open) {
    add_ball(marks, at, {0.012 * stance.scale, 5}, open ? blue : yellow);
}

std::optional<PhotoHit> photo_on(const PlanScene& scene, const Session& s, const Ray& ray,
                                 const Stance& stance) {
    std::optional<PhotoHit> out;
    for (std::uint32_t i = 0; i < scene.photos.size(); ++i) {
        if (!is_in_scene(scene, i, s, s.viewpoint.camera.eye, stance)) continue;
        const PhotoFrustum f = photo_frustum(scene, i);
        const auto distance = meets(ray, f.corner[0], f.corner[1], f.corner[3]);
        if (distance && (!out || *distance < out->distance)) out = PhotoHit{i, *distance};
    }
    return out;
}

}  // namespace vantage
