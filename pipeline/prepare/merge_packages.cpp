#include "pipeline/prepare/merge_packages.h"

#include <algorithm>
#include <string>

#include "base/files/part_file.h"
#include "base/text/error.h"
#include "base/values/bytes_of.h"
#include "pipeline/output/chunk_plan.h"
#include "pipeline/output/earlier_package.h"
#include "pipeline/output/meta.h"
#include "pipeline/output/photo_records.h"
#include "pipeline/prepare/finish.h"
#include "pipeline/prepare/photo/moved_photo.h"
#include "pipeline/prepare/pose_refinement_reuse.h"
#include "scene/package/chunk_table.h"
#include "scene/package/contents/image_sets.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using package::DirectoryEntry;
using package::PhotoRecord;
using package::PhotoState;
using package::Type;

PackageReader open_share(const fs::path& file) {
    PackageReader share(file, PackageReader::Expect::part);
    const package::Header& h = share.header();
    if (h.shares == 0 || h.directory_checksum == 0)
        throw Error(Exit::input,
                    file.string() + ": not a finished shard, expected a file written with --shard");
    return share;
}

/// All shards, sorted by number.
std::vector<PackageReader> open_shares(const std::vector<fs::path>& files) {
    if (files.empty()) throw Error(Exit::usage, "no shards to merge");
    std::vector<PackageReader> shares;
    for (const fs::path& file : files) shares.push_back(open_share(file));
    const auto number = [](const PackageReader& r) { return r.header().share; };
    std::ranges::sort(shares, {}, number);
    const std::uint32_t expected = shares.front().header().shares;
    for (std::uint32_t n = 1; n <= expected; ++n) {
        const auto count = std::ranges::count(shares, n, number);
        if (count != 1)
            throw Error(Exit::input, "shard " + std::to_string(n) + " of " + std::to_string(expected) +
                                         (count ? " is given more than once" : " is missing"));
    }
    return shares;
}

/// Scene-wide chunks must be identical, except for the per-photo records in PHOT and STAT.
void expect_same_scene(const PackageReader& a, const PackageReader& b) {
    for (const DirectoryEntry& e : a.directory()) {
        if (e.photo != package::scene_wide || e.type == std::uint32_t(Type::photos) ||
            e.type == std::uint32_t(Type::states))
            continue;
        const DirectoryEntry* other = b.find(Type(e.type));
        if (!other || other->checksum != e.checksum || other->length != e.length ||
            b.header().shares != a.header().shares)
            throw Error(Exit::input, b.path().string() +
                                         ": was not made from the same inputs and settings as " +
                                         a.path().string() + " (" + describe(e, a) + " differs)");
    }
}

/// Takes a photo's record, state and chunks from the parts that contain them.
void merge_photo(std::uint32_t i, const EarlierPackages& parts, PackageWriter& writer, PhotoRecord& record,
                 PhotoState& state) {
    const auto holder =
        std::ranges::find_if(parts, [&](const auto& part) { return bool(part->photo(record.name)); });
    if (holder == parts.end())
        throw Error(Exit::damaged, std::string(record.name) + ": not found in any of the parts");
    const std::uint32_t at = *(*holder)->photo(record.name);
    record = (*holder)->record(at);
    state = (*holder)->state(at);
    if (state.skipped[0]) {
        writer.skip(i);
    } else {
        for (const package::Stage stage : stages_of(record)) {
            const bool taken = std::ranges::any_of(parts, [&](const auto& part) {
                const auto j = part->photo(record.name);
                return j && part->reuse(stage, *j, i, int(record.levels), state, writer);
            });
            if (!taken)
                throw Error(Exit::damaged,
                            std::string(record.name) + ": damaged data from stage " + stage_row(stage).name);
        }
    }
    writer.note(Type::photos, i, bytes_of_one(record));
    writer.note(Type::states, i, bytes_of_one(state));
}

/// The package's model, without normals.
PackedModel model_of(const PackageReader& package) {
    const auto copy = [&]<class T>(std::vector<T>& to, Type type) {
        const auto records = package.records<T>(type);
        to.assign(records.begin(), records.end());
    };
    PackedModel m;
    m.record = package.scene();
    m.origin = Eigen::Map<const Eigen::Vector3d>(m.record.origin);
    copy(m.positions, Type::positions);
    copy(m.indices, Type::indices);
    copy(m.clusters, Type::clusters);
    m.opaque = opaque_part(package);
    return m;
}

