#include "pipeline/run/settings.h"

#include <array>

#include "base/text/error.h"

namespace vantage {
namespace {

/// Names in the order of the enumerators.
constexpr std::array renderers{"auto", "opengl", "cpu"};
constexpr std::array methods{"auto", "exact", "jfa^2"};

template <class Enum, std::size_t n>
Enum parse(const std::array<const char*, n>& names, const std::string& wanted, const std::string& what) {
    std::string known;
    for (std::size_t i = 0; i < n; ++i) {
        if (wanted == names[i]) return Enum(i);
        known += (known.empty() ? "" : ", ") + std::string(names[i]);
    }
    throw Error(Exit::usage, "unknown " + what + " '" + wanted + "', expected one of " + known);
}

}  // namespace

const char* name(RenderBy by) { return renderers[std::size_t(by)]; }
RenderBy render_by(const std::string& wanted) { return parse<RenderBy>(renderers, wanted, "renderer"); }

const char* name(DistanceMethod method) { return methods[std::size_t(method)]; }
DistanceMethod distance_method(const std::string& wanted) {
    return parse<DistanceMethod>(methods, wanted, "distance method");
}

}  // namespace vantage
