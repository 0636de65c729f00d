#include "scene/package/contents/bands.h"

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

EffectSet effects_of_bands() {
    return effects_from(Basis::colors) | effects_from(Basis::pixels) | effects_from(Basis::beside);
}

std::vector<Band> read_bands(const PackageReader& package) {
    const EffectSet of_scene = package.scene().effects;
    if (!effect_on(package.scene(), Effect::bands)) return {{"", of_scene}};
    std::vector<Band> out;
    for (const package::BandRecord& b : package.records<package::BandRecord>(package::Type::bands)) {
        const EffectSet own = b.effects & of_scene & effects_of_bands();
        out.push_back(
            {std::string(b.name, ::strnlen(b.name, sizeof b.name)), (of_scene & ~effects_of_bands()) | own});
    }
    if (out.empty()) throw Error(Exit::damaged, package.path().string() + ": BAND: has no bands");
    return out;
}

std::uint32_t band_named(const PackageReader& package, const std::string& name) {
    const std::vector<Band> bands = read_bands(package);
    if (bands.size() == 1)
        throw Error(Exit::usage,
                    package.path().string() + ": has no bands, but a band '" + name + "' is asked for");
    std::string known;
    for (std::uint32_t b = 0; b < bands.size(); ++b) {
        if (same_name(bands[b].name, name)) return b;
        known += (known.empty() ? "" : ", ") + bands[b].name;
    }
    throw Error(Exit::usage,
                package.path().string() + ": has no band '" + name + "', expected one of " + known);
}

}  // namespace vantage