void copy_merged_scene(const PackageReader& from, PackageWriter& writer) {
    for (const DirectoryEntry& e : from.directory()) {
        if (e.photo != package::scene_wide || chunk_row(Type(e.type)).write != ChunkWrite::planned) continue;
        if (!from.valid(e))
            throw Error(Exit::damaged,
                        from.path().string() + ": " + describe(e, from) + ": checksum does not match");
        writer.copy(from, e, package::scene_wide);
    }
}

/// Moves cameras back to their given poses if they were refined from other inputs.
void move_back(const FinishInput& in, PhotoTables& photos) {
    const PackageReader part(part_of(in.out), PackageReader::Expect::part);
    for (std::uint32_t i = 0; i < photos.records.size(); ++i) {
        PhotoRecord& r = photos.records[i];
        if (!(r.flags & package::photo_registered)) continue;
        r.flags &= ~std::uint32_t(package::photo_registered);
        move_photo(in.geometry, part, i, in.given[i], r, photos.states[i]);
    }
}

}  // namespace

void merge(const std::vector<fs::path>& files, const fs::path& out, const OnProgress& progress) {
    const std::vector<PackageReader> shares = open_shares(files);
    const PackageReader& first = shares.front();
    for (const PackageReader& share : shares) expect_same_scene(first, share);
    join(shares, std::string(first.meta()), first.scene(), out, progress);
}

namespace {

/// Copies the parts' model and photos into the package, except for those that an interrupted run has already
/// copied.
PhotoTables copy_parts(std::span<const PackageReader> parts, const fs::path& out, PackageWriter& writer,
                       const OnProgress& progress) {
    const PackageReader& first = parts.front();
    const auto planned = first.records<PhotoRecord>(Type::photos);
    PhotoTables photos{{planned.begin(), planned.end()}, std::vector<PhotoState>(planned.size())};
    EarlierPackages holders;
    if (writer.resumed()) holders.push_back(std::make_unique<EarlierPackage>(part_of(out), true));
    for (const PackageReader& part : parts)
        holders.push_back(std::make_unique<EarlierPackage>(part.path(), false));
    copy_merged_scene(first, writer);
    for (std::uint32_t i = 0; i < planned.size(); ++i) {
        merge_photo(i, holders, writer, photos.records[i], photos.states[i]);
        if (progress) progress({"copy", photos.records[i].name, i + 1, planned.size()});
    }
    return photos;
}

}  // namespace

void join(std::span<const PackageReader> parts, const std::string& meta, const package::SceneRecord& scene,
          const fs::path& out, const OnProgress& progress) {
    const PackageReader& first = parts.front();
    const auto records = first.records<PhotoRecord>(Type::photos);
    std::vector<std::string> image_sets;
    for (ImageSet& image_set : read_image_sets(first)) image_sets.push_back(std::move(image_set.name));
    const bool coordinates = stores_coordinates(scene, scene_settings_in(meta).vertex_coordinates);
    const LayoutSizes sizes = layout_sizes(first, meta.size(), coordinates);
    PackageWriter writer(out, plan_chunks(scene, sizes, records), names_checksum(records));
    PhotoTables photos = copy_parts(parts, out, writer, progress);

    const PackedModel model = model_of(first);
    const auto from = first.records<Eigen::Vector3f>(Type::normals);
    const std::vector<Eigen::Vector3f> normals(from.begin(), from.end());
    const PrepareSettings settings = scene_settings_in(meta);
    GeometryRenderer renderer(model, normals, settings);
    SplatCloud cloud;
    if (points_only(scene)) {
        cloud = splat_cloud(first);
        renderer.splats(cloud);
    }
    const auto discs = surface_disc_set(model.positions, model.opaque_indices(), scene.reference_density,
                                        bounds_from_origin(scene));
    const GeometryContext geometry{.model = model,
                                   .discs = discs,
                                   .renderer = renderer,
                                   .reference_density = scene.reference_density,
                                   .writer = writer};
    FinishInput in{.geometry = geometry,
                   .out = out,
                   .meta = meta,
                   .choices = choices_in(meta),
                   .validate = settings.validate,
                   .scene = scene,
                   .image_sets = std::move(image_sets),
                   .given = given_poses(first),
                   .known = {},
                   .known_pairs = pairs_of(first),
                   .progress = progress};
    const auto fingerprints =
        pose_refinement_fingerprints(photos.states, photos.records, in.given, renderer.by_opengl());
    const EffectChoice choice = choice_of(in.choices, Effect::pose_refinement);
    in.known = pose_refinement_of(first, pose_refinement_key(fingerprints, choice, in.validate));
    if (!in.known) move_back(in, photos);
    finish_package(in, photos);
}

}  // namespace vantage
