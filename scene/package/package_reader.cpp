#include "scene/package/package_reader.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstring>
#include <map>
#include <mutex>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "base/files/checksum.h"
#include "base/text/photo_names.h"
#include "scene/package/chunk_table.h"
#include "scene/package/contents/zstd_chunk.h"
#include "scene/package/mapped_package.h"
#include "scene/package/mismatches.h"
#include "scene/package/package_directory.h"

namespace vantage {

using package::DirectoryEntry;
using package::Form;
using package::Type;

namespace {

/// The number of image sets to which photos may belong; 1 without BAND.
std::uint64_t number_of_image_sets(const DirectoryEntry* chunk) {
    return chunk ? chunk->head_length / sizeof(package::ImageSetRecord) : 1;
}

std::vector<std::string_view> names_of(std::span<const package::PhotoRecord> photos) {
    std::vector<std::string_view> names;
    for (const package::PhotoRecord& p : photos) names.emplace_back(p.name);
    return names;
}

}  // namespace

struct PackageReader::Mapping {
    std::unique_ptr<PackageSource> source;
    const std::byte* data = nullptr;
    std::uint64_t size = 0;
    bool remote = false;
    std::vector<Held> held;
    std::vector<DirectoryEntry> directory;  ///< a copy, because the directory of a part changes
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, const DirectoryEntry*> index;
    // The records are copied before they are used, because the file may be overwritten while it is open.
    std::once_flag scene_read, photos_read;
    package::SceneRecord scene{};
    std::vector<package::PhotoRecord> photos;
    std::mutex mutex;  ///< guards `contents`
    std::map<const DirectoryEntry*, std::vector<std::byte>> contents;

    std::mutex holding;  ///< guards `whole` and `held`
    std::set<const DirectoryEntry*> whole;

    Mapping(std::unique_ptr<PackageSource> from, Expect expect)
        : source(std::move(from)),
          data(source->bytes().data()),
          size(source->bytes().size()),
          remote(source->traffic().has_value()),
          directory(read_directory(*source, expect == Expect::part, held)) {
        for (const DirectoryEntry& e : directory) index[{e.type, e.photo, e.level}] = &e;
    }

    Held hold(std::span<const Part> parts, std::stop_token stop) const {
        Held fetched = source->hold(parts, std::move(stop));
        if (!fetched) throw Error(Exit::interrupted, source->name().string() + ": stopped while being read");
        return fetched;
    }
    /// Fetches these byte ranges, which then stay readable.
    void keep(std::span<const Part> parts, std::stop_token stop = {}) {
        Held fetched = hold(parts, std::move(stop));
        const std::scoped_lock lock(holding);
        held.push_back(std::move(fetched));
    }
    void keep(Part part) {
        if (remote) keep({&part, 1});
    }
    /// Fetches a chunk again after a checksum mismatch. False for a file.
    bool again(const DirectoryEntry& e) {
        const Part part(data + e.offset, e.length);
        if (!source->discard({&part, 1})) return false;
        keep(part);
        return true;
    }
    /// Fetches the content lengths of all compressed scene-wide chunks.
    void keep_lengths() {
        std::vector<Part> words;
        for (const DirectoryEntry& e : directory)
            if (e.photo == package::scene_wide && e.form == Form::zstd)
                words.emplace_back(data + e.offset, sizeof(std::uint64_t));
        if (remote && !words.empty()) keep(words);
    }
    bool has_whole(const DirectoryEntry* e) {
        const std::scoped_lock lock(holding);
        return whole.contains(e);
    }
    /// Fetches whole chunks, which then stay readable.
    void keep(std::vector<const DirectoryEntry*> chunks, std::stop_token stop = {}) {
        if (!remote) return;
        {
            const std::scoped_lock lock(holding);
            std::erase_if(chunks, [&](const DirectoryEntry* e) { return whole.contains(e); });
        }
        if (chunks.empty()) return;
        std::vector<Part> parts;
        for (const DirectoryEntry* e : chunks) parts.emplace_back(data + e->offset, e->length);
        keep(parts, std::move(stop));
        const std::scoped_lock lock(holding);
        whole.insert(chunks.begin(), chunks.end());
    }

