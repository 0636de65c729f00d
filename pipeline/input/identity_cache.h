#pragma once
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/input/file_identity.h"
#include "pipeline/input/scene_input.h"

namespace vantage {

/// $XDG_CACHE_HOME/vantage/identities, otherwise ~/.cache/vantage/identities; empty if neither XDG_CACHE_HOME
/// nor HOME is set.
std::filesystem::path default_identity_cache();

/// File identities, cached between runs. Files are recognized by device, inode, length, mtime and ctime, so
/// an unmodified file is not read again. Losing the cache or failing to write it only costs time.
/// Thread-safe.
class IdentityCache {
  public:
    /// If `rehash` is set, identities cached by earlier runs are ignored. If the path is empty, nothing is
    /// cached between runs.
    explicit IdentityCache(std::filesystem::path cache = default_identity_cache(), bool rehash = false);
    /// Appends the new identities to the cache file.
    ~IdentityCache();
    IdentityCache(const IdentityCache&) = delete;
    IdentityCache& operator=(const IdentityCache&) = delete;

    /// The cached identity; empty if the file is not in the cache or has been modified since.
    std::optional<FileIdentity> known(const std::filesystem::path& file) const;
    /// The cached identity; if there is none, the file is read in full to compute it. Throws Error(input).
    FileIdentity of(const std::filesystem::path& file);
    /// Like of(), but empty if the file cannot be read.
    std::optional<FileIdentity> try_of(const std::filesystem::path& file);
    /// Reads a file and caches its identity. Throws Error(input).
    std::pair<std::vector<std::byte>, FileIdentity> read(const std::filesystem::path& file);

    /// Whether a package with this stamp was read in full and matched all its checksums.
    bool known_valid(const std::string& stamp) const;
    /// Records in the cache that the package is valid, under the same condition as for identities: the file
    /// still has this stamp, and any further modification would change it.
    void remember_valid(const std::filesystem::path& file, const std::string& stamp);

  private:
    /// Caches `id`, unless the file has changed since `stamp` was taken or could still change without
    /// changing its stamp.
    void add(const std::filesystem::path& file, const std::string& stamp, FileIdentity id);

    std::filesystem::path cache_;
    bool rehash_;
    mutable std::mutex mutex_;
    std::map<std::string, FileIdentity> stored_;  ///< identities cached by earlier runs, by stamp
    std::map<std::string, FileIdentity> added_;   ///< identities that are new in this run, by stamp
};

/// The identity of a photo's mask; all 0 if it has none. Throws Error(input).
FileIdentity mask_identity(const PhotoInput& photo, IdentityCache& identities);

}  // namespace vantage
