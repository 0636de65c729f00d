#include "player/render/passes/cluster_draws.h"

#include <algorithm>
#include <cstring>

#include "shaders/contract.h"

namespace vantage {
namespace {

/// Depth of the background: a power of two preserves the precision of floats.
constexpr float background_depth = 0x1p-60f;
static_assert(background_depth < depth_behind_mesh);

/// Upper bound on the bytes that one pass writes for draws.
std::size_t draw_bytes(std::size_t clusters) {
    return clusters * (sizeof(DrawCommand) + sizeof(DrawRecord)) + 4096;
}

}  // namespace

ClusterDraws::ClusterDraws(const PackageReader& package, const PlanScene& scene)
    : scene_(&scene), model_(load_model(package, scene)), ring_("draws", draw_bytes(scene.clusters.size())) {}

bool ClusterDraws::show_values(std::span<const float> values) {
    const bool first = !model_.values;
    vantage::show_values(model_, *scene_, values);
    return first;
}

void ClusterDraws::update() {
    ++updates_;
    write_hidden(model_, *scene_);
    coarse_ = {};
}

void ClusterDraws::use_coarse(CoarseMesh mesh) {
    if (add_coarse_mesh(model_, *scene_, mesh)) coarse_ = std::move(mesh);
}

/// Draws the coarse mesh in one command, since it is small.
void ClusterDraws::draw_coarse(Clusters clusters, std::size_t eyes) {
    const FrameRing::Space records = ring_.take(sizeof(DrawRecord));
    const DrawRecord record{std::uint32_t(scene_->triangles), 1};
    std::memcpy(records.memory, &record, sizeof record);
    glVertexArrayVertexBuffer(model_.vertices.id(), shader::draw_attribute, ring_.buffer(), records.offset,
                              sizeof(DrawRecord));
    glBindVertexArray(model_.vertices.id());
    glDrawElementsInstanced(GL_TRIANGLES, GLsizei(coarse_.indices.size()), GL_UNSIGNED_INT,
                            reinterpret_cast<const void*>(scene_->indices.size() * sizeof(std::uint32_t)),
                            GLsizei(eyes));
    const auto behind = std::ranges::lower_bound(clusters, scene_->first_surrounding);
    draw(clusters.subspan(std::size_t(behind - clusters.begin())), {}, eyes);
}

std::size_t ClusterDraws::draw(Clusters clusters, std::span<const std::uint32_t> photos, std::size_t eyes) {
    const auto behind = std::ranges::lower_bound(clusters, scene_->first_surrounding);
    const auto of_mesh = std::size_t(behind - clusters.begin());
    std::size_t draws = draw_run(clusters.first(of_mesh), photos, 0, eyes);
    if (of_mesh < clusters.size()) draws += draw_background(clusters.subspan(of_mesh), photos, eyes);
    return draws;
}

/// The background never occludes the mesh, even if its depths are wrong; back faces are culled.
std::size_t ClusterDraws::draw_background(Clusters clusters, std::span<const std::uint32_t> photos,
                                          std::size_t eyes) {
    glDepthRangef(0, background_depth);
    glEnable(GL_CULL_FACE);
    glFrontFace(GL_CW);  // row 0 of a frame is its top row, which mirrors triangles
    const std::size_t draws = draw_run(clusters, photos, shader::background_bit, eyes);
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
    glDepthRangef(0, 1);
    return draws;
}

std::size_t ClusterDraws::draw_run(Clusters clusters, std::span<const std::uint32_t> photos,
                                   std::uint32_t bits, std::size_t eyes) {
    const std::size_t most = clusters.size();
    if (most == 0) return 0;
    const auto photos_of = [&](std::uint32_t cluster) { return photos.empty() ? 1u : photos[cluster]; };
    const FrameRing::Space commands = ring_.take(most * sizeof(DrawCommand)),
                           records = ring_.take(most * sizeof(DrawRecord));
    std::uint32_t draws = 0;
    for (std::size_t i = 0; i < most;) {
        const std::uint32_t first = clusters[i];
        std::uint32_t triangles = 0;
        do triangles += scene_->clusters[clusters[i++]].triangles;
        while (i < most && clusters[i] == clusters[i - 1] + 1 && photos_of(clusters[i]) == photos_of(first));
        if (!photos_of(first)) continue;
        const std::uint32_t start = scene_->clusters[first].first_triangle;
        const DrawCommand command{3 * triangles, std::uint32_t(eyes), 3 * start, 0, draws};
        const DrawRecord record{start, photos_of(first) | bits};
        std::memcpy(commands.memory + draws * sizeof command, &command, sizeof command);
        std::memcpy(records.memory + draws * sizeof record, &record, sizeof record);
        ++draws;
    }
    glVertexArrayVertexBuffer(model_.vertices.id(), shader::draw_attribute, ring_.buffer(), records.offset,
                              sizeof(DrawRecord));
    glBindVertexArray(model_.vertices.id());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, ring_.buffer());
    glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, reinterpret_cast<const void*>(commands.offset),
                                GLsizei(draws), 0);
    return draws;
}

}  // namespace vantage
