#include "player/render/passes/point_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "shaders/contract.h"

namespace vantage {
namespace {

constexpr float largest = 64;    ///< diameter of a point, px
constexpr float filling = 1.7f;  ///< diameter over spacing, so that randomly placed points leave few gaps

struct Command {  ///< a draw of glMultiDrawArraysIndirect
    std::uint32_t count, instances, first, base_instance;
};
struct Record {
    float cube[4];
    std::uint32_t node;  ///< index among the drawn nodes
};

enum Binding : GLuint { points_binding, records_binding };

gl::VertexArray make_vertices() {
    gl::VertexArray out = gl::make_vertex_array("points");
    const GLuint id = out.id();
    glVertexArrayAttribIFormat(id, shader::cell_attribute, 2, GL_UNSIGNED_INT, 0);
    glVertexArrayAttribFormat(id, shader::color_attribute, 4, GL_UNSIGNED_BYTE, GL_TRUE,
                              offsetof(package::PackedPoint, color));
    glVertexArrayAttribFormat(id, shader::cube_attribute, 4, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribIFormat(id, shader::node_attribute, 1, GL_UNSIGNED_INT, offsetof(Record, node));
    for (const auto& [attribute, binding] : {std::pair(shader::cell_attribute, points_binding),
                                             std::pair(shader::color_attribute, points_binding),
                                             std::pair(shader::cube_attribute, records_binding),
                                             std::pair(shader::node_attribute, records_binding)}) {
        glVertexArrayAttribBinding(id, GLuint(attribute), binding);
        glEnableVertexArrayAttrib(id, GLuint(attribute));
    }
    glVertexArrayBindingDivisor(id, records_binding, 1);
    return out;
}

void set_size(const View& view, const PointSettings& s) {
    const auto focal = float(std::sqrt(view.intrinsics.fx * view.intrinsics.fy)), size = float(s.size);
    glUniform4f(shader::point_size_uniform, s.by == PointSize::pixels ? size : 0,
                s.by == PointSize::world ? size * focal : 0,
                s.by == PointSize::gaps ? filling * size * focal : 0, largest);
}

gl::Program make_point_program(const std::vector<std::string>& defines) {
    return gl::make_program("point", {{GL_VERTEX_SHADER, "point.vert"}, {GL_FRAGMENT_SHADER, "point.frag"}},
                            defines);
}

std::vector<float> own_spacings(const PointCloud& cloud) {
    std::vector<float> out;
    for (const package::PointNode& n : cloud.nodes) out.push_back(n.spacing);
    return out;
}

}  // namespace

PointPass::PointPass(const PackageReader& package, PointCloud cloud, std::uint64_t bytes)
    : cloud_(std::move(cloud)),
      spacings_(points_only(package.scene()) ? local_spacings(cloud_.nodes) : own_spacings(cloud_)),
      only_(points_only(package.scene())),
      store_(package, cloud_, bytes),
      ring_("drawn points", std::min(max_point_nodes, cloud_.nodes.size()) *
                                    (sizeof(Command) + sizeof(Record) + sizeof(shader::PointSizes)) +
                                1024),
      program_(make_point_program({})),
      vertices_(make_vertices()) {
    if (cloud_.nodes.empty()) return;
    // The coarsest points fill the first frame, like the base levels of photos.
    store_.begin_frame(0);
    store_.need(cloud_.nodes.front());
    store_.load();
}

void PointPass::fit(const FrameTargets& targets, bool placed) {
    const auto [width, height] = targets.allocated;
    release();
    picture_ = gl::make_texture_2d("frame points", GL_RGBA16F, width, height);
    if (!placed) {
        target_ =
            gl::make_framebuffer("frame points", std::array{picture_.id()}, targets.surface().depth.id());
        return;
    }
    places_ = gl::make_texture_2d("points' places", GL_RG32F, width, height);
    numbers_ = gl::make_texture_2d("points' numbers", GL_R32UI, width, height);
    target_ = gl::make_framebuffer("frame points", std::array{picture_.id(), places_.id(), numbers_.id()},
                                   targets.surface().depth.id());
    if (!placed_program_) placed_program_ = make_point_program({"PLACED"});
}

std::size_t PointPass::stream(const View& view, const RenderSettings& settings, int side, double now) {
    plan_ = plan_points(cloud_, view, settings.points.budget, side);
    store_.begin_frame(now);
    for (const std::uint32_t node : plan_.nodes) store_.need(cloud_.nodes[node]);
    std::size_t uploaded = 0;
    if (waits_for_tiles(settings.loading))
        store_.load();
    else
        uploaded = store_.stream(settings.upload_bytes);
    missing_ = std::size_t(std::ranges::count_if(
        plan_.nodes, [&](std::uint32_t node) { return store_.awaits(cloud_.nodes[node]); }));
    return uploaded;
}

std::size_t PointPass::draw(const View& view, const Eigen::Matrix4f& clip_from_origin,
                            const PointSettings& settings) {
    drawn_ =
        drawn_nodes(cloud_, plan_, [&](std::uint32_t node) { return store_.resident(cloud_.nodes[node]); });
    const std::vector<DrawnNode>& nodes = drawn_;
    ring_.begin();
    const FrameRing::Space commands = ring_.take(nodes.size() * sizeof(Command)),
                           records = ring_.take(nodes.size() * sizeof(Record)),
                           sizes = ring_.take(nodes.size() * sizeof(shader::PointSizes));
    std::size_t points = 0;
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        const package::PointNode& n = cloud_.nodes[nodes[i].node];
        const Command command{n.count, 1, store_.first_point(n), i};
        const Record record{{n.low[0], n.low[1], n.low[2], n.size}, i};
        const shader::PointSizes size{nodes[i].children, nodes[i].first, spacings_[nodes[i].node],
                                      placed() ? store_.first_point(n) : 0};
        std::memcpy(commands.memory + i * sizeof command, &command, sizeof command);
        std::memcpy(records.memory + i * sizeof record, &record, sizeof record);
        std::memcpy(sizes.memory + i * sizeof size, &size, sizeof size);
        points += n.count;
    }
    const std::array<float, 4> zero{};
    glClearNamedFramebufferfv(target_.id(), GL_COLOR, 0, zero.data());
    if (placed()) {
        const std::array<GLuint, 4> none{};
        glClearNamedFramebufferfv(target_.id(), GL_COLOR, 1, zero.data());
        glClearNamedFramebufferuiv(target_.id(), GL_COLOR, 2, none.data());
    }
    glDepthMask(GL_TRUE);
    const float farthest = 0;
    if (settings.alone) glClearNamedFramebufferfv(target_.id(), GL_DEPTH, 0, &farthest);
    bind_target(target_.id(), frame_size(view));
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glUseProgram((placed() ? placed_program_ : program_).id());
    if (placed()) glUniform1f(shader::nearer_uniform, only_ ? 0.0f : 0.5f);
    glUniformMatrix4fv(shader::clip_from_origin_uniform, 1, GL_FALSE, clip_from_origin.data());
    set_size(view, settings);
    const Eigen::RowVector3f axis = view.cam_from_origin.R.row(2).cast<float>();
    glUniform1f(shader::depth_per_w_uniform, clip_from_origin.row(2).head<3>().dot(axis));
    glVertexArrayVertexBuffer(vertices_.id(), points_binding, store_.buffer(), 0,
                              sizeof(package::PackedPoint));
    glVertexArrayVertexBuffer(vertices_.id(), records_binding, ring_.buffer(), records.offset,
                              sizeof(Record));
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, shader::point_sizes_buffer, ring_.buffer(), sizes.offset,
                      sizes.bytes);
    glBindVertexArray(vertices_.id());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, ring_.buffer());
    glMultiDrawArraysIndirect(GL_POINTS, reinterpret_cast<const void*>(commands.offset),
                              GLsizei(nodes.size()), 0);
    ring_.end();
    return points;
}

}  // namespace vantage
