#include "pipeline/prepare_plan.h"

#include <cmath>

#include "pipeline/provenance.h"
#include "pipeline/stages/inspect.h"
#include "pipeline/stages/pyramid.h"
#include "pipeline/stages/subdivide.h"
#include "pipeline/trace.h"

namespace vantage {
namespace {

/// How far vertices lie from their mean (root of the mean square): the same however the model is turned.
double spread(const Mesh& mesh) {
    const auto n = double(mesh.positions.size());
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : mesh.positions) mean += p / n;
    double squares = 0;
    for (const Eigen::Vector3d& p : mesh.positions) squares += (p - mean).squaredNorm() / n;
    return squares > 0 ? std::sqrt(squares) : 1;
}

/// An octave of the depth mask is twelve of its steps: rounded up to the next, the reference does not move
/// with every photo that comes or goes, and all masks with it. Octaves of the model's size, not of its units,
/// which would round the masks differently.
double reference_density(const SceneInput& scene) {
    const double size = spread(scene.mesh);
    return std::exp2(std::ceil(std::log2(finest_density(scene) * size))) / size;
}

void complete_record(package::SceneRecord& record, const SceneInput& scene, const PrepareSettings& settings,
                     const std::vector<EffectDecision>& effects) {
    record.photos = scene.photos.size();
    record.reference_density = reference_density(scene);
    record.border_width = settings.border_width;
    record.scalar_layers = scene.mesh.scalars.size();
    for (const EffectDecision& d : effects) record.effects |= std::uint64_t(d.on) << int(d.effect);
}

}  // namespace

void reduce_photos(SceneInput& scene, int longest) {
    for (PhotoInput& photo : scene.photos) {
        Intrinsics& k = photo.camera.intrinsics;
        const Level size = thumbnail_size(k.width, k.height, longest);
        k = k.scaled(size.width, size.height);
    }
}

PackedModel make_model(SceneInput& scene, const PrepareSettings& settings, Trace* trace) {
    const Traced traced(trace, "model");
    subdivide_large_triangles(scene.mesh);
    return pack_model(scene.mesh, settings.cluster_triangles);
}

void complete_plan(PreparePlan& plan, const SceneInput& scene, const PrepareSettings& settings,
                   const PrepareRun& run, IdentityCache& identities) {
    const Traced traced(run.trace, "inspect");
    const std::vector<EffectDecision> effects = inspect(scene, settings.effects);
    complete_record(plan.model.record, scene, settings, effects);
    plan.photos.records = photo_records(scene, settings, plan.model.origin);
    plan.photos.states.resize(plan.photos.records.size());
    plan.meta = provenance(scene, settings, effects, identities);
    plan.chunks = plan_chunks(plan.model.record, {plan.meta.size(), !scene.mesh.colors.empty()},
                              plan.photos.records, run.share);
    plan.names = names_checksum(plan.photos.records);
}

}  // namespace vantage
