#include "player/render/planning/frame_memory.h"

#include <algorithm>

#include "player/render/passes/triangle_readback.h"

namespace vantage {
namespace {

/// Memory, in bytes, for the tiles that a frame of this size shows and for some shown earlier.
std::uint64_t tiles_for(FrameSize frame) {
    constexpr double MiB = 1 << 20;
    return std::uint64_t(
        std::clamp(256 * MiB * frame.width * frame.height / (1280.0 * 720), 256 * MiB, 1024 * MiB));
}

/// Memory for frames of this capacity, excluding tiles, in addition to the memory already held.
std::uint64_t bytes_of(const FrameResources& r, const FrameNeeds& n) {
    const auto [width, height] = n.capacity;
    return FrameTargets::bytes(n.capacity, n.eyes, n.surfaces, n.fine) +
           (r.scene.image_sets.size() > 1 ? n.eyes * PictureSamples::bytes(width, height) : 0) +
           (n.veiled ? n.eyes * PictureSamples::veil_bytes(width, height) : 0) +
           (r.filling ? HoleFilling::bytes(width, height) : 0) +
           (r.points ? PointPass::bytes(width, height, n.points_placed) + r.points->growth() : 0) +
           (r.transparent ? r.transparent->bytes(width, height, n.transparency) : 0) +
           n.eyes * TriangleReadback::bytes(n.capacity);
}

}  // namespace

FrameNeeds needs_of(const FrameResources& r, FrameSize frame, std::span<const ImageSetFrame> image_sets,
                    std::size_t eyes, int fine) {
    const RenderSettings& settings = image_sets.front().settings;
    FrameNeeds n;
    n.capacity = enclosing(frame, settings.capacity);
    n.eyes = eyes;
    n.fine = fine;
    // The first picture, which may be coarse, does not wait until memory for later frames is allocated.
    n.allocated = settings.loading == Loading::beginning ? frame : n.capacity;
    n.surfaces = eye_surfaces(r, settings, eyes) == EyeSurfaces::in_turn ? 1 : eyes;
    n.coordinates = std::ranges::any_of(
        image_sets, [&](const ImageSetFrame& b) { return !r.photos.per_fragment(b.settings); });
    n.points_placed = r.points && (photos_on_points(settings, r.parts) || settings.points.pick);
    n.veiled = r.transparent && settings.transparency != Transparency::off && r.parts.background;
    n.transparency = settings.transparency;
    return n;
}

bool draws_samples_at_once(const FrameResources& r, const RenderSettings& settings, FrameSize frame, int side,
                           const MemoryBudget& budget) {
    constexpr double most = 1 << 22;  // samples
    GLint longest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &longest);
    const bool transparent = r.transparent && settings.transparency != Transparency::off;
    const bool in_pixels = shows_points(settings, r.parts) || transparent || settings.light.wireframe ||
                           r.fields.shows(settings) || !r.photos.by_triangle(settings);
    // Targets may use a quarter of the budget; the rest is for tiles.
    const bool fits = budget.graphics == 0 || FrameTargets::bytes(frame, 1, 1, side) <= budget.graphics / 4;
    return side > 1 && !in_pixels && r.scene.image_sets.size() == 1 && fits &&
           std::max(frame.width, frame.height) <= longest / side &&
           double(frame.width) * frame.height * side * side <= most;
}

bool has(const FrameResources& r, const FrameNeeds& n) {
    return r.targets.allocated == n.allocated && r.targets.fine == n.fine &&
           r.targets.samples.size() == n.eyes && r.targets.surfaces.size() >= n.surfaces &&
           (r.store.has_coordinates() || !n.coordinates) &&
           (!r.points || r.points->placed() || !n.points_placed) &&
           (!r.transparent || r.transparent->mode() == n.transparency);
}

std::uint64_t make_targets(FrameResources& r, const FrameNeeds& n, const MemoryBudget& budget) {
    const std::uint64_t others = gl::memory_held() - budget.elsewhere - r.store.bytes() + bytes_of(r, n);
    const std::uint64_t limit = budget.graphics ? budget.graphics : others + tiles_for(n.capacity);
    r.store.fit(limit > others ? limit - others : 0, n.coordinates);
    r.targets = make_frame_targets(n.allocated, n.eyes, n.surfaces, n.fine);
    if (r.filling) r.filling->fit(n.allocated.width, n.allocated.height);
    if (r.points) r.points->fit(r.targets, n.points_placed);
    if (r.transparent) r.transparent->fit(r.targets, n.transparency);
    return std::max(limit, others + r.store.residency().layout().bytes());
}

}  // namespace vantage
