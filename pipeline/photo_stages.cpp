#include "pipeline/photo_stages.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "pipeline/geometry_stages.h"
#include "pipeline/import/photos.h"
#include "pipeline/photo_file.h"
#include "pipeline/photo_run.h"
#include "pipeline/pixel_stages.h"
#include "pipeline/trace.h"
#include "scene/error.h"

namespace vantage {
namespace {

using package::PhotoState;
using package::Stage;
using package::Type;

/// What a stage finds out about a photo stands in its record: from the record of the run that made it.
void adopt(Stage stage, const package::PhotoRecord& from, package::PhotoRecord& to) {
    if (stage == Stage::tiles) {
        to.flags |= from.flags & (package::photo_undistorted | package::photo_has_alpha);
    } else if (stage == Stage::coordinates) {
        std::copy_n(from.corrected_direction, 3, to.corrected_direction);
        to.hull_area = from.hull_area;
        to.seen_distance = from.seen_distance;
        to.z_min = from.z_min;
        to.z_max = from.z_max;
        to.visible_vertices = from.visible_vertices;
    }
}

bool hand_over(const PhotoStages& s, Stage stage, std::uint32_t i, package::PhotoRecord& r,
               PhotoState& state) {
    const Traced traced(s.formers.empty() ? nullptr : s.geometry.trace, "keep", r.name);
    for (const auto& former : s.formers) {
        const auto j = former->photo(r.name);
        if (!j || !former->hand_over(stage, *j, i, int(r.levels), state, s.geometry.writer)) continue;
        adopt(stage, former->record(*j), r);
        return true;
    }
    return false;
}

/// An earlier run could not read this very photo either: trying again would not help.
bool known_unreadable(const PhotoStages& s, const std::string& name, PhotoState& state) {
    for (const auto& former : s.formers) {
        const auto j = former->photo(name);
        if (!j) continue;
        const PhotoState& had = former->state(*j);
        const std::size_t tiles = std::size_t(Stage::tiles);
        if (!had.left_out[0] || had.stages[tiles].key != state.stages[tiles].key) continue;
        std::memcpy(state.left_out, had.left_out, sizeof state.left_out);
        return true;
    }
    return false;
}

/// The package says why, not where.
void note_reason(PhotoState& state, const PhotoInput& photo, const Error& error) {
    std::string reason = reason_of(error, photo.file);
    reason.resize(std::min(reason.size(), sizeof state.left_out - 1));
    std::memcpy(state.left_out, reason.c_str(), reason.size() + 1);
}

/// Its camera stays; that these inputs were tried is kept, too.
void leave_out(const PhotoStages& s, std::uint32_t i, const Pose& pose, package::PhotoRecord& r,
               PhotoState& state) {
    for (const Stage stage :
         {Stage::thumbnail, Stage::masks, Stage::coordinates, Stage::coverage, Stage::samples})
        state.stages[std::size_t(stage)] = {};
    s.geometry.writer.leave_out(i);
    r.flags = package::photo_left_out;
    r.levels = 0;
    Eigen::Map<Eigen::Vector3d>(r.corrected_direction) = pose.direction();
}

/// Makes the stages that come from the model, at once on a spare core, else when they are waited for; a
/// graphics card begins at once.
std::future<void> make_geometry(const PhotoRun& run, const Due& due, std::future<CoarsePixels> pixels,
                                package::PhotoRecord& r) {
    const auto view = std::make_shared<const PhotoView>(view_of(run.s.geometry, run.at));
    auto pending = run.s.geometry.renderer.render(view, run.at.k, run.s.geometry.trace, run.photo.name);
    return std::async(
        run.spare_core ? std::launch::async : std::launch::deferred,
        [&run, &due, &r, view, pending = std::move(pending), pixels = std::move(pixels)]() mutable {
            PhotoGeometry geometry = [&] {
                const Traced traced(run.s.geometry.trace, "wait for render", run.photo.name);
                return pending.get();
            }();
            make_from_geometry(run.s.geometry, run.at, due, *view, std::move(geometry), std::move(pixels), r);
        });
}

/// Makes the stages that are due.
void make_stages(const PhotoRun& run, const Due& due, std::optional<PhotoFile>& file,
                 package::PhotoRecord& r) {
    std::future<void> geometry;
    std::promise<CoarsePixels> pixels;  // goes first if it throws, and so ends the wait for it
    if (due.geometry()) geometry = make_geometry(run, due, pixels.get_future(), r);
    if (due.pixels(r))
        make_pixels(run, due, *file, r, pixels);
    else
        pixels.set_value({});
    if (geometry.valid()) geometry.get();
}

/// Keeps what can be kept and makes the rest; returns what it made. A photo that cannot be decoded is named
/// in its state.
std::vector<Stage> make_missing(const PhotoRun& run, std::optional<PhotoFile>& file, package::PhotoRecord& r,
                                PhotoState& state) {
    const auto stages = stages_of(r);
    std::vector<Stage> made;
    Due due;
    for (std::size_t n = 0; n < stage_count; ++n) {
        const Stage stage{std::uint32_t(n)};
        if (std::ranges::count(stages, stage) == 0)
            state.stages[n] = {};
        else if (!hand_over(run.s, stage, run.at.i, r, state))
            made.push_back(stage), due.stage[n] = true;
    }
    // A file that cannot be read now is the disk's fault, one that cannot be decoded its own.
    if (file && due.pixels(r)) file->bytes();
    try {
        make_stages(run, due, file, r);
    } catch (const Error& e) {
        if (e.code() != Exit::input) throw;
        note_reason(state, run.photo, e);
        return {};
    }
    for (const Stage stage : made)
        state.stages[std::size_t(stage)].content =
            content_of(stage, run.at.i, int(r.levels), run.s.geometry.writer);
    return made;
}

}  // namespace

std::vector<Stage> stages_of(const package::PhotoRecord& r) {
    if (r.flags & package::photo_held_out) return {Stage::coordinates};
    return {Stage::thumbnail,   Stage::tiles,    Stage::masks,
            Stage::coordinates, Stage::coverage, Stage::samples};
}

std::vector<Stage> run_photo(const PhotoStages& s, std::uint32_t i, bool spare_core, package::PhotoRecord& r,
                             PhotoState& state) {
    const PhotoInput& photo = s.scene.photos[i];
    const PhotoRun run{s, photo, {i, photo.name, photo.camera.intrinsics, s.poses[i]}, spare_core};
    std::optional<PhotoFile> file;
    if (r.levels) {
        const Traced traced(s.geometry.trace, "read", photo.name);
        file.emplace(s.identities, photo.file);
    }
    const FileIdentity id = file ? file->identity() : FileIdentity{};
    r.source_bytes = id.bytes;
    r.source_checksum = id.checksum;
    state = stage_keys(s.key, photo, s.poses[i], id, stencil_identity(photo, s.identities));
    const package::PhotoRecord planned = r;
    std::vector<Stage> made;
    if (!known_unreadable(s, r.name, state)) made = make_missing(run, file, r, state);
    if (state.left_out[0]) {
        if (s.strict) throw Error(Exit::input, photo.file.string() + ": " + state.left_out);
        r = planned;
        leave_out(s, i, run.at.pose, r, state);
    }
    seal(state, r);
    s.geometry.writer.note(Type::photos, i, bytes_of_one(r));
    s.geometry.writer.note(Type::states, i, bytes_of_one(state));
    return made;
}

}  // namespace vantage
