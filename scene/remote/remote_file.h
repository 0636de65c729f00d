#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>

#include "scene/remote/byte_range.h"

namespace vantage {

struct RemoteOptions {
    /// A folder on a local disk. If empty, default_remote_cache() is used: $XDG_CACHE_HOME/vantage/remote or
    /// ~/.cache/vantage/remote.
    std::filesystem::path cache{};
    std::uint64_t cache_bytes = std::uint64_t(4) << 30;  ///< limit on all cached files on the disk
    std::chrono::milliseconds connect_timeout{10'000};
    std::chrono::seconds stall_timeout{20};  ///< maximum time with fewer than 256 bytes per second
    /// The pause before the second try. The pause before the third try is four times as long.
    std::chrono::milliseconds retry_pause{250};
    int max_requests = 6;  ///< requests in flight at once, 1 to 64; each buffers 64 KiB of its body
    std::uint64_t first_bytes = 256 << 10;  ///< fetched on opening; rounded up to 64 KiB, at most 64 MiB
    std::filesystem::path certificates{};   ///< PEM file of trusted authorities; empty: the system's file
};

/// Traffic since the file was opened.
struct Traffic {
    std::uint64_t bytes_received = 0;    ///< bytes of response bodies
    std::uint64_t requests = 0;          ///< each try counts
    std::uint64_t bytes_from_cache = 0;  ///< whole blocks that were in the cache when first requested
    double bytes_per_second = 0;         ///< rate of reception over the last two seconds
};

/// A file on a server, read with HTTP range requests. The file is cached in a sparse file of the same size,
/// which is mapped. Ranges are fetched into the sparse file before they are read; bytes that have not been
/// fetched read as zero. All sizes are in bytes. Blocks are 64 KiB, and ranges are fetched in whole blocks.
///
/// The size of the cache is limited. When the limit is exceeded, files that no process has open are deleted.
/// Then blocks of this file are freed, least recently fetched first, and read as zero again. Blocks are not
/// freed while any process fetches them or keeps them with keep(), and the blocks fetched on opening are
/// never freed. If these blocks alone exceed the limit, so does the cache. Callers that read bytes without
/// keeping them must verify the bytes, and fetch them again if necessary.
///
/// RemoteFile is thread-safe, but must outlive all calls to it. Several processes may open the same file.
/// Server and network errors are reported as Error(input), and cache errors as Error(storage). Messages are
/// one line long.
class RemoteFile {
  public:
    /// Opens the file with one request, for the first bytes. A cached copy is used if it is current according
    /// to the server's ETag or Last-Modified; otherwise it is dropped. If the server cannot be reached, the
    /// cached copy is used unchecked (see offline()). Throws Error(input) if the server does not support
    /// ranges, if it has no such file, or if it cannot be reached and there is no cached copy. Throws
    /// Error(storage) if the cache cannot be used, and Error(interrupted) when stopped.
    explicit RemoteFile(std::string_view url, const RemoteOptions& options = {}, std::stop_token stop = {});
    ~RemoteFile();
    RemoteFile(RemoteFile&&) noexcept;
    RemoteFile& operator=(RemoteFile&&) noexcept;

    /// The URL without the user name and password.
    const std::string& url() const;
    std::uint64_t size() const;
    /// The mapped file, valid as long as this object lives.
    std::span<const std::byte> bytes() const&;
    std::span<const std::byte> bytes() const&& = delete;
    /// The path of the sparse file.
    const std::filesystem::path& path() const;
    /// True if the file was opened from the cache and the server has not been reached since.
    bool offline() const;

    /// Waits until all ranges are present. Ranges that another thread is fetching are not requested again.
    /// Returns false when stopped; requests that nobody else waits for are then canceled. A call for many
    /// bytes does not block other calls: their requests are interleaved in the order in which they are
    /// needed. Throws Error(input) if three tries fail or the file has changed on the server, Error(storage)
    /// if the cache cannot be used, and Error(internal) if a range extends beyond the file.
    [[nodiscard]] bool fetch(std::span<const ByteRange> ranges, std::stop_token stop = {});
    /// True if all bytes of the range have been fetched and have not been freed since.
    bool present(ByteRange range) const;
    /// Discards bytes that do not match a checksum, so that the next fetch() replaces them in place. Other
    /// bytes in the same blocks are discarded as well.
    void discard(ByteRange range);
    /// Prevents the blocks of these ranges from being freed as long as the result lives. Ranges must be kept
    /// first and then fetched. The result may outlive this object. Throws Error(storage).
    [[nodiscard]] std::shared_ptr<const void> keep(std::span<const ByteRange> ranges);

    Traffic traffic() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace vantage
