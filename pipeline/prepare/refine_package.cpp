#include "pipeline/prepare/refine_package.h"

#include <span>
#include <string>

#include "pipeline/output/meta.h"
#include "pipeline/prepare/merge_packages.h"
#include "scene/package/package_reader.h"
#include "scene/package/package_shape.h"

namespace vantage {

void refine_package(const std::filesystem::path& file, const std::map<Effect, EffectChoice>& choices,
                    const std::filesystem::path& out, const OnProgress& progress) {
    const PackageReader package(file);
    expect_shape(package);
    const std::string meta(package.meta());
    std::map<Effect, EffectChoice> forced = choices_in(meta);
    package::SceneRecord scene = package.scene();
    for (const EffectRow& row : effect_table()) {
        if (!from_all_photos(row)) continue;
        scene.effects &= ~effect_bit(row.effect);
        forced[row.effect] = choice_of(choices, row.effect);
    }
    join(std::span(&package, 1), with_choices(meta, forced), scene, out, progress);
}

}  // namespace vantage
