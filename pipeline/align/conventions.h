#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "pipeline/align/feature_errors.h"
#include "pipeline/input/scene_input.h"

namespace vantage {

/// No convention, and what else may be given in place of names.
inline constexpr const char* as_read = "as-read";
inline constexpr const char* convention_auto = "auto";

/// What --convention takes: the names of conventions, "as-read" and "auto".
std::vector<std::string> convention_names();
/// The names joined by commas. Throws Error(usage) for an unknown name, and for "auto" or "as-read" with
/// others.
std::string wanted_conventions(const std::vector<std::string>& names);

/// Applies conventions by their names, joined by commas; "as-read" for none. Throws Error(usage) for an
/// unknown name.
void apply_conventions(SceneInput& scene, const std::string& names);

/// How well the photos agree under one convention.
struct ConventionTrial {
    std::string names;     ///< as apply_conventions() takes them
    std::size_t features;  ///< shared features that were tried
    std::size_t defined;   ///< those with an error: the ray meets the mesh
    double agreement;      ///< mean over all features of 1 / (1 + (error / 0.1 %)^2): 0 to 1
    double median;         ///< of the errors that are defined, a share of the photo's longer side
};

/// `errors`: see feature_errors.h.
ConventionTrial trial_of(const std::string& names, std::span<const double> errors);

/// Conventions of cameras first, by epipolar errors; then those of the mesh, by where the mesh shows the
/// features that agree with the cameras.
struct ConventionTrials {
    std::vector<ConventionTrial> cameras, mesh;  ///< the first of each: as read
    std::string chosen = as_read;
    std::size_t chosen_of_mesh = 0;  ///< in `mesh`
    bool misfit = false;       ///< cameras and photos agree, but no convention makes the mesh agree with them
    std::size_t shared = 0;    ///< features that were tried
    std::size_t agreeing = 0;  ///< those near their epipolar lines under `chosen`
    double expected = 1;       ///< the largest median of `mesh` that is expected, as features are this exact
    std::string not_validated;  ///< why `mesh` is empty; empty if it is not
};

/// Tries every convention and combination that changes a camera, on features of up to 18 photos. Another one
/// than as read is chosen if the photos agree with it at least twice as well, and clearly better than with
/// all others.
ConventionTrials try_conventions(const SceneInput& scene, const FeatureSettings& how = {});

/// Applies the convention that the user wants, or the one that try_conventions() chooses, and warns of one
/// that is not as read, of cameras that do not agree with photos, and of a mesh that shows features off.
/// Returns the trials: none if the user wants a convention, or without a mesh. Throws Error(misplaced) if no
/// convention makes the mesh fit.
ConventionTrials settle_convention(SceneInput& scene, const std::string& wanted, unsigned threads);

/// "the mesh shows 2867 of 2899 features where photos do, to 1.3 px (median)", px of the first photo, or "not
/// judged: " and why; empty if nothing was to be tried.
std::string fit_of(const ConventionTrials& trials, const SceneInput& scene);

}  // namespace vantage
