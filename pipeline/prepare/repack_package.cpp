#include "pipeline/prepare/repack_package.h"

#include <mutex>
#include <string>

#include "base/text/error.h"
#include "base/values/bytes_of.h"
#include "pipeline/output/chunk_plan.h"
#include "pipeline/output/earlier_package.h"
#include "pipeline/output/meta.h"
#include "pipeline/output/photo_records.h"
#include "pipeline/output/stage_keys.h"
#include "pipeline/run/for_each_photo.h"
#include "pipeline/stages/tile_levels.h"
#include "scene/agreement/read_level.h"
#include "scene/package/chunk_table.h"
#include "scene/package/contents/image_sets.h"
#include "scene/package/contents/stored_tile.h"
#include "scene/package/package_shape.h"

namespace vantage {
namespace {

using package::DirectoryEntry;
using package::PhotoRecord;
using package::PhotoState;
using package::Type;

void copy_repacked_scene(const PackageReader& from, PackageWriter& to) {
    for (const DirectoryEntry& e : from.directory()) {
        const Type type{e.type};
        const bool rewritten = type == Type::meta || type == Type::scene || type == Type::states;
        if (e.photo != package::scene_wide || rewritten) continue;
        if (from.blocks(e) > 0)
            to.copy(from, e, package::scene_wide);
        else if (chunk_row(type).write == ChunkWrite::appended)
            to.append(type, from.records<std::byte>(type));
        else if (to.plans(type, package::scene_wide))
            to.write(type, package::scene_wide, from.records<std::byte>(type));
    }
}

void copy_thumbnail(const PackageReader& from, PackageWriter& to, std::uint32_t photo, const PhotoRecord& r) {
    std::vector<std::byte> rgba(std::size_t(r.thumbnail_width) * r.thumbnail_height * 4);
    if (!read_thumbnail(from, photo, rgba))
        throw Error(Exit::damaged, from.path().string() + ": the thumbnail of " + r.name + " is damaged");
    write_thumbnail(to, photo, {rgba, {int(r.thumbnail_width), int(r.thumbnail_height)}});
}

/// Copies a chunk of tiles. A chunk that is already in a compact form is not encoded again.
void copy_tiles(const PackageReader& from, PackageWriter& to, std::uint32_t photo, const PhotoRecord& r,
                Type type, std::uint32_t level) {
    const DirectoryEntry* e = from.find(type, photo, level);
    if (e && e->form != package::Form::raw && to.compact(type, photo, level)) {
        if (!from.valid(*e))
            throw Error(Exit::damaged, from.path().string() + ": " + describe(*e, from) + ": is damaged");
        return to.copy(from, *e, photo);
    }
    const Level size = level_size(int(r.width), int(r.height), int(level));
    write_tiles(to, type, photo, level, {read_level(from, r, photo, type, int(level)), size});
}

void copy_photo(const PackageReader& from, PackageWriter& to, std::uint32_t i, const PhotoRecord& r) {
    if (r.flags & package::photo_skipped) to.skip(i);
    if (r.levels == 0) return;
    for (const auto& [row, level] : chunks_of_photo(int(r.levels)))
        if (row->type == Type::thumbnail)
            copy_thumbnail(from, to, i, r);
        else if (row->levels != ChunkLevels::single)
            copy_tiles(from, to, i, r, row->type, level);
        else if (to.plans(row->type, i))
            to.write(row->type, i, from.records<std::byte>(row->type, i));
}

/// The photo's state with the checksums of its chunks. Its stages have no keys, because `prepare` would
/// produce different bytes.
PhotoState state_of(const PackageReader& from, const PackageWriter& to, std::uint32_t i,
                    const PhotoRecord& r) {
    PhotoState state = from.records<PhotoState>(Type::states)[i];
    for (const StageRow& row : stage_table()) {
        PhotoState::Made& made = state.stages[std::size_t(row.stage)];
        if (made.key == 0) continue;
        made = {0, r.levels ? content_of(row.stage, i, int(r.levels), to) : made.content};
    }
    seal(state, r);
    return state;
}

}  // namespace

void repack(const std::filesystem::path& file, bool compact, const std::filesystem::path& out,
            const OnProgress& progress) {
    const PackageReader from(file);
    expect_shape(from);
    package::SceneRecord scene = from.scene();
    scene.effects &= ~effect_bit(Effect::compact);
    if (compact) scene.effects |= effect_bit(Effect::compact);
    const std::string meta = repacked_meta(std::string(from.meta()), compact);
    const auto photos = from.photos();
    const bool coordinates =
        has_coordinates(from) && stores_coordinates(scene, scene_settings_in(meta).vertex_coordinates);
    PackageWriter to(out, plan_chunks(scene, layout_sizes(from, meta.size(), coordinates), photos),
                     names_checksum(photos));
    copy_repacked_scene(from, to);
    std::mutex mutex;
    std::size_t done = 0;
    for_each_photo(photos.size(), 0, [&](std::size_t i) {
        copy_photo(from, to, std::uint32_t(i), photos[i]);
        const std::scoped_lock lock(mutex);
        if (progress) progress({"repack", photos[i].name, ++done, photos.size()});
    });
    std::vector<PhotoState> states;
    for (std::uint32_t i = 0; i < photos.size(); ++i) states.push_back(state_of(from, to, i, photos[i]));
    to.write(Type::meta, package::scene_wide, std::as_bytes(std::span(meta)));
    to.write(Type::scene, package::scene_wide, bytes_of_one(scene));
    to.write(Type::states, package::scene_wide, bytes_of(states));
    to.finish();
}

}  // namespace vantage
