#include "player/render/passes/transparent_pass.h"

#include <algorithm>
#include <array>

#include "shaders/contract.h"

namespace vantage {
namespace {

constexpr std::uint64_t fragment_bytes = sizeof(shader::TransparentFragment);
constexpr std::size_t counters = 2;  ///< of stored and of unsorted fragments; they precede the heads

std::uint64_t pixels(int width, int height) { return std::uint64_t(width) * std::uint64_t(height); }
std::uint64_t head_bytes(int width, int height) { return 4 * (counters + pixels(width, height)); }

}  // namespace

void TransparentPass::release() {
    target_ = {};
    sums_ = {}, transmitted_ = {};
    heads_ = {}, fragments_ = {};
    counts_.release();
    mode_ = Transparency::off;
    capacity_ = 0;
    count_ = {};
}

std::uint32_t TransparentPass::capacity_for(int width, int height) const {
    GLint64 block = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &block);
    const std::uint64_t most = std::min({list_bytes_, max_list_bytes, std::uint64_t(block)});
    return std::uint32_t(std::min(layers_per_pixel * pixels(width, height), most / fragment_bytes));
}

std::uint64_t TransparentPass::bytes(int width, int height, Transparency mode) const {
    if (mode == Transparency::off) return 0;
    const std::uint64_t targets = pixels(width, height) * (16 + 4);
    if (mode == Transparency::approximate) return targets;
    return targets + head_bytes(width, height) + fragment_bytes * capacity_for(width, height) + 4 * counters;
}

void TransparentPass::fit(const FrameTargets& targets, Transparency mode) {
    release();
    mode_ = mode;
    allocated_ = targets.allocated;
    const auto [width, height] = allocated_;
    if (mode == Transparency::off) return;
    sums_ = gl::make_texture_2d("transparent sums", GL_RGBA32F, width, height);
    transmitted_ = gl::make_texture_2d("transmitted light", GL_R32F, width, height);
    target_ = gl::make_framebuffer("transparent surfaces", std::array{sums_.id(), transmitted_.id()},
                                   targets.surface().depth.id());
    if (mode == Transparency::approximate) return;
    capacity_ = capacity_for(width, height);
    heads_ = gl::make_buffer("fragment heads", head_bytes(width, height));
    fragments_ = gl::make_buffer("fragments", fragment_bytes * capacity_);
    counts_.allocate("fragment counts", counters);
}

void TransparentPass::collect(FrameSize frame, const std::function<void()>& draw) {
    const std::array<float, 4> nothing{}, everything{1, 1, 1, 1};
    glClearNamedFramebufferfv(target_.id(), GL_COLOR, 0, nothing.data());
    glClearNamedFramebufferfv(target_.id(), GL_COLOR, 1, everything.data());
    if (heads_) glClearNamedBufferData(heads_.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    bind_target(target_.id(), frame);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_GEQUAL);
    glEnable(GL_BLEND);
    glBlendFunci(0, GL_ONE, GL_ONE);
    glBlendFunci(1, GL_ZERO, GL_ONE_MINUS_SRC_COLOR);
    bind();
    draw();
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void TransparentPass::bind() const {
    if (heads_) {
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, shader::fragment_heads_buffer, heads_.id());
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, shader::fragments_buffer, fragments_.id());
    }
    glBindTextureUnit(shader::transparent_sums_unit, sums_.id());
    glBindTextureUnit(shader::transmitted_unit, transmitted_.id());
}

void TransparentPass::capture() {
    if (!counts_ || counts_.pending()) return;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glCopyNamedBufferSubData(heads_.id(), counts_.id(), 0, 0, 4 * GLsizeiptr(counters));
    glMemoryBarrier(GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT);
    counts_.begin();
}

bool TransparentPass::update(bool wait) {
    const auto counted = counts_.take(wait);
    if (!counted) return false;
    const std::size_t stored = (*counted)[0], deep = (*counted)[1];
    count_ = {stored, deep + (stored > capacity_ ? stored - capacity_ : 0)};
    return true;
}

}  // namespace vantage
