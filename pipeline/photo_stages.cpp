#include "pipeline/photo_stages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <tuple>

#include "pipeline/import/photos.h"
#include "pipeline/stages/border.h"
#include "pipeline/stages/clusters.h"
#include "pipeline/stages/coverage.h"
#include "pipeline/stages/masks.h"
#include "pipeline/stages/near_distance.h"
#include "pipeline/stages/pyramid.h"
#include "pipeline/stages/undistort.h"
#include "pipeline/stages/visibility.h"
#include "pipeline/trace.h"
#include "scene/error.h"

namespace vantage {
namespace {

using package::PhotoState;
using package::Stage;
using package::Type;

/// The stages still to be done for a photo.
struct Due {
    std::array<bool, stage_count> stage{};
    bool operator[](Stage s) const { return stage[std::size_t(s)]; }
    bool geometry() const {
        return (*this)[Stage::masks] || (*this)[Stage::coordinates] || (*this)[Stage::coverage];
    }
    bool pixels(const package::PhotoRecord& r) const {
        const bool alpha = r.flags & package::photo_has_alpha;  // as known from the run that made the tiles
        return (*this)[Stage::tiles] || (*this)[Stage::thumbnail] || ((*this)[Stage::masks] && alpha);
    }
};

RgbaImage decode_pixels(const PhotoStages& s, const PhotoInput& photo, std::span<const std::byte> bytes,
                        package::PhotoRecord& r) {
    const Traced traced(s.trace, "decode", photo.name);
    RgbaImage image = decode_photo(photo.file, bytes, photo.decoded);
    const int longest = int(std::max(r.width, r.height));
    if (std::max(image.width, image.height) > longest)
        image = reduced(image, thumbnail_size(image.width, image.height, longest));
    if (!s.key.undistortion || !photo.camera.lens.distorts()) return image;
    r.flags |= package::photo_undistorted;
    return undistort(image, photo.camera, s.key.settings.resampling);
}

/// Validity of a level's texels, 0 or 1; empty where the photo is opaque.
std::vector<std::uint8_t> validity(const RgbaImage& level) {
    std::vector<std::uint8_t> valid(level.rgba.size() / 4);
    for (std::size_t p = 0; p < valid.size(); ++p) valid[p] = level.rgba[4 * p + 3] == 255;
    return valid;
}

void write_tiles(PackageWriter& writer, Type type, std::uint32_t photo, std::uint32_t level,
                 std::span<const std::byte> texels, const Level& size) {
    writer.write_blocks(type, photo, level, [&](std::size_t number, std::span<std::byte> tile) {
        cut_tile(texels, size, number, tile);
    });
}

/// Thumbnail and tile pyramid. Returns the photo's validity at `mask_level`, empty where it is opaque.
std::vector<std::uint8_t> write_pixels(const PhotoStages& s, std::uint32_t i, const Due& due, RgbaImage level,
                                       package::PhotoRecord& r) {
    const Traced traced(s.trace, "tiles", r.name);
    const bool opaque = is_opaque(level);
    if (!opaque) r.flags |= package::photo_has_alpha;
    std::vector<std::uint8_t> valid;
    bool thumbnail_due = due[Stage::thumbnail];
    const std::uint32_t last = std::max(r.levels, std::uint32_t(mask_level) + 1);
    for (std::uint32_t l = 0; l < last; ++l) {
        if (l == std::uint32_t(mask_level) && !opaque) valid = validity(level);
        if (l < r.levels && due[Stage::tiles])
            write_tiles(s.writer, Type::tiles, i, l, bytes_of(level.rgba), {level.width, level.height});
        RgbaImage next = halve(level);
        // The coarsest level that still has the thumbnail's detail is the cheapest to reduce.
        const int wanted = int(std::max(r.thumbnail_width, r.thumbnail_height));
        if (thumbnail_due && (std::max(next.width, next.height) < wanted || l + 1 == last)) {
            const RgbaImage small = reduced(level, {int(r.thumbnail_width), int(r.thumbnail_height)});
            s.writer.write(Type::thumbnail, i, std::as_bytes(std::span(small.rgba)));
            thumbnail_due = false;
        }
        level = std::move(next);
    }
    return valid;
}

/// To the nearest border, as far as the mask goes: `reach` pixels.
std::vector<float> distances(const PhotoStages& s, const std::vector<std::uint8_t>& borders, int reach,
                             const PhotoGeometry& g) {
    if (s.key.distance == DistanceMethod::exact)
        return reach <= farthest_near ? near_distance(borders, g.width, g.height, reach)
                                      : exact_distance(borders, g.width, g.height);
    const auto flood = [&] {
        return flood_distance(s.buffers.jump_flood, borders, g.width, g.height, s.key.distance);
    };
    return s.gl.submit(flood).get();
}

void write_masks(const PhotoStages& s, std::uint32_t i, PhotoGeometry g, std::vector<std::uint8_t> valid,
                 const Intrinsics& k, int levels) {
    const Traced traced(s.trace, "masks", s.scene.photos[i].name);
    const DepthMap depth{g.width, g.height, g.z, std::move(valid)};
    const double scale = 1.0 / (1 << mask_level);
    const double full = s.key.settings.border_width * k.width / 3072 * scale;
    const auto borders = find_borders(depth, float(s.key.settings.border_threshold));
    const auto border = border_mask(distances(s, borders, int(full) + 3, g), g.width, g.height, float(full));
    auto combined = combine_masks(g, border, std::sqrt(k.fx * k.fy), s.key.reference_density);
    MaskLevel masks{g.width, g.height, std::move(combined), std::move(g.z)};
    for (int l = mask_level;; ++l) {
        const Level size{masks.width, masks.height};
        write_tiles(s.writer, Type::masks, i, std::uint32_t(l), bytes_of(masks.masks), size);
        write_tiles(s.writer, Type::depth, i, std::uint32_t(l), bytes_of(masks.z), size);
        if (l + 1 == mask_levels_end(levels)) return;
        masks = halve(masks);
    }
}

void write_coverage(const PhotoStages& s, std::uint32_t i, const FrameTriangles& triangles,
                    const PhotoGeometry& g, const Intrinsics& k, const Pose& pose) {
    const Traced traced(s.trace, "coverage", s.scene.photos[i].name);
    const Coverage coverage =
        measure_coverage(s.model.clusters, s.model.indices, triangles.places, g, k, pose);
    s.writer.write(Type::coverage, i, bytes_of(coverage.clusters));
    s.writer.write(Type::visible, i, bytes_of(coverage.visible));
}

void record_findings(const PhotoGeometry& g, const Intrinsics& k, const Pose& pose, package::PhotoRecord& r) {
    const SeenHull hull = seen_hull(g.coordinates, k, pose);
    Eigen::Map<Eigen::Vector3d>(r.corrected_direction) = hull.direction;
    r.hull_area = hull.area;
    const auto seen =
        std::count_if(g.coordinates.begin(), g.coordinates.end(), [](const auto& uv) { return uv.x() >= 0; });
    r.visible_vertices = g.coordinates.empty() ? 0 : double(seen) / double(g.coordinates.size());
    float nearest = std::numeric_limits<float>::infinity(), farthest = 0;
    for (const float z : g.z) {
        nearest = std::min(nearest, z);
        farthest = std::isinf(z) ? farthest : std::max(farthest, z);
    }
    if (std::isinf(nearest)) return;
    r.z_min = double(nearest);
    r.z_max = double(farthest);
    std::vector<float> some;  // a median needs no more
    for (std::size_t i = 0; i < g.z.size(); i += g.z.size() < 65536 ? 1 : 7)
        if (std::isfinite(g.z[i])) some.push_back(g.z[i]);
    if (some.empty()) some.push_back(nearest);
    const auto middle = some.begin() + std::ptrdiff_t(some.size() / 2);
    std::nth_element(some.begin(), middle, some.end());
    r.seen_distance = double(*middle);
}

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
    const Traced traced(s.formers.empty() ? nullptr : s.trace, "keep", r.name);
    for (const auto& former : s.formers) {
        const auto j = former->photo(r.name);
        if (!j || !former->hand_over(stage, *j, i, int(r.levels), state.stages[std::size_t(stage)], s.writer))
            continue;
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
    for (const Stage stage : {Stage::thumbnail, Stage::masks, Stage::coordinates, Stage::coverage})
        state.stages[std::size_t(stage)] = {};
    s.writer.leave_out(i);
    r.flags = package::photo_left_out;
    r.levels = 0;
    Eigen::Map<Eigen::Vector3d>(r.corrected_direction) = pose.direction();
}

/// The bytes of a photo's file, read when somebody asks for them.
class PhotoFile {
  public:
    PhotoFile(IdentityCache& identities, const std::filesystem::path& file)
        : identities_(identities), file_(file) {
        if (const auto known = identities.known(file))
            identity_ = *known;
        else
            read();
    }
    const FileIdentity& identity() const { return identity_; }
    /// Throws Error(input) where the file is gone, or another than it was.
    std::span<const std::byte> bytes() {
        const FileIdentity before = identity_;
        if (bytes_.empty()) read();
        if (!(identity_ == before))
            throw Error(Exit::input, file_.string() + ": has changed while it was prepared, run again");
        return bytes_;
    }
    void release() { bytes_ = {}; }

