#include "scene/package/package_reader.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <mutex>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "base/files/checksum.h"
#include "base/text/photo_names.h"
#include "base/values/tiling.h"
#include "scene/codec/zstd_bytes.h"
#include "scene/package/chunk_table.h"
#include "scene/package/damaged_package.h"
#include "scene/package/mapped_package.h"

namespace vantage {

using package::DirectoryEntry;
using package::Form;
using package::Type;

namespace {

constexpr std::uint32_t largest_thumbnail = 4096;  ///< px along a side

/// Why a photo's record is unusable; null if it is valid.
const char* flaw_of(const package::PhotoRecord& p) {
    const auto finite = [](const auto& values) {
        return std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
    };
    if (std::memchr(p.name, 0, sizeof p.name) == nullptr) return "name is not terminated";
    const std::string_view name = p.name;  // extract writes a file of this name: no folders
    if (name.empty() || name == "." || name == ".." || name.find('/') != name.npos)
        return "name is not a file name";
    if (p.width == 0 || p.height == 0 || p.width > 1u << 20 || p.height > 1u << 20 || p.levels > 24)
        return "size is out of range";
    if (!(p.fx > 0) || !(p.fy > 0) || !std::isfinite(p.fx + p.fy + p.cx + p.cy))
        return "intrinsics are out of range";
    if (!finite(p.R) || !finite(p.t) || !finite(p.corrected_direction) ||
        !std::isfinite(p.seen_distance + p.z_min + p.z_max + p.hull_area))
        return "camera is not finite";
    if (p.thumbnail_width > largest_thumbnail || p.thumbnail_height > largest_thumbnail)
        return "thumbnail size is out of range";
    for (int i = 0; i < 3; ++i)
        if (!(p.gain[i] >= 1e-3 && p.gain[i] <= 1e3) || !(std::abs(p.vignetting[i]) <= 100))
            return "gain or vignetting is out of range";
    return nullptr;
}

/// Why the scene's record is unusable; null if it is valid.
const char* flaw_of(const package::SceneRecord& s) {
    const auto within = [](const auto& values, double low, double high) {
        return std::ranges::all_of(values, [&](double v) { return v >= low && v <= high; });
    };
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(s.origin[i]) || !(s.bounds_min[i] <= s.bounds_max[i]))
            return "origin or bounds are not finite";
    if (std::abs(Eigen::Vector3d(s.up).norm() - 1) > 1e-6) return "up is not of length 1";
    if (!within(s.shade, 0, 1)) return "shade is out of range";
    constexpr double farthest = 1e300;
    if (!within(s.first_target, -farthest, farthest) || !(s.first_fov > 0.01 && s.first_fov < 179) ||
        !(s.first_aspect > 1e-3 && s.first_aspect < 1e3))
        return "first view is out of range";
    return nullptr;
}

/// That a photo may belong to: 1 without BAND.
std::uint64_t number_of_image_sets(const DirectoryEntry* chunk) {
    return chunk ? chunk->head_length / sizeof(package::ImageSetRecord) : 1;
}

std::vector<std::string_view> names_of(std::span<const package::PhotoRecord> photos) {
    std::vector<std::string_view> names;
    for (const package::PhotoRecord& p : photos) names.emplace_back(p.name);
    return names;
}

constexpr std::uint64_t held_at_once = 16 << 20;  ///< bytes of blocks, of a package on a server

std::string tile_mismatch(const PackageReader& reader, const DirectoryEntry& e, std::size_t tile) {
    return describe(e, reader) + ": tile " + std::to_string(tile) + " of " +
           std::to_string(reader.blocks(e)) + ": checksum does not match";
}

}  // namespace

struct PackageReader::Mapping {
    std::unique_ptr<PackageSource> source;
    const std::byte* data = nullptr;
    std::uint64_t size = 0;
    bool remote = false;
    std::vector<DirectoryEntry> directory;  ///< copied: a part's changes while it is written
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, const DirectoryEntry*> index;
    // Copied before they are used, because the file may be overwritten while it is open.
    std::once_flag scene_read, photos_read;
    package::SceneRecord scene{};
    std::vector<package::PhotoRecord> photos;
    std::mutex mutex;  ///< of `contents`
    std::map<const DirectoryEntry*, std::vector<std::byte>> contents;

