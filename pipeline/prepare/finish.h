#pragma once
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/prepare/photo/photo_tables.h"
#include "pipeline/presentation/presentation.h"
#include "pipeline/refine/color_agreement.h"
#include "pipeline/refine/poses/pose_refinement.h"
#include "pipeline/run/until_stopped.h"
#include "pipeline/stages/stage_input.h"

namespace vantage {

/// Input of finish_package: a package whose per-photo chunks have all been written.
struct FinishInput {
    const GeometryContext& geometry;
    std::filesystem::path out;  ///< the package being written
    std::string meta;           ///< see make_meta
    std::map<Effect, EffectChoice> choices;
    bool validate = true;  ///< see PrepareSettings
    package::SceneRecord scene;
    std::vector<std::string> image_sets{""};  ///< names, see ImageSet
    std::vector<Pose> given;  ///< relative to the origin; if `known` is set, the records' poses may differ
    std::optional<PoseRefinement> known;  ///< found in an earlier package that was made from the same inputs
    std::vector<package::PairRecord> known_pairs;  ///< found in earlier packages
    unsigned threads = 0;                          ///< 0: all cores
    OnProgress progress;                           ///< may be empty
};

/// Content that appears in individual photos and is contradicted by others.
struct TransientMasks {
    EffectDecision decision;
    std::vector<double> disagreeing;  ///< per photo: the contradicted fraction of its visible surface
};

/// Results that depend on all photos together.
struct Agreement {
    PoseRefinement pose_refinement;
    ColorRefinement colors;
    TransientMasks transients;
    EffectDecision background;
    std::array<double, 3> shade{};  ///< see Background
    Presentation presentation;
};

/// The decisions on the effects that depend on all photos, in the order of the effect table.
std::array<EffectDecision*, 5> decisions_of(Agreement& agreement);

/// Determines cameras, colors and transient masking from all photos and finishes the package: writes META,
/// SCEN, PHOT, STAT, REGI and PAIR, and rewrites the chunks that depend on moved cameras. Throws
/// Error(storage), and whatever `progress` throws.
Agreement finish_package(const FinishInput& input, PhotoTables& photos);

}  // namespace vantage
