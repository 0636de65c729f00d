#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "scene/package/contents/record_values.h"
#include "scene/package/damaged_package.h"
#include "scene/package/package_format.h"
#include "scene/package/package_source.h"

namespace vantage {

/// A mapped package, in a file or on a server. Opening a package reads and checks only the header and the
/// directory. Spans point into the mapping and are valid as long as the reader lives, so functions that
/// return one cannot be called on a temporary.
///
/// If the package is on a server, bytes are fetched before they are read, and any function may throw
/// Error(input) if that fails. Content and records are fetched on demand and kept. The caller must hold
/// blocks, and the heads of chunks with blocks (see hold()).
class PackageReader {
  public:
    using Part = PackageSource::Part;
    /// Which files are accepted: only whole packages, or also packages that are still being prepared. In a
    /// package that is still being prepared, only the photo chunks that have been sealed so far are found,
    /// and scene-wide chunks may not have been written yet. The caller must check the records.
    enum class Expect { whole, part };
    /// Opens a package. Throws Error(input) if the file cannot be opened, and Error(damaged) if it is not as
    /// expected.
    explicit PackageReader(const std::filesystem::path& file, Expect expect = Expect::whole);
    explicit PackageReader(std::unique_ptr<PackageSource> source, Expect expect = Expect::whole);
    ~PackageReader();
    PackageReader(PackageReader&&) noexcept;
    PackageReader& operator=(PackageReader&&) noexcept;

    const std::filesystem::path& path() const;
    std::uint64_t size() const;
    const package::Header& header() const;
    std::span<const package::DirectoryEntry> directory() const&;
    std::span<const package::DirectoryEntry> directory() const&& = delete;

    /// The chunk's entry, or null if the package has no such chunk.
    const package::DirectoryEntry* find(package::Type type, std::uint32_t photo = package::scene_wide,
                                        std::uint32_t level = 0) const;

    /// The content of a chunk without blocks, decompressed if necessary and kept until the reader is closed;
    /// for other chunks, the head. Empty if `entry` is null or the content cannot be decompressed.
    std::span<const std::byte> bytes(const package::DirectoryEntry* entry) const&;
    std::span<const std::byte> bytes(const package::DirectoryEntry*) const&& = delete;
    /// The length of the content that bytes() returns; 0 if `entry` is null.
    std::uint64_t content_length(const package::DirectoryEntry* entry) const;
    /// The number of stored blocks. For color in cells, blocks are not tiles.
    std::size_t blocks(const package::DirectoryEntry& entry) const;
    /// The data shared by the blocks of a coded chunk; empty for other chunks.
    std::span<const std::byte> shared(const package::DirectoryEntry& entry) const&;
    std::span<const std::byte> shared(const package::DirectoryEntry&) const&& = delete;
    /// A block as stored; empty if the chunk's head is damaged. Throws Error(damaged) if there is no such
    /// block.
    std::span<const std::byte> block(const package::DirectoryEntry& entry, std::size_t index) const&;
    std::span<const std::byte> block(const package::DirectoryEntry&, std::size_t) const&& = delete;
    /// A block as stored, after verification. Throws Error(damaged) if the block's checksum does not match.
    std::span<const std::byte> valid_block(const package::DirectoryEntry& entry, std::size_t index) const&;
    std::span<const std::byte> valid_block(const package::DirectoryEntry&, std::size_t) const&& = delete;
    /// True if the block's checksum matches.
    bool block_valid(const package::DirectoryEntry& entry, std::size_t index) const;
    /// The head of a chunk, as stored.
    Part head(const package::DirectoryEntry& entry) const&;
    Part head(const package::DirectoryEntry&) const&& = delete;
    /// The head and the blocks as stored, and the file's descriptor, for copying.
    std::span<const std::byte> raw(const package::DirectoryEntry& entry) const&;
    std::span<const std::byte> raw(const package::DirectoryEntry&) const&& = delete;
    int descriptor() const;
    /// If the package is on a server, fetches these bytes, which stay readable as long as the result lives.
    /// Otherwise does nothing. Throws Error(input) if the bytes cannot be fetched, Error(storage) if the
    /// cache cannot be used, and Error(interrupted) when stopped.
    [[nodiscard]] Held hold(std::span<const Part> parts, std::stop_token stop = {}) const;
    /// Discards fetched bytes that do not match a checksum, so that they are fetched again. False for a file.
    bool discard(std::span<const Part> parts) const;
    /// Fetches a whole chunk again after a checksum mismatch. False for a file.
    bool fetch_again(const package::DirectoryEntry& entry) const;
    /// Fetches everything needed before the first tile in one batch and keeps it: chunks without blocks, and
    /// thumbnails. Throws whatever hold() throws.
    void fetch_scene(std::stop_token stop = {}) const;
    /// The number of bytes that fetch_scene() fetches.
    std::uint64_t scene_bytes() const;
    bool remote() const;
    /// Traffic with the server; empty for a file.
    std::optional<SourceTraffic> traffic() const;

    /// Releases the pages of these bytes, or of the whole file; they are read from the file again when
    /// needed. Decompressed content is kept.
    void forget(std::span<const std::byte> bytes) const;
    void forget_all() const;
    /// True if the head's checksum matches. A chunk without blocks consists only of its head.
    bool head_valid(const package::DirectoryEntry& entry) const;
    /// True if the checksums of the head and of every block match.
    bool valid(const package::DirectoryEntry& entry) const;

    /// A chunk as records. Throws Error(damaged) if the chunk is missing although it is `required`, if its
    /// checksum does not match, or if its length is not a multiple of the record's length.
    template <class T>
    std::span<const T> records(package::Type type, std::uint32_t photo = package::scene_wide,
                               bool required = true) const& {
        const auto raw = checked(type, photo, sizeof(T), required);
        return {reinterpret_cast<const T*>(raw.data()), raw.size() / sizeof(T)};
    }
    template <class T>
    std::span<const T> records(package::Type, std::uint32_t = package::scene_wide,
                               bool = true) const&& = delete;

    /// The scene record and the photo records, copied and checked on first use. Throws Error(damaged).
    const package::SceneRecord& scene() const;
    std::span<const package::PhotoRecord> photos() const&;
    std::span<const package::PhotoRecord> photos() const&& = delete;
    /// META's JSON text. Throws Error(damaged).
    std::string_view meta() const&;
    std::string_view meta() const&& = delete;

    /// The index of the photo with this name, given with or without its extension. Throws Error(usage) if
    /// several photos have this name without the extension.
    std::optional<std::uint32_t> photo_index(std::string_view name) const;
    /// For each photo, the stem of its output files (see file_stems).
    std::vector<std::string> photo_stems() const;

  private:
    struct Mapping;
    std::span<const std::byte> checked(package::Type type, std::uint32_t photo, std::size_t record,
                                       bool required) const;
    package::SceneRecord checked_scene() const;
    std::unique_ptr<Mapping> map_;
};

/// A type's name in messages, such as "TILE".
std::string fourcc_of(package::Type type);
/// A chunk's name in messages, such as "TILE of photo 3 (00003.jpg), level 2".
std::string describe(const package::DirectoryEntry& entry, const PackageReader& reader);

}  // namespace vantage
