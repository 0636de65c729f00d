#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/package/fingerprint.h"
#include "pipeline/settings/settings.h"
#include "scene/package_format.h"

namespace vantage {

inline constexpr std::size_t stage_count = std::size_t(package::Stage::count);

/// What a stage reads of a photo's pixels. `alpha`: which of them are transparent, nothing else.
enum class PixelInput { none, alpha, all };

/// The pyramid levels for which a stage writes its chunks.
enum class ChunkLevels { single, tiles, masks };

/// The scene-wide inputs of the per-photo stages.
struct SceneKey {
    const PrepareSettings& settings;
    DistanceMethod distance;       ///< never automatic
    bool opengl;                   ///< OpenGL renders the model, else the CPU
    bool undistortion;             ///< the effect is on
    std::uint64_t model;           ///< XXH3-64 of geometry and clusters, see model_checksum
    double reference_density = 1;  ///< of the depth mask
};

/// What is to be known of a per-photo stage: the one list of stages. Its code is in pipeline/stages.
struct StageRow {
    package::Stage stage;
    const char* name;
    std::uint32_t version;  ///< incremented whenever a change to the code changes what the stage makes
    PixelInput pixels;
    bool model;     ///< renders or projects the model from the photo's pose
    bool held_out;  ///< runs for held-out photos, too
    ChunkLevels levels;
    std::vector<package::Type> chunks;  ///< written for each of the levels
    std::vector<std::string> settings;  ///< that the stage reads, named as in META's configuration
    /// Adds the settings that belong to no other input to the stage's key; may be null.
    void (*key)(Fingerprint&, const SceneKey&);
    /// Copies what the stage finds out about a photo from the record of the run that made it; may be null.
    void (*adopt)(const package::PhotoRecord& from, package::PhotoRecord& to);
};
/// In the order of package::Stage.
std::span<const StageRow> stage_table();
const StageRow& stage_row(package::Stage stage);

/// The chunks that a stage writes for a photo of `levels` pyramid levels: type and level.
std::vector<std::pair<package::Type, std::uint32_t>> chunks_of(const StageRow& row, int levels);

/// The stages that a photo goes through: all, or those for held-out photos.
std::vector<package::Stage> stages_of(const package::PhotoRecord& record);

/// A set of stages, such as those still missing for a photo.
class StageSet {
  public:
    void add(package::Stage stage) { in_[std::size_t(stage)] = true; }
    bool operator[](package::Stage stage) const { return in_[std::size_t(stage)]; }
    /// Any of them looks at the model.
    bool needs_model() const;
    /// Any of them reads pixels of a photo that has, or has not, transparent ones.
    bool needs_pixels(bool has_alpha) const;

  private:
    std::array<bool, stage_count> in_{};
};
/// All that look at the model: those to be made again when a camera moves.
StageSet stages_on_model();

}  // namespace vantage
