#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scene/remote/cache/block_holds.h"
#include "scene/remote/cache/block_table.h"
#include "scene/remote/cache/blocks.h"
#include "scene/remote/cache/mapped_file.h"
#include "scene/remote/origin.h"

namespace vantage {

/// Keeps blocks from being freed as long as this object lives.
using Kept = std::shared_ptr<const void>;

/// The names of the files in the folder of a cached file.
namespace cached {
inline constexpr const char* origin = "origin";  ///< contains text_of(origin); marks the folder as ours
inline constexpr const char* table = "blocks";   ///< BlockTable
inline constexpr const char* data = "package.vantage";  ///< as large as the original; absent blocks are holes
}  // namespace cached

/// The first 64 KiB of the origin in a folder; empty if it is missing, a link or unreadable.
std::string origin_text(const std::filesystem::path& folder);

/// An open file in the cache. This object holds a shared lock (flock) on the data, so that no process deletes
/// the file. The file stays readable even if a newer version replaces it. Thread-safe.
class CachedFile : public std::enable_shared_from_this<CachedFile> {
  public:
    /// Opens the cached file in a folder. Returns null if there is none or if it is damaged. Throws
    /// Error(storage).
    static std::shared_ptr<CachedFile> open(const std::filesystem::path& folder);
    /// Creates a cached file in a folder that contains none of the files named in `cached`. Throws
    /// Error(storage).
    static std::shared_ptr<CachedFile> create(const std::filesystem::path& folder, const Origin& origin);
    ~CachedFile();

    const Origin& origin() const { return origin_; }
    const std::filesystem::path& path() const { return path_; }
    std::span<const std::byte> bytes() const { return {data_.data(), data_.size()}; }

    BlockTable& table() { return table_; }
    bool present(BlockRun run) const;
    /// Writes bytes and marks the blocks that are then complete. The bytes must start at the beginning of a
    /// block or where the last call ended. The blocks must be kept (see keep()). Throws Error(storage).
    void write(std::uint64_t offset, std::span<const std::byte> bytes);
    /// Keeps blocks, after waiting for any process that is freeing one of them. Throws Error(storage).
    Kept keep(std::vector<BlockRun> runs);
    /// Frees blocks that nobody keeps, least recently used first, until at least `bytes` are free on the disk
    /// or no such block is left. Returns the number of bytes freed. Throws Error(storage) if the file system
    /// does not support holes.
    std::uint64_t evict(std::uint64_t bytes);
    /// The number of bytes that the files use on the disk.
    std::uint64_t disk_bytes() const;

  private:
    CachedFile(std::filesystem::path folder, Origin origin, MappedFile data, BlockTable table);
    void note_use() const;
    std::vector<BlockRun> on_disk() const;
    bool free(std::uint64_t block);

    const std::filesystem::path folder_, path_;
    const Origin origin_;
    const MappedFile data_;
    BlockTable table_;
    BlockHolds holds_;
    std::mutex evicting_;  ///< on_disk() changes the file position
};

}  // namespace vantage
