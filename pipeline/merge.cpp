#include "pipeline/merge.h"

#include <algorithm>
#include <string>

#include "pipeline/finish_package.h"
#include "pipeline/former.h"
#include "pipeline/package_layout.h"
#include "pipeline/photo_stages.h"
#include "pipeline/provenance.h"
#include "pipeline/registered.h"
#include "scene/error.h"

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
        throw Error(Exit::input, file.string() + ": is not a finished share, expected what --shard wrote");
    return share;
}

/// All shares, by their number.
std::vector<PackageReader> open_shares(const std::vector<fs::path>& files) {
    if (files.empty()) throw Error(Exit::usage, "no shares to merge");
    std::vector<PackageReader> shares;
    for (const fs::path& file : files) shares.push_back(open_share(file));
    const auto number = [](const PackageReader& r) { return r.header().share; };
    std::ranges::sort(shares, {}, number);
    const std::uint32_t expected = shares.front().header().shares;
    for (std::uint32_t n = 1; n <= expected; ++n) {
        const auto count = std::ranges::count(shares, n, number);
        if (count != 1)
            throw Error(Exit::input, "share " + std::to_string(n) + " of " + std::to_string(expected) +
                                         (count ? " is there more than once" : " is missing"));
    }
    return shares;
}

/// Scene-wide chunks must agree, but for what is said of single photos.
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

void merge_photo(std::uint32_t i, const std::vector<std::unique_ptr<Former>>& formers, PackageWriter& writer,
                 PhotoRecord& record, PhotoState& state) {
    const auto holder =
        std::ranges::find_if(formers, [&](const auto& f) { return bool(f->photo(record.name)); });
    if (holder == formers.end())
        throw Error(Exit::damaged, std::string(record.name) + ": none of the parts holds it");
    const std::uint32_t at = *(*holder)->photo(record.name);
    record = (*holder)->record(at);
    state = (*holder)->state(at);
    if (state.left_out[0]) {
        writer.leave_out(i);
    } else {
        for (const package::Stage stage : stages_of(record)) {
            const bool taken = std::ranges::any_of(formers, [&](const auto& f) {
                const auto j = f->photo(record.name);
                return j && f->hand_over(stage, *j, i, int(record.levels), state, writer);
            });
            if (!taken)
                throw Error(Exit::damaged, std::string(record.name) + ": its " + name(stage) + " is damaged");
        }
    }
    writer.note(Type::photos, i, bytes_of_one(record));
    writer.note(Type::states, i, bytes_of_one(state));
}

/// The model as a package holds it; normals beside it.
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
    return m;
}

bool is_written_last(const DirectoryEntry& e) {
    const Type type{e.type};
    return type == Type::photos || type == Type::states || type == Type::registration || type == Type::pairs;
}

void copy_scene(const PackageReader& from, PackageWriter& writer) {
    for (const DirectoryEntry& e : from.directory()) {
        if (e.photo != package::scene_wide || is_written_last(e)) continue;
        if (!from.sound(e)) throw Error(Exit::damaged, from.path().string() + ": " + describe(e, from));
        writer.copy(from, e, package::scene_wide);
    }
}

/// Where an earlier finish moved cameras for other reasons than these, they go back first.
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

void join(std::span<const PackageReader> parts, const std::string& meta, const package::SceneRecord& scene,
          const fs::path& out, const OnProgress& progress) {
    const PackageReader& first = parts.front();
    const auto planned = first.records<PhotoRecord>(Type::photos);
    PhotoTables photos{{planned.begin(), planned.end()}, std::vector<PhotoState>(planned.size())};
    auto& [records, states] = photos;
    const LayoutSizes sizes{meta.size(), first.find(Type::colors) != nullptr};
    PackageWriter writer(out, plan_chunks(scene, sizes, records), names_checksum(records));
    std::vector<std::unique_ptr<Former>> formers;
    if (writer.resumed()) formers.push_back(std::make_unique<Former>(part_of(out), true));
    for (const PackageReader& part : parts) formers.push_back(std::make_unique<Former>(part.path(), false));
    copy_scene(first, writer);
    for (std::uint32_t i = 0; i < records.size(); ++i) {
        merge_photo(i, formers, writer, records[i], states[i]);
        if (progress) progress({"copy", records[i].name, i + 1, records.size()});
    }

    const PackedModel model = model_of(first);
    const auto from = first.records<Eigen::Vector3f>(Type::normals);
    const std::vector<Eigen::Vector3f> normals(from.begin(), from.end());
    const PrepareSettings settings = geometry_settings(meta);
    GeometryRenderer renderer(model, normals, settings);
    const auto discs = surface_disc_set(model.positions, model.indices, scene.reference_density);
    const GeometryStages geometry{model,  discs,  renderer, settings.border_width, settings.border_threshold,
                                  writer, nullptr};
    FinishInput in{geometry, out, meta, scene, given_poses(first), {}, pairs_of(first), 0, progress};
    const EffectChoice choice = choice_of(forced_effects(meta), Effect::registration);
    in.known = registration_of(
        first, registration_key(registration_fingerprints(states, in.given, renderer.by_opengl()), choice));
    if (!in.known) move_back(in, photos);
    finish_package(in, photos);
}

}  // namespace vantage
