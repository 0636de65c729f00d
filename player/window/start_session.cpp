#include "player/window/start_session.h"

#include <utility>

#include "base/text/error.h"
#include "base/text/translation.h"
#include "player/survey/photo_errors.h"
#include "player/tour/story_background.h"
#include "player/view/shots.h"
#include "scene/package/contents/first_photo.h"
#include "scene/package/contents/image_sets.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {
namespace {

/// The image sets given on the command line, or else those of the saved image sets that the package has.
ImageSetSettings chosen_image_sets(const PackageReader& package, const ShowOptions& o,
                                   const Remembered& remembered) {
    if (o.blending.image_sets.given()) return image_set_settings(package, o.blending.image_sets);
    ImageSetSettings out = remembered.settings.image_sets;
    out.shown = 0;
    out.other.reset();
    const std::vector<ImageSet> image_sets = read_image_sets(package);
    for (std::uint32_t b = 0; image_sets.size() > 1 && b < image_sets.size(); ++b) {
        if (image_sets[b].name == remembered.image_set) out.shown = b;
        if (image_sets[b].name == remembered.other_image_set) out.other = b;
    }
    if (!o.package.photos.empty())
        out.shown = package.photos()[named_photos(package, o.package.photos).front()].image_set;
    if (out.other == out.shown) out.other.reset();
    return out;
}

/// The settings of the program, of the command line, or as remembered.
SessionSettings session_settings(const PackageReader& package, const ShowOptions& o,
                                 const RenderSettings& render) {
    SessionSettings out;
    out.settings = render;
    out.settings.upload_bytes = o.memory.upload_bytes();
    out.settings.loading = Loading::streamed;
    out.settings.field = field_settings(package, o.field);
    if (o.light.shown != LightSettings{}) out.settings.light = light_settings(o.light);
    out.settings.points = point_settings(o.points);
    out.stereo = o.stereo;
    return out;
}

}  // namespace

void expect_content(const PackageReader& package) {
    package.meta();
    if (package.photos().empty() && !points_only(package.scene()))
        throw Error(Exit::damaged, package.path().string() + ": contains no photos");
}

Remembered start_settings(const PackageReader& package, const ShowOptions& o,
                          const std::filesystem::path& folder) {
    Remembered given;
    given.settings = render_settings(package, o.blending, Purpose::window);
    if (o.window.fresh) return given;
    Remembered out = read_settings(folder, given);
    if (o.blending.given) out.settings = given.settings;
    return out;
}

std::string chosen_language(const ShowOptions& o, const Remembered& remembered) {
    if (!o.window.language.empty()) return o.window.language;
    return remembered.language.empty() ? system_language() : remembered.language;
}

Session start_session(const PackageReader& package, const ShowOptions& o, const Remembered& remembered,
                      WindowState& window) {
    Session s(window);
    s.defaults = session_settings(package, o, render_settings(package, o.blending, Purpose::window));
    s.defaults.settings.image_sets = chosen_image_sets(package, o, {});
    static_cast<SessionSettings&>(s) = session_settings(package, o, remembered.settings);
    s.settings.image_sets = chosen_image_sets(package, o, remembered);
    const std::uint32_t image_set = s.settings.image_sets.shown;
    const bool any = o.package.photos.empty();
    const std::uint32_t photo =
        any ? first_photo(package, image_set) : named_photos(package, o.package.photos).front();
    s.viewpoint.standing_at = s.settings.compare_photo = photo < package.photos().size() ? photo : 0;
    Navigation home = any ? first_view(package, image_set) : home_of(package, photo);
    if (!o.pictures.view.empty()) {
        const auto [view, distance] = parse_view_and_distance(o.pictures.view, package, {1280, 720});
        home = stand_at(view, home.up, distance);
    }
    begin_at(s.viewpoint, home);
    window.panels.expert |= !o.field.name.empty();
    window.places_note = window.hides_pieces = false;
    return s;
}

void begin_in_scene(Session& s, const PackageReader& package, const ActiveStory& active,
                    const ShowOptions& o) {
    s.window.story_languages = languages_of(active.story);
    s.window.web = active.story.web;
    s.photos = photos_in_use(package, o.package);
    std::erase_if(s.photos, [&](std::uint32_t p) { return !package.photos()[p].levels; });
    s.defaults.photos = s.photos;
    s.photo_list.errors = photo_errors(package);
    const bool view_given = !o.package.photos.empty() || !o.pictures.view.empty();
    if (const auto opening = opening_of(active); opening && !view_given) begin_at(s.viewpoint, *opening);
    s.defaults.movement.near_photos = active.story.limits.near_photos;
    s.defaults.movement.farthest = active.story.limits.farthest;
    s.movement = s.defaults.movement;
    if (active.story.only_object)
        s.settings.background = s.defaults.settings.background = ShowBackground::off;
    s.settings.plain_background = active.story.background ? plain_background_of(*active.story.background)
                                                          : plain_background_of(package.scene());
}

}  // namespace vantage
