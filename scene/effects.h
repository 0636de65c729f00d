#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

namespace vantage {

/// What a scene may call for. One row a kind in effects.cpp; adding an effect adds a row there, its stage
/// and its shader file.
enum class Effect : int {
    undistortion,
    per_fragment,
    fov_normalisation,
    vertex_colors,
    exposure,
    falloff,
    registration,
    consensus,
    count
};

/// The fixed part of the table: name on the command line, what is measured, the threshold it is held
/// against ("on" above it), and the shader symbol it defines ("" where no shader depends on it).
struct EffectRow {
    Effect effect;
    const char* name;
    const char* measures;
    const char* unit;
    double threshold;
    const char* shader_symbol;
    const char* help;
};
std::span<const EffectRow> effect_table();

/// A decision with its evidence, as recorded in the package.
struct EffectDecision {
    Effect effect;
    bool on = false;
    bool forced = false;   ///< by --effect NAME=on|off
    double measured = 0;   ///< in the row's unit
    std::string evidence;  ///< one sentence for people
};

enum class EffectChoice { automatic, on, off };
/// Automatic where nothing was chosen.
EffectChoice choice_of(const std::map<Effect, EffectChoice>& choices, Effect effect);

/// Decides one effect. `measured` not finite counts as "not called for".
EffectDecision decide(Effect effect, EffectChoice choice, double measured, std::string evidence);

/// Row by name; throws Error(usage) listing the names that exist.
const EffectRow& effect_row(const std::string& name);
const EffectRow& effect_row(Effect effect);

}  // namespace vantage
