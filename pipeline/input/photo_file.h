#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "pipeline/input/identity_cache.h"

namespace vantage {

/// The bytes of a photo's file, read when somebody asks for them.
class PhotoFile {
  public:
    /// Reads the file where the cache does not know it. Throws Error(input).
    PhotoFile(IdentityCache& identities, const std::filesystem::path& file);
    const FileIdentity& identity() const { return identity_; }
    /// Throws Error(input) where the file is gone, or another than it was.
    std::span<const std::byte> bytes();
    void release() { bytes_ = {}; }

  private:
    void read();

    IdentityCache& identities_;
    const std::filesystem::path& file_;
    std::vector<std::byte> bytes_;
    FileIdentity identity_;
};

}  // namespace vantage
