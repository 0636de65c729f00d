#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "scene/package_format.h"

namespace vantage {

/// What a chunk will be, before its bytes exist.
struct ChunkPlan {
    package::Type type;
    std::uint32_t photo = package::scene_wide;
    std::uint32_t level = 0;
    std::uint64_t bytes = 0;  ///< of the head, for a chunk without blocks
    std::uint64_t blocks = 0;
    std::uint64_t block_length = 0;
};

/// Writes a package whose layout is known before its contents: every chunk has its place, so photos may
/// finish in any order, from any thread, and the file is the same. The bytes go to FILE.part; finish() writes
/// the directory and the header, flushes, and renames. A writer that is dropped removes the .part file.
class PackageWriter {
  public:
    /// Throws Error(storage) when the file cannot be made or the disk has not the room.
    PackageWriter(const std::filesystem::path& file, std::span<const ChunkPlan> plan);
    ~PackageWriter();
    PackageWriter(const PackageWriter&) = delete;
    PackageWriter& operator=(const PackageWriter&) = delete;

    /// Chunks without blocks: exactly the planned bytes. Thread-safe. Throws Error(storage).
    void write(package::Type type, std::uint32_t photo, std::span<const std::byte> bytes);
    /// All blocks of a chunk: `fill` writes block `b` into its bytes, one after the other, so that no more
    /// than one is in memory. Thread-safe. Throws Error(storage).
    void write_blocks(package::Type type, std::uint32_t photo, std::uint32_t level,
                      const std::function<void(std::size_t b, std::span<std::byte> block)>& fill);

    std::uint64_t size() const;
    /// Throws std::logic_error when a planned chunk was never written.
    void finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& v) {
    return std::as_bytes(std::span<const T>(v));
}

}  // namespace vantage
