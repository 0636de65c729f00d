#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vantage {

/// A correction or feature that a scene may need. For each effect, there is a row in the table in
/// effects.cpp, code that measures and applies it, and, if it changes how scenes are drawn, a branch in a
/// shader. The order of the effects is that of the bits in SceneRecord::effects.
enum class Effect : int {
    undistortion,
    per_fragment,
    fov_normalization,
    vertex_colors,
    exposure,
    vignetting,
    pose_refinement,
    transients,
    background,
    scalar_fields,
    points,
    image_sets,
    transparency,
    compact,
    count
};

/// The data that decides whether an effect is on.
enum class Basis {
    scene,      ///< the cameras and the mesh, before any photo is prepared
    colors,     ///< the surface colors in all photos, after all are prepared
    pixels,     ///< the surface, matched between photos, after all are prepared
    background  ///< the background in all photos, after all are prepared
};

/// A row of the table of effects, which is constant.
struct EffectRow {
    Effect effect;
    const char* name;      ///< as stored in packages
    const char* option;    ///< the name documented for the command line, which also accepts `name`
    const char* measures;  ///< the quantity compared with the threshold; stored in packages
    const char* unit;      ///< unit of the measured value; stored in packages
    double threshold;      ///< the effect is on if the value exceeds it
    Basis basis;
    const char* program;  ///< the shader program that the effect changes; "" if there is none
    const char* define;   ///< the preprocessor symbol that enables the effect there; "" if there is none
};
std::span<const EffectRow> effect_table();

/// The row with this name, in either spelling. If there is none, throws Error(usage), which lists the names.
const EffectRow& effect_row(std::string_view name);
const EffectRow& effect_row(Effect effect);

/// True if the effect is decided from all photos together, after all are prepared.
inline bool from_all_photos(const EffectRow& row) { return row.basis != Basis::scene; }

/// The gain from an effect in photos that are held out completely and predicted from the other photos.
struct Judgment {
    int photos = 0;              ///< number of photos held out
    double gain = 0, error = 0;  ///< mean, after fitting a color gain per channel, and standard error; dB
    double noise = 0;            ///< the standard error estimated from the losses, see summarize(); dB
    double worst = 0;            ///< the lowest gain in any photo; dB
    int worse = 0;               ///< number of photos that get worse
    double ssim = 0;             ///< mean change
    double seams_before = 0, seams_after = 0;  ///< gray levels
    std::string worst_photo;
};

/// The decision about an effect for one image set (see EffectDecision).
struct ImageSetDecision {
    std::string image_set;
    bool on = false;
    double measured = 0;
    std::string evidence;
    std::optional<Judgment> judgment{};
};

/// A decision with its evidence, as recorded in the package.
struct EffectDecision {
    Effect effect;
    bool on = false;
    bool forced = false;                         ///< set by --effect NAME=on|off
    double measured = 0;                         ///< in the row's unit
    std::string evidence;                        ///< one human-readable sentence
    std::optional<Judgment> judgment{};          ///< set if photos were held out to make the decision
    std::vector<ImageSetDecision> image_sets{};  ///< one per image set, if decided separately; the effect
                                                 ///< is on if it is on for any image set
};

enum class EffectChoice { automatic, on, off };
/// The user's choice, or `automatic`.
EffectChoice choice_of(const std::map<Effect, EffectChoice>& choices, Effect effect);

/// Decides one effect. If `measured` is not finite, an automatic effect stays off.
EffectDecision decide(Effect effect, EffectChoice choice, double measured, std::string evidence);

/// A set of effects; bit i stands for Effect i.
using EffectSet = std::uint64_t;
constexpr EffectSet effect_bit(Effect effect) { return EffectSet(1) << int(effect); }
/// All effects that are decided from `basis`.
EffectSet effects_from(Basis basis);

/// The symbols to define in a shader program ("surface" or "blend") for the effects that are on.
std::vector<std::string> shader_defines(std::string_view program, EffectSet on);

}  // namespace vantage
