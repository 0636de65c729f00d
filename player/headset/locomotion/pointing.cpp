#include "player/headset/locomotion/pointing.h"

#include <cmath>

#include "player/headset/headset_marks.h"

namespace vantage {
namespace {

constexpr double note_reach = 0.02;  ///< tolerance around a note's center, as a fraction of its distance

Ray ray_of(const Stance& stance, const RoomPose& aim) {
    return {in_scene(stance, aim.at), stance.R * aim.ahead()};
}

/// A note and its distance.
struct NoteHit {
    std::size_t note;
    double distance;  ///< scene units
};
std::optional<NoteHit> note_on(const Story& story, const Eigen::Vector3d& origin, const Ray& ray) {
    std::optional<NoteHit> out;
    for (std::size_t i = 0; i < story.notes.size(); ++i) {
        const auto& anchor = story.notes[i].anchor;
        if (!anchor || hides(story, *anchor)) continue;
        const Eigen::Vector3d to = *anchor - origin - ray.from;
        const double along = to.dot(ray.along);
        const bool meets = along > 0 && (to - along * ray.along).norm() < note_reach * along;
        if (meets && (!out || along < out->distance)) out = NoteHit{i, along};
    }
    return out;
}

}  // namespace

Pointed pointed_by(const Hand& hand, const Stance& stance, const PointingTargets& t) {
    Pointed out;
    if (!hand.aim) return out;
    const Ray ray = ray_of(stance, *hand.aim);
    const auto reaches = [&](double scene_units) { out.length = scene_units / stance.scale; };
    if (t.menu) out.menu = pixel_on(*t.menu, ray.from, ray.along);
    if (out.menu) {
        reaches(out.menu->distance);
    } else if (t.session.window.panels.measure) {
        out.surface = scene_point(t.meshes, t.origin, ray, t.session.settings.sections);
        if (out.surface) reaches((out.surface->position - t.origin - ray.from).norm());
    } else if (const auto note = note_on(t.story, t.origin, ray)) {
        out.note = note->note;
        reaches(note->distance);
    } else if (t.session.window.panels.frusta) {
        const auto photo = photo_on(t.scene, t.session, ray, stance);
        if (photo) out.photo = photo->photo, reaches(photo->distance);
    }
    return out;
}

MenuPointer next_menu_pointer(MenuPointer p, const Hands& hands, const std::array<Pointed, 2>& pointed,
                              const std::array<bool, 2>& selected, const Stance& stance,
                              const std::optional<Panel>& menu) {
    p.pointer = {};
    if (!menu) return {};
    p.holds = p.holds && p.hand && hands[*p.hand].select && hands[*p.hand].aim;
    if (!p.holds) {
        p.hand.reset();
        for (const std::size_t i : {left_hand, right_hand})
            if (pointed[i].menu) p.hand = i;
    }
    if (!p.hand) return p;
    const Hand& hand = hands[*p.hand];
    const Ray ray = ray_of(stance, *hand.aim);
    if (const auto hit = pixel_on_plane(*menu, ray.from, ray.along)) p.pointer.at = hit->pixel;
    p.holds |= hand.select && !selected[*p.hand];
    p.pointer.pressed = p.holds;
    p.pointer.scroll = std::abs(hand.stick.y()) > 0.3 ? 0.25 * hand.stick.y() : 0;
    return p;
}

}  // namespace vantage
