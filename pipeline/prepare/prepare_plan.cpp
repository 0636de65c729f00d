#include "pipeline/prepare/prepare_plan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/text/error.h"
#include "pipeline/mesh/deviation.h"
#include "pipeline/mesh/stand_in.h"
#include "pipeline/mesh/subdivide.h"
#include "pipeline/output/chunk_plan.h"
#include "pipeline/output/meta.h"
#include "pipeline/output/photo_records.h"
#include "pipeline/photos/reduced.h"
#include "pipeline/stages/borders.h"
#include "pipeline/stages/decide_effects.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {
namespace {

/// The RMS distance of the vertices inside the model's bounds from their mean. It is invariant under
/// rotation.
double spread(const Mesh& mesh, const package::SceneRecord& model) {
    const Eigen::AlignedBox3d bounds(Eigen::Map<const Eigen::Vector3d>(model.bounds_min),
                                     Eigen::Map<const Eigen::Vector3d>(model.bounds_max));
    const auto inside = [&](const Eigen::Vector3d& p) { return bounds.contains(p); };
    const auto n = double(std::ranges::count_if(mesh.positions, inside));
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : mesh.positions)
        if (inside(p)) mean += p / n;
    double squares = 0;
    for (const Eigen::Vector3d& p : mesh.positions)
        if (inside(p)) squares += (p - mean).squaredNorm() / n;
    return squares > 0 ? std::sqrt(squares) : 1;
}

/// The finest density, rounded up to a power of two, so that adding or removing a photo does not change every
/// weight map. An octave corresponds to twelve steps of the depth weight. The powers of two are relative to
/// the model's size, because otherwise the rounding would depend on the unit of the input.
double reference_density(const SceneInput& scene, const package::SceneRecord& model) {
    const double size = spread(scene.mesh, model);
    return std::exp2(std::ceil(std::log2(finest_density(scene) * size))) / size;
}

package::SceneRecord scene_record(const PackedModel& model, const SceneInput& scene,
                                  const std::vector<EffectDecision>& effects) {
    package::SceneRecord record = model.record;
    record.photos = scene.photos.size();
    record.reference_density = reference_density(scene, model.record);
    record.border_width = border_width;
    for (const EffectDecision& d : effects) record.effects |= std::uint64_t(d.on) << int(d.effect);
    if (has_points_only(scene)) record.effects |= points_only_bit;
    if (effect_on(record, Effect::scalar_fields)) record.scalar_fields = scene.mesh.scalars.size();
    return record;
}

/// The name of the field. It contains the name of the reference file, or of its folder if the file has the
/// same name as the mesh.
std::string name_of_deviation(const std::filesystem::path& from, const std::filesystem::path& mesh) {
    const bool same = from.filename() == mesh.filename() && from.has_parent_path();
    const std::filesystem::path folder = std::filesystem::absolute(from).parent_path();
    return "deviation-from-" + (same ? folder.filename() : from.stem()).string();
}

/// Adds one field per reference mesh and frees the reference meshes.
void add_deviations(SceneInput& scene, Trace* trace) {
    for (std::size_t i = 0; i < scene.compared.size(); ++i) {
        const Traced traced(trace, "deviation");
        std::string name = name_of_deviation(scene.files.compared[i], scene.files.mesh);
        while (std::ranges::count(scene.mesh.scalars, name, &VertexField::name) > 0) name += "-2";
        scene.mesh.scalars.push_back({name, deviation(scene.mesh, scene.compared[i])});
    }
    scene.compared.clear();
}

/// Packs the stand-in for the points. Its facets are visible from both sides, because points have no
/// orientation.
PackedModel pack_stand_in(SceneInput& scene) {
    std::vector<Eigen::Vector3d> eyes;
    for (const PhotoInput& photo : scene.photos) eyes.push_back(photo.camera.cam_from_world.center());
    scene.mesh = stand_in(scene.points, eyes);
    Eigen::AlignedBox3d bounds;
    for (const Eigen::Vector3d& p : scene.points.positions) bounds.extend(p);
    PackedModel model = pack_model(scene.mesh, {bounds.min(), bounds.max(), {}});
    for (package::ClusterRecord& c : model.clusters) c.cone_cutoff = 1;
    return model;
}

}  // namespace

void expect_usable(const SceneInput& scene, const PrepareSettings& settings) {
    if (has_points_only(scene) && choice_of(settings.effects, Effect::points) == EffectChoice::off)
        throw Error(Exit::usage, scene.files.points.front().string() +
                                     ": the scene has points only, expected --effect points=on or auto");
    if (scene.mesh.points_only() && !has_points_only(scene))
        throw Error(Exit::input,
                    scene.files.mesh.string() +
                        ": has points only, expected a mesh with triangles; --points shows points");
}

void reduce_photos(SceneInput& scene, int longest) {
    for (PhotoInput& photo : scene.photos) {
        Intrinsics& k = photo.camera.intrinsics;
        const Level size = thumbnail_size(k.width, k.height, longest);
        k = k.scaled(size.width, size.height);
    }
}

PackedModel make_model(SceneInput& scene, const PrepareSettings& settings, Trace* trace) {
    const Traced traced(trace, "model");
    if (has_points_only(scene)) return pack_stand_in(scene);
    const MainBox box = main_box(scene.mesh);
    subdivide_large_triangles(scene.mesh, box);
    add_deviations(scene, trace);
    return pack_model(scene.mesh, box, has_transparency(scene.mesh, settings.effects));
}

PreparePlan make_plan(const PackedModel& model, const SceneInput& scene, const PrepareSettings& settings,
                      Share share, IdentityCache& identities, Trace* trace) {
    const Traced traced(trace, "inspect");
    PreparePlan plan;
    plan.effects = inspect(scene, settings.effects);
    plan.scene = scene_record(model, scene, plan.effects);
    plan.photos.records = photo_records(scene, settings, model.origin);
    plan.photos.states.resize(plan.photos.records.size());
    plan.meta = make_meta(scene, settings, plan.effects, identities);
    if (effect_on(plan.scene, Effect::points)) {
        const Traced points(trace, "points");
        plan.points = make_point_tree(scene.points, model.origin);
    }
    if (effect_on(plan.scene, Effect::image_sets)) {
        plan.image_sets = scene.image_sets;
        for (std::size_t i = 0; i < scene.photos.size(); ++i)
            plan.photos.records[i].image_set = scene.photos[i].image_set;
    }
    using package::Type;
    const std::size_t image_sets = plan.image_sets.size() > 1 ? plan.image_sets.size() : 0;
    plan.chunks =
        plan_chunks(plan.scene,
                    {.bytes = {{Type::meta, plan.meta.size()},
                               {Type::point_nodes, plan.points.nodes.size() * sizeof(package::PointNode)},
                               {Type::image_sets, image_sets * sizeof(package::ImageSetRecord)}},
                     .colors = !scene.mesh.colors.empty(),
                     .point_blocks = plan.points.blocks,
                     .coordinates = stores_coordinates(plan.scene, settings.vertex_coordinates)},
                    plan.photos.records, share);
    plan.names = names_checksum(plan.photos.records);
    return plan;
}

}  // namespace vantage