    std::uint64_t word(std::uint64_t offset) const {
        std::uint64_t w;
        std::memcpy(&w, data + offset, sizeof w);
        return w;
    }

    /// The content of a zstd chunk, decompressed once; empty if it is damaged.
    std::span<const std::byte> decompressed(const DirectoryEntry& e) {
        const std::scoped_lock lock(mutex);
        const auto [found, is_new] = contents.try_emplace(&e);
        if (!is_new) return found->second;
        return found->second = content_of_zstd({data + e.offset, e.length});
    }

    [[noreturn]] void damaged(Defect defect, const std::string& what) const {
        throw DamagedPackage(defect, source->name().string() + ": " + what);
    }

    /// The chunks that are needed before the first tile: thumbnails, and chunks without blocks except
    /// coordinates per vertex.
    std::vector<const DirectoryEntry*> before_tiles() const {
        std::vector<const DirectoryEntry*> out;
        for (const DirectoryEntry& e : directory) {
            const bool streamed =
                e.block_length > 0 || (e.coded_blocks > 0 && e.type != std::uint32_t(Type::thumbnail));
            if (!streamed && e.type != std::uint32_t(Type::coordinates)) out.push_back(&e);
        }
        return out;
    }
};

PackageReader::PackageReader(const std::filesystem::path& file, Expect expect)
    : PackageReader(mapped_package(file), expect) {}

PackageReader::PackageReader(std::unique_ptr<PackageSource> source, Expect expect)
    : map_(std::make_unique<Mapping>(std::move(source), expect)) {}
PackageReader::~PackageReader() = default;
PackageReader::PackageReader(PackageReader&&) noexcept = default;
PackageReader& PackageReader::operator=(PackageReader&&) noexcept = default;

const std::filesystem::path& PackageReader::path() const { return map_->source->name(); }
std::uint64_t PackageReader::size() const { return map_->size; }
const package::Header& PackageReader::header() const {
    return *reinterpret_cast<const package::Header*>(map_->data);
}
std::span<const DirectoryEntry> PackageReader::directory() const& { return map_->directory; }

const DirectoryEntry* PackageReader::find(Type type, std::uint32_t photo, std::uint32_t level) const {
    const auto it = map_->index.find({std::uint32_t(type), photo, level});
    return it == map_->index.end() ? nullptr : it->second;
}

std::span<const std::byte> PackageReader::bytes(const DirectoryEntry* e) const& {
    if (!e) return {};
    if (e->block_length == 0 && e->coded_blocks == 0) map_->keep({e});
    if (e->form == Form::zstd) return map_->decompressed(*e);
    return head(*e);
}

std::uint64_t PackageReader::content_length(const DirectoryEntry* e) const {
    if (!e) return 0;
    if (map_->remote && e->form == Form::zstd && !map_->has_whole(e))
        map_->keep({map_->data + e->offset, sizeof(std::uint64_t)});
    return e->form == Form::zstd ? map_->word(e->offset) : e->head_length;
}

std::size_t PackageReader::blocks(const DirectoryEntry& e) const {
    if (e.form != Form::raw) return e.coded_blocks;
    return e.block_length ? (e.length - e.head_length) / e.block_length : 0;
}

std::span<const std::byte> PackageReader::shared(const DirectoryEntry& e) const& {
    if (e.form == Form::raw || e.form == Form::zstd) return {};
    const std::uint64_t tables = package::coded_block_entry * e.coded_blocks;
    return {map_->data + e.offset + tables, e.head_length - tables};
}

std::span<const std::byte> PackageReader::block(const DirectoryEntry& e, std::size_t i) const& {
    if (i >= blocks(e))
        map_->damaged(Defect::chunk_missing,
                      describe(e, *this) + ": block " + std::to_string(i) + " does not exist");
    const std::byte* first = map_->data + e.offset + e.head_length;
    if (e.form == Form::raw) return {first + i * e.block_length, e.block_length};
    const std::uint64_t ends = e.offset + e.coded_blocks * sizeof(std::uint64_t),
                        from = i ? map_->word(ends + (i - 1) * sizeof from) : 0,
                        to = map_->word(ends + i * sizeof from);
    if (from > to || to > e.length - e.head_length) return {};
    return {first + from, to - from};
}

std::span<const std::byte> PackageReader::valid_block(const DirectoryEntry& e, std::size_t i) const& {
    const auto bytes = block(e, i);
    if (!block_valid(e, i)) map_->damaged(Defect::tile_checksum, tile_mismatch(*this, e, i));
    return bytes;
}

bool PackageReader::block_valid(const DirectoryEntry& e, std::size_t i) const {
    const auto bytes = block(e, i);
    return !bytes.empty() && checksum(bytes) == map_->word(e.offset + i * sizeof(std::uint64_t));
}

PackageReader::Part PackageReader::head(const DirectoryEntry& e) const& {
    return {map_->data + e.offset, e.head_length};
}

std::span<const std::byte> PackageReader::raw(const DirectoryEntry& e) const& {
    return {map_->data + e.offset, e.length};
}

int PackageReader::descriptor() const { return map_->source->descriptor(); }

bool PackageReader::remote() const { return map_->remote; }
std::optional<SourceTraffic> PackageReader::traffic() const { return map_->source->traffic(); }

Held PackageReader::hold(std::span<const Part> parts, std::stop_token stop) const {
    return map_->hold(parts, std::move(stop));
}

bool PackageReader::discard(std::span<const Part> parts) const { return map_->source->discard(parts); }
bool PackageReader::fetch_again(const DirectoryEntry& e) const { return map_->again(e); }

void PackageReader::fetch_scene(std::stop_token stop) const {
    map_->keep(map_->before_tiles(), std::move(stop));
}

std::uint64_t PackageReader::scene_bytes() const {
    std::uint64_t bytes = 0;
    for (const DirectoryEntry* e : map_->before_tiles()) bytes += e->length;
    return bytes;
}

bool PackageReader::valid(const DirectoryEntry& e) const {
    if (!head_valid(e)) return false;
    for (std::size_t b = 0; b < blocks(e); ++b)
        if (!block_valid(e, b)) return false;
    return true;
}

void PackageReader::forget(std::span<const std::byte> bytes) const {
    // Decompressed content is not part of the mapping.
    if (bytes.data() < map_->data || bytes.data() >= map_->data + map_->size) return;
    const auto page = std::uintptr_t(::sysconf(_SC_PAGESIZE));
    const auto first = (reinterpret_cast<std::uintptr_t>(bytes.data()) + page - 1) / page * page,
               last = (reinterpret_cast<std::uintptr_t>(bytes.data()) + bytes.size()) / page * page;
    if (first < last) ::madvise(reinterpret_cast<void*>(first), last - first, MADV_DONTNEED);
}

void PackageReader::forget_all() const { forget({map_->data, map_->size}); }

bool PackageReader::head_valid(const DirectoryEntry& e) const {
    if (e.block_length == 0 && e.coded_blocks == 0) map_->keep({&e});
    return checksum(head(e)) == e.checksum;
}

std::span<const std::byte> PackageReader::checked(Type type, std::uint32_t photo, std::size_t record,
                                                  bool required) const {
    const DirectoryEntry* e = find(type, photo);
    if (!e) {
        const auto t = std::uint32_t(type);
        if (required)
            map_->damaged(Defect::chunk_missing,
                          "chunk " + std::string(reinterpret_cast<const char*>(&t), 4) + " is missing");
        return {};
    }
    if (!head_valid(*e) && !(map_->again(*e) && head_valid(*e)))
        map_->damaged(Defect::chunk_checksum, describe(*e, *this) + ": checksum does not match");
    if (content_length(e) % record)
        map_->damaged(Defect::invalid_record,
                      describe(*e, *this) + ": length is not a multiple of its record size");
    const auto content = bytes(e);
    if (content.size() != content_length(e))
        map_->damaged(Defect::invalid_record, describe(*e, *this) + ": cannot be decompressed");
    return content;
}

package::SceneRecord PackageReader::checked_scene() const {
    const auto records = this->records<package::SceneRecord>(Type::scene);
    if (records.size() != 1) map_->damaged(Defect::invalid_record, "SCEN: expected one record");
    const package::SceneRecord s = records[0];
    map_->keep_lengths();
    if (const char* flaw = flaw_of(s)) map_->damaged(Defect::invalid_record, std::string("SCEN: ") + flaw);
    for (const Type type : {Type::photos, Type::positions, Type::normals, Type::indices, Type::clusters}) {
        const ChunkRow& row = chunk_row(type);
        const DirectoryEntry* e = find(type);
        const std::uint64_t length = content_length(e), count = row.count(s, {});
        if (!e || count > length / row.record || length != count * row.record)
            map_->damaged(Defect::invalid_record,
                          fourcc_of(type) + ": length does not match the scene's counts");
    }
    return s;
}

const package::SceneRecord& PackageReader::scene() const {
    std::call_once(map_->scene_read, [this] { map_->scene = checked_scene(); });
    return map_->scene;
}

std::span<const package::PhotoRecord> PackageReader::photos() const& {
    std::call_once(map_->photos_read, [this] {
        const auto given = records<package::PhotoRecord>(Type::photos);
        std::vector<package::PhotoRecord> photos(given.begin(), given.end());
        const std::uint64_t image_sets = number_of_image_sets(find(Type::image_sets));
        for (std::size_t i = 0; i < photos.size(); ++i) {
            if (const char* flaw = flaw_of(photos[i]))
                map_->damaged(Defect::invalid_record, "PHOT " + std::to_string(i) + ": " + flaw);
            if (photos[i].image_set >= image_sets)
                map_->damaged(Defect::invalid_record, "PHOT " + std::to_string(i) + ": image set " +
                                                          std::to_string(photos[i].image_set) +
                                                          ", expected one below " +
                                                          std::to_string(image_sets));
        }
        map_->photos = std::move(photos);
    });
    return map_->photos;
}

std::string_view PackageReader::meta() const& {
    const auto text = records<char>(Type::meta);
    return {text.data(), text.size()};
}

std::optional<std::uint32_t> PackageReader::photo_index(std::string_view wanted) const {
    const std::vector<std::string_view> names = names_of(photos());
    const std::vector<std::size_t> meant = photos_meant(names, wanted);
    if (meant.size() > 1)
        throw Error(Exit::usage, path().string() + ": photo " + std::string(wanted) +
                                     " is ambiguous, expected one of " + listed(names, meant));
    return meant.empty() ? std::nullopt : std::optional(std::uint32_t(meant.front()));
}

std::vector<std::string> PackageReader::photo_stems() const { return file_stems(names_of(photos())); }

namespace {}  // namespace

namespace {}  // namespace

std::string fourcc_of(Type type) {
    std::string text;
    for (int i = 0; i < 4; ++i) {
        const char c = char(std::uint32_t(type) >> (8 * i) & 0xff);
        text += c >= 32 && c < 127 ? c : '?';
    }
    return text;
}

std::string describe(const DirectoryEntry& e, const PackageReader& reader) {
    std::string text = fourcc_of(Type{e.type});
    if (e.photo == package::scene_wide) return text;
    text += " of photo " + std::to_string(e.photo);
    const DirectoryEntry* photos = reader.find(Type::photos);
    const auto raw = reader.bytes(photos);
    if (e.photo < raw.size() / sizeof(package::PhotoRecord)) {
        const char* n = reinterpret_cast<const char*>(raw.data()) + e.photo * sizeof(package::PhotoRecord);
        text += " (" + std::string(n, ::strnlen(n, 192)) + ")";
    }
    if (e.block_length) text += ", level " + std::to_string(e.level);
    return text;
}

}  // namespace vantage
