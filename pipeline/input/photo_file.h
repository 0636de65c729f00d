#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "pipeline/input/identity_cache.h"

namespace vantage {

/// A photo's file: identified immediately, read on demand. `identities` and the path must outlive this
/// object.
class PhotoFile {
  public:
    /// Reads the file only if its identity is not cached. Throws Error(input).
    PhotoFile(IdentityCache& identities, const std::filesystem::path& file);
    const FileIdentity& identity() const { return identity_; }
    /// The whole file. Throws Error(input) if the file no longer exists or has changed.
    std::span<const std::byte> bytes();
    /// Frees the bytes; the identity stays.
    void release() { bytes_ = {}; }

  private:
    void read();

    IdentityCache& identities_;
    const std::filesystem::path& file_;
    std::vector<std::byte> bytes_;
    FileIdentity identity_;
};

}  // namespace vantage