    std::mutex holding;  ///< of `whole` and `held`
    std::set<const DirectoryEntry*> whole;
    std::vector<Held> held;

    explicit Mapping(std::unique_ptr<PackageSource> from)
        : source(std::move(from)),
          data(source->bytes().data()),
          size(source->bytes().size()),
          remote(source->traffic().has_value()) {}

    Held hold(std::span<const Part> parts, std::stop_token stop) const {
        Held fetched = source->hold(parts, std::move(stop));
        if (!fetched) throw Error(Exit::interrupted, source->name().string() + ": stopped while it was read");
        return fetched;
    }
    /// Fetches these parts, which then stay readable.
    void keep(std::span<const Part> parts, std::stop_token stop = {}) {
        Held fetched = hold(parts, std::move(stop));
        const std::scoped_lock lock(holding);
        held.push_back(std::move(fetched));
    }
    void keep(Part part) {
        if (remote) keep({&part, 1});
    }
    /// Fetches a chunk again that does not match its checksum. False for a file.
    bool again(const DirectoryEntry& e) {
        const Part part(data + e.offset, e.length);
        if (!source->discard({&part, 1})) return false;
        keep(part);
        return true;
    }
    /// Fetches the lengths of the content of all compressed chunks of the scene.
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
    /// The same for whole chunks.
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
        const std::uint64_t length = word(e.offset);
        if (length / package::max_expansion > e.length) return {};
        found->second.resize(length);
        const std::span frame(data + e.offset + sizeof length, e.length - sizeof length);
        if (!codec::decompress(frame, found->second)) found->second = {};
        return found->second;
    }

    [[noreturn]] void damaged(Defect defect, const std::string& what) const {
        throw DamagedPackage(defect, source->name().string() + ": " + what);
    }

    const package::Header& header() const { return *reinterpret_cast<const package::Header*>(data); }

    bool is_part() const { return std::memcmp(header().magic, package::part_magic, 8) == 0; }

    /// Header and directory.
    void read(Expect expect) {
        try {
            read_directory(checked_header(expect));
        } catch (const DamagedPackage&) {
            // Of a package on a server, the local copy may be what is damaged.
            const Part first(data, std::min<std::uint64_t>(size, sizeof(package::Header)));
            if (!source->discard({&first, 1})) throw;
            const package::Header& h = checked_header(expect);
            if (h.directory_offset < size) {
                const Part rest(
                    data + h.directory_offset,
                    std::min(size - h.directory_offset, h.directory_count * sizeof(DirectoryEntry)));
                source->discard({&rest, 1});
            }
            read_directory(h);
        }
    }

    const package::Header& checked_header(Expect expect) {
        if (size < sizeof(package::Header))
            damaged(Defect::not_a_package,
                    "not a Vantage package: " + std::to_string(size) + " bytes, a header has 64");
        keep({data, sizeof(package::Header)});
        const package::Header& h = header();
        const bool part = is_part();
        if (part && expect == Expect::whole && h.shares > 0 && h.directory_checksum != 0)
            damaged(Defect::unfinished, "header: holds share " + std::to_string(h.share) + " of " +
                                            std::to_string(h.shares) +
                                            " of the photos; join the shares with 'vantage merge'");
        if (part && expect == Expect::whole)
            damaged(Defect::unfinished, "header: preparation of this package was not finished");
        if (!part && std::memcmp(h.magic, package::magic, sizeof h.magic) != 0)
            damaged(Defect::not_a_package, "header: not a Vantage package");
        if (h.header_checksum != checksum({data, offsetof(package::Header, header_checksum)}))
            damaged(Defect::header_checksum, "header: checksum does not match");
        if (h.version != package::version) {
            const bool newer = h.version > package::version;
            damaged(newer ? Defect::newer_format : Defect::format_version,
                    "header: format version " + std::to_string(h.version) + ", this program reads " +
                        std::to_string(package::version) +
                        (newer ? "; made by a newer version of vantage" : "; prepare it again"));
        }
        if (h.file_size != size)
            damaged(Defect::truncated, "header: the file has " + std::to_string(size) + " bytes, expected " +
                                           std::to_string(h.file_size));
        return h;
    }

    void read_directory(const package::Header& h) {
        if (h.directory_offset % 8 || h.directory_offset > size ||
            h.directory_count > (size - h.directory_offset) / sizeof(DirectoryEntry))
            damaged(Defect::directory, "directory: lies outside the file");
        keep({data + h.directory_offset, h.directory_count * sizeof(DirectoryEntry)});
        const auto* first = reinterpret_cast<const DirectoryEntry*>(data + h.directory_offset);
        directory.assign(first, first + h.directory_count);
        // A part's entries are written one by one; a torn one is ignored.
        const bool growing = is_part() && h.directory_checksum == 0;
        if (growing)
            std::erase_if(directory, [&](const DirectoryEntry& e) { return e.type == 0 || !fits(e); });
        else if (checksum(std::as_bytes(std::span(directory))) != h.directory_checksum)
            damaged(Defect::directory, "directory: checksum does not match");
        for (const DirectoryEntry& e : directory) {
            if (!fits(e))
                damaged(Defect::directory, "directory: entry " + std::to_string(&e - directory.data()) +
                                               " lies outside the file");
            index[{e.type, e.photo, e.level}] = &e;
        }
    }

    /// Chunks without blocks, except coordinates per vertex, and thumbnails.
    std::vector<const DirectoryEntry*> before_tiles() const {
        std::vector<const DirectoryEntry*> out;
        for (const DirectoryEntry& e : directory) {
            const bool streamed =
                e.block_length > 0 || (e.coded_blocks > 0 && e.type != std::uint32_t(Type::thumbnail));
            if (!streamed && e.type != std::uint32_t(Type::coordinates)) out.push_back(&e);
        }
        return out;
    }

    bool fits(const DirectoryEntry& e) const {
        const bool raw = e.form == Form::raw;
        return e.offset % (raw ? package::alignment : package::coded_alignment) == 0 && e.offset <= size &&
               e.length <= size - e.offset && e.head_length <= e.length &&
               (raw ? raw_fits(e) : coded_fits(e));
    }

    static bool raw_fits(const DirectoryEntry& e) {
        return e.block_length == 0 ? e.head_length == e.length : blocks_fit(e);
    }

    /// Forms of later programs are left alone.
    static bool coded_fits(const DirectoryEntry& e) {
        if (e.form == Form::zstd) return e.head_length == e.length && e.length >= sizeof(std::uint64_t);
        return e.head_length / package::coded_block_entry >= e.coded_blocks;
    }

    static bool blocks_fit(const DirectoryEntry& e) {
        const std::uint64_t body = e.length - e.head_length;
        return body % e.block_length == 0 && e.head_length % package::alignment == 0 &&
               body / e.block_length <= e.head_length / sizeof(std::uint64_t);
    }
};

