#pragma once
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "scene/remote/cache/blocks.h"
#include "scene/remote/cache/mapped_file.h"

namespace vantage {

/// Which blocks of a cached file are present, and when they were last used. It is a mapped file that all
/// processes with the cached file share: a header of 32 bytes, then a u32 per block, little-endian; 0:
/// absent, otherwise the tick of the last use. A mark is set after the block was written, so that a process
/// that is killed never leaves a mark without data; after a power cut there may be one. Thread-safe.
class BlockTable {
  public:
    /// `origin`: hash of the text of the origin, which ties the two files of a cached file together.
    /// Nothing if the file is missing or does not fit. Throws Error(storage).
    static std::optional<BlockTable> open(const std::filesystem::path& path, std::uint64_t blocks,
                                          std::uint64_t origin);
    /// All blocks absent. Throws Error(storage) if the file exists or the disk is full.
    static BlockTable create(const std::filesystem::path& path, std::uint64_t blocks, std::uint64_t origin);

    bool present(std::uint64_t block) const { return last_use(block) != 0; }
    /// In ticks; 0 if the block is absent.
    std::uint32_t last_use(std::uint64_t block) const;
    /// The time of a new use, at least 1. Ticks wrap after 2^32 uses; the order is then wrong for a while.
    std::uint32_t tick();
    void mark(std::uint64_t block, std::uint32_t tick);
    /// The same for blocks that are present only.
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
