#include "pipeline/finish_package.h"

#include <array>

#include "pipeline/provenance.h"
#include "pipeline/refine/refine.h"
#include "pipeline/stage_keys.h"

namespace vantage {

using package::Type;

ColorRefinement finish_package(PackageWriter& writer, const std::string& meta, package::SceneRecord scene,
                               PhotoTables& photos) {
    const auto read = [&](std::uint32_t photo) { return writer.read(Type::samples, photo); };
    ColorRefinement colors = refine_colors(photos.records, read, forced_effects(meta));
    apply_colors(colors, photos.records);
    for (std::size_t i = 0; i < photos.records.size(); ++i) seal(photos.states[i], photos.records[i]);
    for (const EffectDecision& d : {colors.exposure, colors.falloff})
        scene.effects |= std::uint64_t(d.on) << int(d.effect);
    const std::string described = with_effects(meta, std::array{colors.exposure, colors.falloff});
    writer.write(Type::meta, package::scene_wide, std::as_bytes(std::span(described)));
    writer.write(Type::scene, package::scene_wide, bytes_of_one(scene));
    writer.write(Type::photos, package::scene_wide, bytes_of(photos.records));
    writer.write(Type::states, package::scene_wide, bytes_of(photos.states));
    writer.finish();
    return colors;
}

}  // namespace vantage
