#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>

namespace vantage {

/// Keeps bytes of a package readable as long as this object lives.
using Held = std::shared_ptr<const void>;

/// Traffic with a server since a package was opened.
struct SourceTraffic {
    std::uint64_t bytes_received = 0, bytes_from_cache = 0;
    double bytes_per_second = 0;  ///< rate of reception over the last two seconds
    bool offline = false;         ///< the server cannot be reached; only cached data can be shown
};

/// The source of a package's bytes. The bytes are mapped, but if the package is on a server, they must be
/// fetched before they are read. Thread-safe.
class PackageSource {
  public:
    using Part = std::span<const std::byte>;  ///< a range of bytes()

    virtual ~PackageSource() = default;
    /// The name in messages: a path or a URL.
    virtual const std::filesystem::path& name() const = 0;
    virtual Part bytes() const = 0;
    /// The descriptor of a file with these bytes, for copying; -1 if no file has all of them.
    virtual int descriptor() const = 0;
    /// Waits until all parts are readable. Returns null when stopped. Throws Error(input) if the bytes cannot
    /// be fetched, and Error(storage) if the cache cannot be used.
    virtual Held hold(std::span<const Part> parts, std::stop_token stop) = 0;
    /// Discards fetched bytes that do not match a checksum, so that hold() fetches them again. Returns false
    /// if there is no other copy.
    virtual bool discard(std::span<const Part> parts) = 0;
    /// Traffic with the server; empty for a file.
    virtual std::optional<SourceTraffic> traffic() const = 0;
};

}  // namespace vantage
