#pragma once
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "scene/remote/cache/blocks.h"
#include "scene/remote/cache/mapped_file.h"

namespace vantage {

/// Records which blocks of a cached file are present, and when they were last used, in a mapped file shared
/// by all processes that use the cached file: a header of 32 bytes, then a little-endian u32 per block, 0 if
/// absent, otherwise the tick of the last use. A mark is set after its block is written, so that a killed
/// process never leaves a mark without data; a power cut may. Thread-safe.
class BlockTable {
  public:
    /// `origin`: hash of the origin's text, which links the two files of a cached file. Empty if the file is
    /// missing or does not match. Throws Error(storage).
    static std::optional<BlockTable> open(const std::filesystem::path& path, std::uint64_t blocks,
                                          std::uint64_t origin);
    /// Creates a table with all blocks absent. Throws Error(storage) if the file exists or the disk is full.
    static BlockTable create(const std::filesystem::path& path, std::uint64_t blocks, std::uint64_t origin);

    bool present(std::uint64_t block) const { return last_use(block) != 0; }
    /// Tick of the last use; 0 if the block is absent.
    std::uint32_t last_use(std::uint64_t block) const;
    /// The tick of a new use, at least 1. Ticks wrap after 2^32 uses, which makes the order wrong for a
    /// while.
    std::uint32_t tick();
    void mark(std::uint64_t block, std::uint32_t tick);
    /// Marks the block with this tick, but only if it is present.
    void touch(std::uint64_t block, std::uint32_t tick);
    void clear(std::uint64_t block) { mark(block, 0); }
    std::uint64_t blocks() const { return blocks_; }
    const MappedFile& file() const { return file_; }

  private:
    BlockTable(MappedFile file, std::uint64_t blocks) : file_(std::move(file)), blocks_(blocks) {}
    std::atomic_ref<std::uint32_t> mark_of(std::uint64_t block) const;

    MappedFile file_;
    std::uint64_t blocks_;
};

}  // namespace vantage
