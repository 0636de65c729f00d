#include "player/render/scene_parts.h"

namespace vantage {

RenderSettings usable(RenderSettings settings, const SceneParts& parts) {
    if (!parts.points || parts.mesh) return settings;
    settings.points.show = settings.points.alone = true;
    settings.light.light = Light::photos;
    settings.field.index = -1;
    return settings;
}

bool photos_on_points(const RenderSettings& settings, const SceneParts& parts) {
    const PointColor color = settings.points.color;
    return parts.points && parts.photos &&
           (color == PointColor::photos || (color == PointColor::automatic && !parts.mesh));
}

bool shows_points(const RenderSettings& settings, const SceneParts& parts) {
    return parts.points && settings.points.show &&
           (settings.show == Show::colors || photos_on_points(settings, parts));
}

bool shows_photos(const RenderSettings& settings, const SceneParts& parts) {
    if (shows_points(settings, parts) && settings.points.alone) return photos_on_points(settings, parts);
    const LightSettings& l = settings.light;
    return l.light == Light::photos || (l.on_photos && l.light != Light::normals) ||
           shows_background(settings, parts);
}

bool shows_background(const RenderSettings& settings, const SceneParts& parts) {
    return parts.background && settings.background != ShowBackground::off;
}

bool fills_holes(const RenderSettings& settings, const SceneParts& parts) {
    const bool hides_them = shows_points(settings, parts) && settings.points.alone;
    return shows_background(settings, parts) && settings.show == Show::colors && !hides_them;
}

}  // namespace vantage
