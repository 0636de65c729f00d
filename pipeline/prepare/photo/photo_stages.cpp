#include "pipeline/prepare/photo/photo_stages.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "base/text/error.h"
#include "base/values/bytes_of.h"
#include "pipeline/input/photo_file.h"
#include "pipeline/photos/photos.h"
#include "pipeline/prepare/photo/pixel_stages.h"

namespace vantage {
namespace {

using package::PhotoState;
using package::Stage;
using package::Type;

bool reuse(const PhotoContext& c, Stage stage, std::uint32_t i, package::PhotoRecord& r, PhotoState& state) {
    const Traced traced(c.earlier.empty() ? nullptr : c.trace, "reuse", r.name);
    for (const auto& package : c.earlier) {
        const auto j = package->photo(r.name);
        if (!j || !package->reuse(stage, *j, i, int(r.levels), state, c.writer)) continue;
        if (const auto adopt = stage_row(stage).adopt) adopt(package->record(*j), r);
        return true;
    }
    return false;
}

/// Whether an earlier run failed to decode the same file. If so, copies the reason, and the file is not
/// decoded again.
bool known_unreadable(const PhotoContext& c, const std::string& name, PhotoState& state) {
    for (const auto& package : c.earlier) {
        const auto j = package->photo(name);
        if (!j) continue;
        const PhotoState& had = package->state(*j);
        const std::size_t tiles = std::size_t(Stage::tiles);
        if (!had.skipped[0] || had.stages[tiles].key != state.stages[tiles].key) continue;
        std::memcpy(state.skipped, had.skipped, sizeof state.skipped);
        return true;
    }
    return false;
}

/// Records the reason without the photo's path, which differs from machine to machine.
void record_reason(PhotoState& state, const PhotoInput& photo, const Error& error) {
    std::string reason = reason_of(error, photo.file);
    reason.resize(std::min(reason.size(), sizeof state.skipped - 1));
    std::memcpy(state.skipped, reason.c_str(), reason.size() + 1);
}

/// The photo's camera and the tiles' key are kept, so that the next run recognizes the file.
void skip(const PhotoContext& c, std::uint32_t i, const Pose& pose, package::PhotoRecord& r,
          PhotoState& state) {
    for (const StageRow& row : stage_table())
        if (row.stage != Stage::tiles) state.stages[std::size_t(row.stage)] = {};
    c.writer.skip(i);
    r.flags = package::photo_skipped;
    r.levels = 0;
    Eigen::Map<Eigen::Vector3d>(r.corrected_direction) = pose.direction();
}

/// Starts the stages that use the model: immediately on a spare core, otherwise when their result is awaited.
/// A GPU starts rendering immediately.
std::future<void> start_geometry(const PhotoJob& job, const StageSet& missing,
                                 std::future<CoarsePixels> pixels, package::PhotoRecord& r) {
    const GeometryContext& geometry = job.context.geometry;
    const auto view = std::make_shared<const PhotoView>(view_of(geometry, job.at));
    auto pending = geometry.renderer.render(view, job.at.intrinsics, job.context.trace, job.photo.name);
    return std::async(job.spare_core ? std::launch::async : std::launch::deferred,
                      [&job, &geometry, &missing, &r, view, pending = std::move(pending),
                       pixels = std::move(pixels)]() mutable {
                          PhotoGeometry rendered = [&] {
                              const Traced traced(job.context.trace, "wait for render", job.photo.name);
                              return pending.get();
                          }();
                          StageInput in(geometry, job.at, *view, std::move(rendered), std::move(pixels), r);
                          make_on_model(in, missing);
                      });
}

void make_stages(const PhotoJob& job, const StageSet& missing, std::optional<PhotoFile>& file,
                 package::PhotoRecord& r) {
    std::future<void> geometry;
    std::promise<CoarsePixels> pixels;  // if decoding throws, this is destroyed first, which ends the wait
    if (missing.needs_model()) geometry = start_geometry(job, missing, pixels.get_future(), r);
    if (missing.needs_pixels(r.flags & package::photo_has_alpha))
        make_pixels(job, missing, *file, r, pixels);
    else
        pixels.set_value({});
    if (geometry.valid()) geometry.get();
}

/// Reuses chunks where possible and runs the other stages. Returns the stages that ran. If the photo cannot
/// be decoded, the reason is recorded in its state.
std::vector<Stage> make_missing(const PhotoJob& job, std::optional<PhotoFile>& file, package::PhotoRecord& r,
                                PhotoState& state) {
    const auto stages = stages_of(r);
    std::vector<Stage> made;
    StageSet missing;
    for (const StageRow& row : stage_table()) {
        if (std::ranges::count(stages, row.stage) == 0) {
            state.stages[std::size_t(row.stage)] = {};
        } else if (!reuse(job.context, row.stage, job.at.index, r, state)) {
            made.push_back(row.stage);
            missing.add(row.stage);
        }
    }
    // A file that can no longer be read indicates a disk error and ends the run; a file that cannot be
    // decoded is skipped.
    if (file && missing.needs_pixels(r.flags & package::photo_has_alpha)) file->bytes();
    try {
        make_stages(job, missing, file, r);
    } catch (const Error& e) {
        if (e.code() != Exit::input) throw;
        record_reason(state, job.photo, e);
        return {};
    }
    for (const Stage stage : made)
        state.stages[std::size_t(stage)].content =
            content_of(stage, job.at.index, int(r.levels), job.context.writer);
    return made;
}

}  // namespace

std::vector<Stage> run_photo(const PhotoContext& c, std::uint32_t i, bool spare_core, package::PhotoRecord& r,
                             PhotoState& state) {
    const PhotoInput& photo = c.scene.photos[i];
    const Camera& camera = photo.camera;
    PhotoJob job{c, photo, {i, photo.name, camera.intrinsics, c.poses[i], {}}, spare_core};
    if (c.key.undistortion && camera.lens.distorts()) {
        const Traced traced(c.trace, "lens", photo.name);
        job.at.lens = lens_table(camera.intrinsics, camera.lens);
    }
    std::optional<PhotoFile> file;
    {
        const Traced traced(c.trace, "read", photo.name);
        file.emplace(c.identities, photo.file);
    }
    r.source_bytes = file->identity().bytes;
    r.source_checksum = file->identity().checksum;
    if (!r.levels) file.reset();  // a held-out photo is only identified, so that no program overwrites it
    state = stage_keys(c.key, photo, c.poses[i], file ? file->identity() : FileIdentity{},
                       mask_identity(photo, c.identities));
    const package::PhotoRecord planned = r;
    std::vector<Stage> made;
    if (!known_unreadable(c, r.name, state)) made = make_missing(job, file, r, state);
    if (state.skipped[0]) {
        if (c.strict) throw Error(Exit::input, photo.file.string() + ": " + state.skipped);
        r = planned;
        skip(c, i, job.at.pose, r, state);
    }
    for (const StampedFile& read : photo.read) expect_unchanged(read);
    seal(state, r);
    c.writer.note(Type::photos, i, bytes_of_one(r));
    c.writer.note(Type::states, i, bytes_of_one(state));
    return made;
}

}  // namespace vantage
