#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/geometry_stages.h"
#include "pipeline/prepare_plan.h"
#include "pipeline/refine/refine.h"
#include "pipeline/refine/registration.h"

namespace vantage {

/// A package all of whose photos are written.
struct FinishInput {
    const GeometryStages& geometry;
    std::filesystem::path out;  ///< what the writer writes
    std::string meta;           ///< as provenance() has it
    package::SceneRecord scene;
    std::vector<Pose> given;  ///< relative to the origin; records have others where `known` moved them
    std::optional<Registration> known;             ///< what an earlier package found for just this
    std::vector<package::PairRecord> known_pairs;  ///< that an earlier package measured
    unsigned threads;
    OnProgress progress;  ///< may be empty
};

/// What single photos show that others agree is not there.
struct Consensus {
    EffectDecision decision;
    std::vector<double> disagreeing;  ///< share of the surface in each photo
};

/// What only all photos together tell.
struct Agreement {
    Registration registration;
    ColorRefinement colors;
    Consensus consensus;
};

/// Every `step`-th.
std::vector<SurfaceDisc> thinned(std::span<const SurfaceDisc> discs, std::size_t step);

/// Settles what only all photos together tell, their cameras and colours, and finishes the package: META,
/// SCEN, PHOT, STAT, REGI and PAIR, and anew what comes from cameras that were moved. Throws Error(storage),
/// and what `progress` throws.
Agreement finish_package(const FinishInput& input, PhotoTables& photos);

}  // namespace vantage