PackageReader::PackageReader(const std::filesystem::path& file, Expect expect)
    : PackageReader(mapped_package(file), expect) {}

PackageReader::PackageReader(std::unique_ptr<PackageSource> source, Expect expect)
    : map_(std::make_unique<Mapping>(std::move(source))) {
    map_->read(expect);
}
PackageReader::~PackageReader() = default;
PackageReader::PackageReader(PackageReader&&) noexcept = default;
PackageReader& PackageReader::operator=(PackageReader&&) noexcept = default;

const std::filesystem::path& PackageReader::path() const { return map_->source->name(); }
std::uint64_t PackageReader::size() const { return map_->size; }
const package::Header& PackageReader::header() const { return map_->header(); }
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
    // Content that was decompressed is not in the file.
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

namespace {

void add_block_mismatches(const PackageReader& package, const DirectoryEntry& e, std::size_t most,
                          std::vector<Mismatch>& out) {
    const auto body = package.raw(e).subspan(e.head_length);
    std::uint64_t end = 0;  ///< of what is held
    Held held;
    for (std::size_t b = 0; b < package.blocks(e) && out.size() < most; ++b) {
        const auto block = package.block(e, b);
        const auto last = block.empty() ? 0 : std::uint64_t(block.data() - body.data()) + block.size();
        if (last > end) {
            const std::uint64_t begin = last - block.size();
            const auto next = body.subspan(
                begin, std::min(body.size() - begin, std::max<std::uint64_t>(held_at_once, block.size())));
            held = package.hold({&next, 1});
            end = begin + next.size();
        }
        if (!package.block_valid(e, b)) out.push_back({Defect::tile_checksum, tile_mismatch(package, e, b)});
    }
}

}  // namespace

