#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "base/files/part_file.h"
#include "base/values/bytes_of.h"
#include "scene/package/package_format.h"
#include "scene/package/package_layout.h"

namespace vantage {

class PackageReader;

/// Concatenated coded blocks; block i ends at ends[i] in `bytes`.
struct CodedBlocks {
    package::Form form = package::Form::raw;
    std::vector<std::byte> shared{};  ///< data shared by all blocks, to be stored in the head
    std::vector<std::byte> bytes{};
    std::vector<std::uint64_t> ends{};

    void add(std::span<const std::byte> block) {
        bytes.insert(bytes.end(), block.begin(), block.end());
        ends.push_back(bytes.size());
    }
};

/// Writes a package whose layout is known before its contents. Every chunk has a fixed position, so the file
/// does not depend on the order in which photos are finished or on the threads that process them. The bytes
/// go to FILE.part; finish() writes the directory and the header, flushes the file, and renames it. Compact
/// chunks do not fill their space; if there are any, finish() packs all chunks into another file. Until then,
/// a chunk's directory entry is written when the chunk is sealed, and everything has a checksum, so that the
/// next writer can resume after a crash at any point. write(), write_blocks(), note(), keep(), copy() and
/// skip() are thread-safe and throw Error(storage).
class PackageWriter {
  public:
    /// Resumes FILE.part if it has this layout; otherwise moves it to displaced_part_of(FILE). `names` is a
    /// checksum of the photos' names, in order. Throws Error(storage) if the file cannot be created, if
    /// another process is writing it, or if the disk has too little space.
    PackageWriter(const std::filesystem::path& file, std::span<const ChunkPlan> plan, std::uint64_t names = 0,
                  Share share = {});
    /// Leaves FILE.part for the next writer, or deletes it if it never held a chunk of a photo.
    ~PackageWriter();
    PackageWriter(const PackageWriter&) = delete;
    PackageWriter& operator=(const PackageWriter&) = delete;

    /// True if FILE.part existed with this layout; a PackageReader can then read it to decide which chunks to
    /// keep.
    bool resumed() const;

    /// Writes a chunk without blocks, with exactly the planned number of bytes. Compact chunks are
    /// compressed.
    void write(package::Type type, std::uint32_t photo, std::span<const std::byte> bytes);
    /// Writes all blocks of a chunk. `fill` is called for one block after another, so that only one block is
    /// in memory.
    void write_blocks(package::Type type, std::uint32_t photo, std::uint32_t level,
                      const std::function<void(std::size_t b, std::span<std::byte> block)>& fill);
    /// Writes a compact chunk with blocks if it is shorter than the raw chunk; otherwise returns false.
    bool write_coded(package::Type type, std::uint32_t photo, std::uint32_t level, const CodedBlocks& blocks);
    /// Whether a chunk was planned.
    bool plans(package::Type type, std::uint32_t photo, std::uint32_t level = 0) const;
    /// Whether a chunk may be stored in a shorter form.
    bool compact(package::Type type, std::uint32_t photo, std::uint32_t level = 0) const;
    /// Writes record `index` of a scene-wide chunk ahead of the whole chunk, so that a resumed run can read
    /// it.
    void note(package::Type type, std::size_t index, std::span<const std::byte> record);

    /// Adds an unplanned scene-wide chunk, which finish() writes after all others.
    void append(package::Type type, std::span<const std::byte> bytes);

    /// Keeps a chunk that FILE.part already holds, as `entry` describes it.
    void keep(const package::DirectoryEntry& entry);
    /// Copies a chunk from another package to photo `photo` of this package. The caller must check that the
    /// chunk is valid.
    void copy(const PackageReader& from, const package::DirectoryEntry& entry, std::uint32_t photo);
    /// Skips the chunks of an unusable photo. The range of these chunks stays empty, and takes no space if
    /// the file system supports holes.
    void skip(std::uint32_t photo);

    /// Reads back a sealed chunk without blocks. Throws Error(storage).
    std::vector<std::byte> read(package::Type type, std::uint32_t photo) const;
    /// XXH3-64 of the head of a chunk that was written, kept or copied. Throws std::logic_error for any other
    /// chunk.
    std::uint64_t checksum_of(package::Type type, std::uint32_t photo, std::uint32_t level = 0) const;
    /// The size in bytes of the finished package, or, before that, of its part.
    std::uint64_t size() const;
    /// Completes the package. Throws Error(storage) if writing fails, and std::logic_error if a planned chunk
    /// was not written, kept, copied or skipped.
    void finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// If a run was killed between packing and renaming, finishes its package; otherwise does nothing. Throws
/// Error(storage).
void publish_interrupted(const std::filesystem::path& file);

}  // namespace vantage
