#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pipeline/output/fingerprint.h"
#include "pipeline/run/settings.h"
#include "pipeline/stages/stage_input.h"
#include "scene/package/chunk_table.h"
#include "scene/package/package_format.h"

namespace vantage {

inline constexpr std::size_t stage_count = std::size_t(package::Stage::count);

/// The pixel data that a stage reads. `alpha`: only the transparency.
enum class PixelInput { none, alpha, all };

/// The scene-wide inputs of the per-photo stages.
struct SceneKey {
    const PrepareSettings& settings;
    DistanceMethod distance;       ///< never automatic
    bool opengl;                   ///< whether the model is rendered by OpenGL instead of the CPU
    bool undistortion;             ///< whether the effect is on
    bool compact;                  ///< whether the effect is on
    std::uint64_t model;           ///< XXH3-64 of geometry and clusters; see model_checksum()
    double reference_density = 1;  ///< reference density of the depth weight
};

/// A per-photo stage: a row of the stage table.
struct StageRow {
    package::Stage stage;
    const char* name;
    std::uint32_t version;  ///< incremented whenever a change to the code changes the stage's output
    PixelInput pixels;
    bool model;     ///< whether the stage projects or renders the model from the photo's pose
    bool held_out;  ///< whether the stage also runs for held-out photos
    std::vector<std::string> settings;  ///< settings that the stage reads, named as in META's configuration
    /// Adds the settings that no other input covers to the stage's key; may be null.
    void (*key)(Fingerprint&, const SceneKey&);
    /// Copies the stage's measurements from the record of the run that made them; may be null.
    void (*adopt)(const package::PhotoRecord& from, package::PhotoRecord& to);
    void (*make)(StageInput& in);        ///< for a stage that uses the model, otherwise null
    void (*make_level)(LevelInput& in);  ///< for other stages: called with each level of the pyramid
};
/// The rows, in the order of package::Stage.
std::span<const StageRow> stage_table();
const StageRow& stage_row(package::Stage stage);

/// The chunks that a stage writes for a photo of `levels` pyramid levels.
std::vector<LeveledChunk> chunks_of(package::Stage stage, int levels);

/// The stages that run for a photo: all stages or, if it is held out, those for held-out photos.
std::vector<package::Stage> stages_of(const package::PhotoRecord& record);

/// A set of stages, such as those still missing for a photo.
class StageSet {
  public:
    void add(package::Stage stage) { in_[std::size_t(stage)] = true; }
    bool operator[](package::Stage stage) const { return in_[std::size_t(stage)]; }
    /// Whether any stage uses the model.
    bool needs_model() const;
    /// Whether any stage reads pixels of a photo, which has transparent pixels if `has_alpha` is set.
    bool needs_pixels(bool has_alpha) const;

  private:
    std::array<bool, stage_count> in_{};
};
/// Runs the stages in `missing` that do not use the model on one level of the photo.
void make_on_level(LevelInput& in, const StageSet& missing);
/// All stages that use the model; they run again when a camera moves.
StageSet stages_on_model();
/// Runs the stages in `missing` that use the model; those that need no pixels run first, while the photo is
/// still being decoded.
void make_on_model(StageInput& in, const StageSet& missing);

}  // namespace vantage
