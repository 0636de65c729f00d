#include "player/render/passes/triangle_readback.h"

#include <algorithm>
#include <array>
#include <utility>

namespace vantage {

void TriangleReadback::release() {
    small_target_ = {};
    small_ = {};
    pixels_.release();
    allocated_ = {};
}

void TriangleReadback::capture(const FrameTargets& targets, const View& view) {
    if (pixels_.pending()) return;
    if (const FrameSize size = Seen::samples(targets.allocated); size != allocated_) {
        small_ = gl::make_texture_2d("seen triangles", GL_R32UI, size.width, size.height);
        small_target_ = gl::make_framebuffer("seen triangles", std::array{small_.id()}, 0);
        pixels_.allocate("seen triangles", std::size_t(size.width) * std::size_t(size.height));
        allocated_ = size;
    }
    if (!pixels_) return;
    const auto [width, height] = Seen::samples(targets.size());
    captured_pixels_ = std::size_t(width) * std::size_t(height);
    glNamedFramebufferReadBuffer(targets.surface().target.id(), GL_COLOR_ATTACHMENT1);
    const FrameSize all = targets.fine_size();
    glBlitNamedFramebuffer(targets.surface().target.id(), small_target_.id(), 0, 0, all.width, all.height, 0,
                           0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, pixels_.id());
    glGetTextureSubImage(small_.id(), 0, 0, 0, 0, width, height, 1, GL_RED_INTEGER, GL_UNSIGNED_INT,
                         GLsizei(4 * captured_pixels_), nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    pixels_.begin();
    captured_ = view;
}

bool TriangleReadback::update(bool wait, std::size_t triangles, std::span<const std::uint32_t> stands_for) {
    const auto all = pixels_.take(wait);
    if (!all) return false;
    const auto arrived = all->first(captured_pixels_);
    view_ = captured_;
    const auto shown = [&](std::uint32_t number) {
        return number > triangles && number - triangles <= stands_for.size()
                   ? stands_for[number - triangles - 1] + 1
                   : number;
    };
    Numbers numbers = unused();
    numbers->resize(arrived.size());
    std::ranges::transform(arrived, numbers->begin(), shown);
    const bool changed = !triangles_ || *numbers != *triangles_;
    if (changed) std::swap(numbers, triangles_);
    if (numbers) others_.push_back(std::move(numbers));
    if (changed) ++version_;
    return changed;
}

/// A buffer that is not referenced elsewhere.
TriangleReadback::Numbers TriangleReadback::unused() {
    const auto free = std::ranges::find(others_, 1, &Numbers::use_count);
    if (free == others_.end()) return std::make_shared<std::vector<std::uint32_t>>();
    Numbers out = std::move(*free);
    others_.erase(free);
    return out;
}

}  // namespace vantage