  private:
    void read() { std::tie(bytes_, identity_) = identities_.read(file_); }

    IdentityCache& identities_;
    const std::filesystem::path& file_;
    std::vector<std::byte> bytes_;
    FileIdentity identity_;
};

/// What there is to know of a photo while its stages run.
struct PhotoRun {
    const PhotoStages& s;
    std::uint32_t i;
    const PhotoInput& photo;
    Intrinsics k;
    Pose pose;  ///< relative to the origin
};

/// Throws Error(input) where the photo is no picture, or not this camera's.
std::vector<std::uint8_t> make_pixels(const PhotoRun& run, const Due& due, std::optional<PhotoFile>& file,
                                      package::PhotoRecord& r) {
    RgbaImage image = decode_pixels(run.s, run.photo, file->bytes(), r);
    file->release();
    return write_pixels(run.s, run.i, due, std::move(image), r);
}

void make_from_geometry(const PhotoRun& run, const Due& due, const FrameTriangles& triangles,
                        PhotoGeometry geometry, std::vector<std::uint8_t> valid, package::PhotoRecord& r) {
    const PhotoStages& s = run.s;
    if (due[Stage::coordinates]) {
        const Traced traced(s.trace, "coordinates", run.photo.name);
        settle_visibility(s.rays.get(), s.model.positions, run.k, run.pose, geometry.coordinates);
        record_findings(geometry, run.k, run.pose, r);
        if (r.levels) s.writer.write(Type::coordinates, run.i, bytes_of(geometry.coordinates));
    }
    if (due[Stage::coverage]) write_coverage(s, run.i, triangles, geometry, run.k, run.pose);
    if (due[Stage::masks]) write_masks(s, run.i, std::move(geometry), std::move(valid), run.k, int(r.levels));
}

/// Makes the stages that are due: the model is rendered while the photo is decoded and cut.
void make_stages(const PhotoRun& run, const Due& due, std::optional<PhotoFile>& file,
                 package::PhotoRecord& r) {
    const PhotoStages& s = run.s;
    FrameTriangles triangles;
    std::future<PhotoGeometry> pending;
    const Eigen::Vector2d range =
        due.geometry() ? depth_range(s.model.positions, run.pose) : Eigen::Vector2d(0, 0);
    if (due.geometry()) {
        const Traced traced(s.trace, "cull", run.photo.name);
        triangles = triangles_in_frame(s.model.clusters, s.model.indices, run.k, run.pose);
        pending = s.gl.submit([&] {
            const Traced traced(s.trace, "render", run.photo.name);
            return render_geometry(s.buffers, triangles.indices, run.k, run.pose, range);
        });
    }
    std::vector<std::uint8_t> valid;
    try {
        if (due.pixels(r)) valid = make_pixels(run, due, file, r);
    } catch (...) {
        if (pending.valid()) pending.wait();  // it refers to this frame
        throw;
    }
    if (!due.geometry()) return;
    PhotoGeometry geometry = [&] {
        const Traced traced(s.trace, "wait for render", run.photo.name);
        return pending.get();
    }();
    make_from_geometry(run, due, triangles, std::move(geometry), std::move(valid), r);
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
        else if (!hand_over(run.s, stage, run.i, r, state))
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
        state.stages[std::size_t(stage)].content = content_of(stage, run.i, int(r.levels), run.s.writer);
    return made;
}

}  // namespace

std::vector<Stage> stages_of(const package::PhotoRecord& r) {
    if (r.flags & package::photo_held_out) return {Stage::coordinates};
    return {Stage::thumbnail, Stage::tiles, Stage::masks, Stage::coordinates, Stage::coverage};
}

std::vector<Stage> run_photo(const PhotoStages& s, std::uint32_t i, package::PhotoRecord& r,
                             PhotoState& state) {
    const PhotoInput& photo = s.scene.photos[i];
    const PhotoRun run{s, i, photo, photo.camera.intrinsics,
                       photo.camera.cam_from_world.relative_to(s.model.origin)};
    std::optional<PhotoFile> file;
    if (r.levels) {
        const Traced traced(s.trace, "read", photo.name);
        file.emplace(s.identities, photo.file);
    }
    const FileIdentity id = file ? file->identity() : FileIdentity{};
    r.source_bytes = id.bytes;
    r.source_checksum = id.checksum;
    state = stage_keys(s.key, photo, s.model.origin, id);
    const package::PhotoRecord planned = r;
    std::vector<Stage> made;
    if (!known_unreadable(s, r.name, state)) made = make_missing(run, file, r, state);
    if (state.left_out[0]) {
        if (s.strict) throw Error(Exit::input, photo.file.string() + ": " + state.left_out);
        r = planned;
        leave_out(s, i, run.pose, r, state);
    }
    seal(state, r);
    s.writer.note(Type::photos, i, bytes_of_one(r));
    s.writer.note(Type::states, i, bytes_of_one(state));
    return made;
}

}  // namespace vantage
