#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "pipeline/align/feature_errors.h"
#include "pipeline/input/scene_input.h"

namespace vantage {

/// "as-read" applies no convention; with "auto", settle_convention() chooses one.
inline constexpr const char* as_read = "as-read";
inline constexpr const char* convention_auto = "auto";

/// The values of --convention: the names of conventions, "as-read" and "auto".
std::vector<std::string> convention_names();
/// The names joined by commas. Throws Error(usage) if a name is unknown, or if "auto" or "as-read" is
/// combined with other names.
std::string wanted_conventions(const std::vector<std::string>& names);

/// Applies the named conventions, joined by commas, or none for "as-read". Throws Error(usage) if a name is
/// unknown.
void apply_conventions(SceneInput& scene, const std::string& names);

/// The agreement of the photos under one convention.
struct ConventionTrial {
    std::string names;     ///< in the form that apply_conventions() takes
    std::size_t features;  ///< number of shared features tested
    std::size_t defined;   ///< features with a defined error: their rays hit the mesh
    double agreement;      ///< 0 to 1: mean of 1 / (1 + (error / 0.1 %)^2) over all features
    double median;         ///< median defined error, as a fraction of the photo's longer side
};

/// For `errors`, see feature_errors.h.
ConventionTrial trial_of(const std::string& names, std::span<const double> errors);

/// The trials of all conventions. Camera conventions are tested first, by their epipolar errors. Mesh
/// conventions are tested next, by the surface errors of the features that agree with the cameras.
struct ConventionTrials {
    std::vector<ConventionTrial> cameras, mesh;  ///< in each, the first trial is that of the input as read
    std::string chosen = as_read;
    std::size_t chosen_of_mesh = 0;  ///< in `mesh`
    bool misfit = false;       ///< cameras and photos agree, but no convention makes the mesh agree with them
    std::size_t shared = 0;    ///< number of features tested
    std::size_t agreeing = 0;  ///< features near their epipolar lines under `chosen`
    double expected = 1;       ///< the largest expected median of `mesh`, from the accuracy of the features
    std::string not_validated;  ///< the reason why `mesh` is empty; otherwise empty
};

/// Tries every convention and combination that changes a camera, on features of up to 18 photos. A convention
/// replaces "as-read" if its agreement is at least twice as high, and clearly above that of all others.
ConventionTrials try_conventions(const SceneInput& scene, const FeatureSettings& how = {});

/// Applies the convention that the user wants, or the one that try_conventions() chooses. Warns of any
/// convention but "as-read", of cameras that disagree with the photos, and of a displaced mesh. Returns the
/// trials; there are none if the user names a convention or there is no mesh. Throws Error(misplaced) if no
/// convention makes the mesh fit.
ConventionTrials settle_convention(SceneInput& scene, const std::string& wanted, unsigned threads);

/// A phrase such as "the mesh shows 2867 of 2899 features where the photos do (median error 1.3 px)", in px
/// of the first photo, or the reason why the fit was not judged; empty if nothing was tried.
std::string fit_of(const ConventionTrials& trials, const SceneInput& scene);

}  // namespace vantage
