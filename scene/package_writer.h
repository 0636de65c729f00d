#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "scene/package_format.h"

namespace vantage {

class PackageReader;

/// What a chunk will be, before its bytes exist.
struct ChunkPlan {
    package::Type type;
    std::uint32_t photo = package::scene_wide;
    std::uint32_t level = 0;
    std::uint64_t bytes = 0;  ///< of the head, for a chunk without blocks
    std::uint64_t blocks = 0;
    std::uint64_t block_length = 0;
};

/// A share of the photos: number `share` of `shares`, counted from 1; 0 of 0 is all of them.
struct Share {
    std::uint32_t share = 0, shares = 0;
    bool holds(std::size_t photo) const { return shares == 0 || photo % shares == share - 1; }
};

/// The bytes that a package of these chunks will have, and a checksum of where they lie.
struct PackageLayout {
    std::uint64_t bytes, checksum;
};
/// `names` is a checksum of the photos' names, in order.
PackageLayout package_layout(std::span<const ChunkPlan> plan, std::uint64_t names);

/// The file that `file` is written as until it is whole, and the one an unfit earlier one is moved to.
std::filesystem::path part_of(const std::filesystem::path& file);
std::filesystem::path former_part_of(const std::filesystem::path& file);

/// Writes a package whose layout is known before its contents: every chunk has its place, so photos may
/// finish in any order, from any thread, and the file is the same. The bytes go to FILE.part; finish() writes
/// the directory and the header, flushes, and renames. Until then FILE.part says of itself what it holds, so
/// that after a crash at any instant the next writer goes on with it: each chunk gets its directory entry
/// when it is sealed, and everything carries checksums.
class PackageWriter {
  public:
    /// Goes on with FILE.part where that has this very layout; moves one of another layout to FILE.former.
    /// `names` is a checksum of the photos' names, in order. Throws Error(storage) when the file cannot be
    /// made, is being written by another process, or the disk has not the room.
    PackageWriter(const std::filesystem::path& file, std::span<const ChunkPlan> plan, std::uint64_t names = 0,
                  Share share = {});
    /// Leaves FILE.part for the next writer; removes it where it never held anything.
    ~PackageWriter();
    PackageWriter(const PackageWriter&) = delete;
    PackageWriter& operator=(const PackageWriter&) = delete;

    /// FILE.part was there with this layout: read it by a PackageReader to see what can be kept.
    bool resumed() const;

    /// Chunks without blocks: exactly the planned bytes. Thread-safe. Throws Error(storage).
    void write(package::Type type, std::uint32_t photo, std::span<const std::byte> bytes);
    /// All blocks of a chunk: `fill` writes block `b` into its bytes, one after the other, so that no more
    /// than one is in memory. Thread-safe. Throws Error(storage).
    void write_blocks(package::Type type, std::uint32_t photo, std::uint32_t level,
                      const std::function<void(std::size_t b, std::span<std::byte> block)>& fill);
    /// The bytes of record number `index` in a scene-wide chunk that is written whole later: what a run that
    /// goes on reads. Thread-safe. Throws Error(storage).
    void note(package::Type type, std::size_t index, std::span<const std::byte> record);

    /// Keeps a chunk that FILE.part holds already, under the checksum it has there.
    void keep(const package::DirectoryEntry& entry);
    /// Copies a chunk from another package, as photo `photo`. Its soundness is the caller's to check.
    /// Thread-safe. Throws Error(storage).
    void copy(const PackageReader& from, const package::DirectoryEntry& entry, std::uint32_t photo);
    /// This photo has no chunks after all; its place stays free, and takes no room on disks that can have
    /// holes in files.
    void leave_out(std::uint32_t photo);

    /// A sealed chunk without blocks, as it lies in the file. Throws Error(storage).
    std::vector<std::byte> read(package::Type type, std::uint32_t photo) const;
    /// XXH3-64 of a sealed chunk's head.
    std::uint64_t checksum_of(package::Type type, std::uint32_t photo, std::uint32_t level = 0) const;
    std::uint64_t size() const;
    /// Throws std::logic_error when a planned chunk was neither written, kept, copied nor left out.
    void finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& v) {
    return std::as_bytes(std::span<const T>(v));
}
template <class T>
std::span<const std::byte> bytes_of_one(const T& value) {
    return std::as_bytes(std::span<const T>(&value, 1));
}

}  // namespace vantage
