#include "pipeline/merge.h"

#include <algorithm>
#include <string>

#include "pipeline/finish_package.h"
#include "pipeline/former.h"
#include "pipeline/package_layout.h"
#include "pipeline/photo_stages.h"
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
                return j && f->hand_over(stage, *j, i, int(record.levels), state.stages[std::size_t(stage)],
                                         writer);
            });
            if (!taken)
                throw Error(Exit::damaged, std::string(record.name) + ": its " + name(stage) + " is damaged");
        }
    }
    writer.note(Type::photos, i, bytes_of_one(record));
    writer.note(Type::states, i, bytes_of_one(state));
}

}  // namespace

void merge(const std::vector<fs::path>& files, const fs::path& out) {
    const std::vector<PackageReader> shares = open_shares(files);
    const PackageReader& first = shares.front();
    for (const PackageReader& share : shares) expect_same_scene(first, share);
    join(shares, std::string(first.meta()), first.scene(), out);
}

void join(std::span<const PackageReader> parts, const std::string& meta, const package::SceneRecord& scene,
          const fs::path& out) {
    const PackageReader& first = parts.front();
    const auto planned = first.records<PhotoRecord>(Type::photos);
    PhotoTables photos{{planned.begin(), planned.end()}, std::vector<PhotoState>(planned.size())};
    auto& [records, states] = photos;
    const LayoutSizes sizes{meta.size(), first.find(Type::colors) != nullptr};
    PackageWriter writer(out, plan_chunks(scene, sizes, records), names_checksum(records));
    std::vector<std::unique_ptr<Former>> formers;
    if (writer.resumed()) formers.push_back(std::make_unique<Former>(part_of(out), true));
    for (const PackageReader& part : parts) formers.push_back(std::make_unique<Former>(part.path(), false));
    for (const DirectoryEntry& e : first.directory())
        if (e.photo == package::scene_wide && e.type != std::uint32_t(Type::photos) &&
            e.type != std::uint32_t(Type::states)) {
            if (!first.sound(e))
                throw Error(Exit::damaged, first.path().string() + ": " + describe(e, first));
            writer.copy(first, e, package::scene_wide);
        }
    for (std::uint32_t i = 0; i < records.size(); ++i) merge_photo(i, formers, writer, records[i], states[i]);
    finish_package(writer, meta, scene, photos);
}

}  // namespace vantage
