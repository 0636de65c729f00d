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

/// Where identities are remembered: $XDG_CACHE_HOME/vantage/identities, else below ~/.cache; empty where the
/// user has no home.
std::filesystem::path usual_identity_cache();

/// Identities of files, remembered between runs by what the file system says of them (device, number, length,
/// times of content and of metadata), so that a file that was not touched is not read again. Only a hint: a
/// lost or unwritable cache costs time and nothing else. Thread-safe.
class IdentityCache {
  public:
    /// With `rehash`, nothing remembered is believed.
    explicit IdentityCache(std::filesystem::path cache = usual_identity_cache(), bool rehash = false);
    /// Remembers what was learned.
    ~IdentityCache();
    IdentityCache(const IdentityCache&) = delete;
    IdentityCache& operator=(const IdentityCache&) = delete;

    /// From memory; nothing where the file is not known, or has been touched since.
    std::optional<FileIdentity> known(const std::filesystem::path& file) const;
    /// From memory, or by reading all of the file. Throws Error(input).
    FileIdentity of(const std::filesystem::path& file);
    /// The bytes of a file, of which the identity is remembered. Throws Error(input).
    std::pair<std::vector<std::byte>, FileIdentity> read(const std::filesystem::path& file);

  private:
    void learn(const std::filesystem::path& file, const std::string& stamp_before, FileIdentity id);

    std::filesystem::path cache_;
    bool rehash_;
    mutable std::mutex mutex_;
    std::map<std::string, FileIdentity> known_, learned_;
};

/// Of a photo's stencil; all 0 where it has none. Throws Error(input).
FileIdentity stencil_identity(const PhotoInput& photo, IdentityCache& identities);

}  // namespace vantage
