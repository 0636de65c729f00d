#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "base/files/descriptor.h"
#include "scene/remote/cache/cached_file.h"
#include "scene/remote/origin.h"

namespace vantage {

/// $XDG_CACHE_HOME/vantage/remote or, if XDG_CACHE_HOME is not set, ~/.cache/vantage/remote; empty if HOME is
/// not set either.
std::filesystem::path default_remote_cache();

/// The cached files, each in a folder named by the XXH3-128 of its URL. A lock serializes finding, creating
/// and deleting them across processes. Only folders that contain an `origin` written by this program are
/// modified, and in these folders only files with the names of cached files. The cache must be on a local
/// disk, and may be deleted at any time.
class CacheFolder {
  public:
    /// Creates the folder if it is missing. Throws Error(storage).
    explicit CacheFolder(std::filesystem::path root);

    /// The cached file of a URL that shown_url() returned, or null if there is none. Throws Error(storage).
    std::shared_ptr<CachedFile> find(const std::string& url) const;
    /// The cached file of this version. If this version is missing, any other version is deleted and a new
    /// file is created. Throws Error(storage).
    std::shared_ptr<CachedFile> find_or_make(const Origin& origin) const;
    /// Deletes files that no process has open, least recently used first, until all files together use at
    /// most `max_bytes` on the disk. Returns the space still used, which open files may keep above this
    /// limit.
    std::uint64_t prune(std::uint64_t max_bytes) const;

  private:
    Descriptor lock() const;
    std::filesystem::path folder_of(const std::string& url) const;

    const std::filesystem::path root_;
};

}  // namespace vantage
