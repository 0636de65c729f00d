#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "base/files/descriptor.h"
#include "scene/remote/cache/cached_file.h"
#include "scene/remote/origin.h"

namespace vantage {

/// $XDG_CACHE_HOME/vantage/remote, else ~/.cache/vantage/remote; empty if neither XDG_CACHE_HOME nor HOME is
/// set.
std::filesystem::path default_remote_cache();

/// The cached files, each in a folder named by the XXH3-128 of its URL. A lock serializes finding, creating
/// and deleting them across processes. Only folders whose file `origin` is ours are modified, and in them
/// only files with the names of cached files. The cache must be on a local disk, and may be deleted at any
/// time.
class CacheFolder {
  public:
    /// Creates the folder if it is missing. Throws Error(storage).
    explicit CacheFolder(std::filesystem::path root);

    /// The cached file of a URL as returned by shown_url(), or null. Throws Error(storage).
    std::shared_ptr<CachedFile> find(const std::string& url) const;
    /// The cached file of this version, created if missing, after deleting any other version. Throws
    /// Error(storage).
    std::shared_ptr<CachedFile> find_or_make(const Origin& origin) const;
    /// Deletes the least recently used files that no process has open until all files use at most this many
    /// bytes on the disk. Returns the remaining usage, which open files may keep above the limit.
    std::uint64_t prune(std::uint64_t max_bytes) const;

  private:
    Descriptor lock() const;
    std::filesystem::path folder_of(const std::string& url) const;

    const std::filesystem::path root_;
};

}  // namespace vantage
