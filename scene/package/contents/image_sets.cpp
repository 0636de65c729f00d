#include "scene/package/contents/image_sets.h"

#include <algorithm>
#include <cstring>

#include "base/text/error.h"
#include "base/text/file_name.h"

namespace vantage {
namespace {

bool same_name(const std::string& a, const std::string& b) {
    return comparable_name(a) == comparable_name(b);
}

}  // namespace

EffectSet effects_of_image_sets() {
    return effects_from(Basis::colors) | effects_from(Basis::pixels) | effects_from(Basis::background);
}

std::vector<ImageSet> read_image_sets(const PackageReader& package) {
    const EffectSet of_scene = package.scene().effects;
    if (!effect_on(package.scene(), Effect::image_sets)) return {{"", of_scene}};
    std::vector<ImageSet> out;
    for (const package::ImageSetRecord& b :
         package.records<package::ImageSetRecord>(package::Type::image_sets)) {
        const EffectSet own = b.effects & of_scene & effects_of_image_sets();
        out.push_back({std::string(b.name, ::strnlen(b.name, sizeof b.name)),
                       (of_scene & ~effects_of_image_sets()) | own});
    }
    if (out.empty()) throw Error(Exit::damaged, package.path().string() + ": BAND: has no image sets");
    return out;
}

std::uint32_t image_set_named(const PackageReader& package, const std::string& name) {
    const std::vector<ImageSet> image_sets = read_image_sets(package);
    if (image_sets.size() == 1)
        throw Error(Exit::usage, package.path().string() + ": has no image sets, but an image set '" + name +
                                     "' was requested");
    std::string known;
    for (std::uint32_t b = 0; b < image_sets.size(); ++b) {
        if (same_name(image_sets[b].name, name)) return b;
        known += (known.empty() ? "" : ", ") + image_sets[b].name;
    }
    throw Error(Exit::usage,
                package.path().string() + ": has no image set '" + name + "', expected one of " + known);
}

}  // namespace vantage
