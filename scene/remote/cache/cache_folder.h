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

/// The cached files, each in a folder named by the XXH3-128 of its URL. A lock serializes what finds, makes
/// and deletes them, in all processes. Only folders whose file `origin` is ours are touched, and in them only
/// files of the names of cached files. The cache must be on a local disk, and may be deleted at any time.
class CacheFolder {
  public:
    /// Makes the folder if it is missing. Throws Error(storage).
    explicit CacheFolder(std::filesystem::path root);

    /// The cached file of a URL as shown_url() gives it, or null. Throws Error(storage).
    std::shared_ptr<CachedFile> find(const std::string& url) const;
    /// The cached file of this version, which is made if there is none, after another version was dropped.
    /// Throws Error(storage).
    std::shared_ptr<CachedFile> find_or_make(const Origin& origin) const;
    /// Deletes the least recently used files that no process has open until all take at most this many bytes
    /// of the disk. Returns what they take then; files that are open may exceed it.
    std::uint64_t prune(std::uint64_t max_bytes) const;

  private:
    Descriptor lock() const;
    std::filesystem::path folder_of(const std::string& url) const;

    const std::filesystem::path root_;
};

}  // namespace vantage
