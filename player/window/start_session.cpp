#include "player/window/start_session.h"

#include <utility>

#include "base/text/error.h"
#include "base/text/translation.h"
#include "player/survey/photo_errors.h"
#include "player/tour/story_background.h"
#include "player/view/shots.h"
#include "scene/package/contents/bands.h"
#include "scene/package/contents/first_photo.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {
namespace {

/// The bands of the command line; without any, those remembered, as far as the package has them.
BandSettings chosen_bands(const PackageReader& package, const ShowOptions& o, const Remembered& remembered) {
    if (o.blending.bands.given()) return band_settings(package, o.blending.bands);
    BandSettings out = remembered.settings.bands;
    out.shown = 0;
    out.other.reset();
    const std::vector<Band> bands = read_bands(package);
    for (std::uint32_t b = 0; bands.size() > 1 && b < bands.size(); ++b) {
        if (bands[b].name == remembered.band) out.shown = b;
        if (bands[b].name == remembered.other_band) out.other = b;
    }
    if (!o.package.photos.empty())
        out.shown = package.photos()[named_photos(package, o.package.photos).front()].band;
    if (out.other == out.shown) out.other.reset();
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

Session start_session(const PackageReader& package, const ShowOptions& o, const Remembered& remembered) {
    Session s;
    s.settings = remembered.settings;
    s.panels = remembered.panels;
    s.settings.upload_bytes = o.memory.upload_bytes();
    s.settings.complete = false;
    s.settings.layer = layer_settings(package, o.layer);
    if (read_layers(package).empty()) s.panels.layers = s.settings.layer.layer >= 0;
    if (o.light.shown != LightSettings{}) s.settings.light = light_settings(o.light);
    s.settings.points = point_settings(o.points);
    s.lamp_follows = o.light.lamp.empty();
    s.settings.bands = chosen_bands(package, o, remembered);
    const std::uint32_t band = s.settings.bands.shown;
    const bool any = o.package.photos.empty();
    const std::uint32_t photo =
        any ? first_photo(package, band) : named_photos(package, o.package.photos).front();
    s.standing_at = s.settings.compare_photo = photo < package.photos().size() ? photo : 0;
    s.camera = any ? first_view(package, band) : home_of(package, photo);
    if (!o.pictures.view.empty()) {
        const auto [view, distance] = parse_view_and_distance(o.pictures.view, package, {1280, 720});
        s.camera = stand_at(view, s.camera.up, distance);
    }
    s.home = s.earlier.last = s.camera;
    s.panels.expert |= !o.layer.name.empty();
    s.stereo = o.stereo;
    return s;
}

void begin_in_scene(Session& s, const PackageReader& package, const ToldStory& told, const ShowOptions& o) {
    s.photos = photos_in_use(package, o.package);
    s.photo_list.errors = photo_errors(package);
    const bool view_given = !o.package.photos.empty() || !o.pictures.view.empty();
    if (const auto opening = opening_of(told); opening && !view_given)
        s.camera = s.home = s.earlier.last = *opening;
    s.settings.background =
        told.story.background ? background_of(*told.story.background) : background_of(package.scene());
}

}  // namespace vantage
