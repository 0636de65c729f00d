#pragma once
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "scene/remote/cache/blocks.h"
#include "scene/remote/cache/mapped_file.h"

namespace vantage {

/// Records which blocks of a cached file are present and when they were last used. The table is a mapped file
/// that all processes that use the cached file share. The table consists of a header of 32 bytes and a
/// little-endian u32 for each block, which is 0 if the block is absent, otherwise the tick of its last use. A
/// block is marked after it is written, so that a killed process never leaves a mark without data; a power
/// cut may. Thread-safe.
class BlockTable {
  public:
    /// Opens a table; the result is empty if the file is missing or does not match. `origin`: a hash of the
    /// origin's text, which identifies the table that belongs to the cached file. Throws Error(storage).
    static std::optional<BlockTable> open(const std::filesystem::path& path, std::uint64_t blocks,
                                          std::uint64_t origin);
    /// Creates a table in which all blocks are absent. Throws Error(storage) if the file exists or the disk
    /// is full.
    static BlockTable create(const std::filesystem::path& path, std::uint64_t blocks, std::uint64_t origin);

    bool present(std::uint64_t block) const { return last_use(block) != 0; }
    /// The tick of the block's last use; 0 if the block is absent.
    std::uint32_t last_use(std::uint64_t block) const;
    /// The tick for a new use; at least 1. Ticks wrap around after 2^32 uses; the order is then wrong for a
    /// while.
    std::uint32_t tick();
    void mark(std::uint64_t block, std::uint32_t tick);
    /// Marks the block with this tick, but only if the block is present.
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