std::vector<Mismatch> mismatches(const PackageReader& package, bool tiles, std::size_t most) {
    std::vector<Mismatch> out;
    for (const DirectoryEntry& e : package.directory()) {
        const auto head = package.head(e);
        const Held held = package.hold({&head, 1});
        const bool valid = package.head_valid(e);
        if (!valid)
            out.push_back({Defect::chunk_checksum, describe(e, package) + ": checksum does not match"});
        if (tiles && valid) add_block_mismatches(package, e, most, out);
        if (tiles) package.forget(package.raw(e));
        if (out.size() >= most) break;
    }
    return out;
}

void expect_valid(const PackageReader& package) {
    for (const Mismatch& m : mismatches(package, true, 1))
        throw DamagedPackage(m.defect, package.path().string() + ": " + m.text);
}

Intrinsics intrinsics(const package::PhotoRecord& p) {
    return {int(p.width), int(p.height), p.fx, p.fy, p.cx, p.cy};
}

Lens lens_of(const PackageReader& package, std::uint32_t photo) {
    const auto lenses = package.records<package::LensRecord>(Type::lenses, package::scene_wide, false);
    if (lenses.empty()) return {};
    const package::LensRecord r = photo < lenses.size() ? lenses[photo] : package::LensRecord{~0u, 0, {}};
    const bool finite = std::ranges::all_of(r.p, [](double v) { return std::isfinite(v); });
    if (r.model > std::uint32_t(last_lens_model) || !finite)
        throw DamagedPackage(Defect::invalid_record, package.path().string() + ": LENS: the lens of photo " +
                                                         std::to_string(photo) + " is out of range");
    Lens lens{LensModel(r.model), {}};
    std::ranges::copy(r.p, lens.p.begin());
    return lens;
}

namespace {

template <class Record>
Pose pose_of(const Record& r) {
    Pose pose;
    pose.R = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(r.R);
    pose.t = Eigen::Map<const Eigen::Vector3d>(r.t);
    return pose;
}

}  // namespace

Pose cam_from_origin(const package::PhotoRecord& photo) { return pose_of(photo); }
Pose cam_from_origin(const package::PoseRefinementRecord& given) { return pose_of(given); }
Pose cam_from_origin(const package::PoseWithoutRecord& without) { return pose_of(without); }

Eigen::AlignedBox3d bounds_from_origin(const package::SceneRecord& s) {
    const Eigen::Map<const Eigen::Vector3d> origin(s.origin), low(s.bounds_min), high(s.bounds_max);
    return {Eigen::Vector3d(low - origin), Eigen::Vector3d(high - origin)};
}

double model_reach(const package::SceneRecord& s, const Pose& pose) {
    return pose.center().norm() + 2 * bounds_from_origin(s).diagonal().norm();  // spheres around it as well
}

double seen_distance(const package::PhotoRecord& photo) {
    if (photo.seen_distance > 0) return photo.seen_distance;
    return std::max(1e-6, cam_from_origin(photo).center().norm());
}

bool effect_on(const package::SceneRecord& scene, Effect effect) {
    return scene.effects & effect_bit(effect);
}

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
