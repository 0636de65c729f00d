#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "gl/object.h"
#include "scene/package_reader.h"

namespace vantage {

/// Texture coordinates of the photos in use, a slot of vertices a photo, in one buffer; the slot least
/// recently used gives way.
class CoordinateSlots {
  public:
    /// As many slots as 96 MiB hold, at least `least`, at most one a photo.
    CoordinateSlots(std::uint32_t vertex_count, std::uint32_t photos, std::uint32_t least);

    /// The slots of these photos (at most `least` of them), filled from the package. Throws Error(damaged).
    std::vector<std::uint32_t> require(const PackageReader& package,
                                       const std::vector<std::uint32_t>& photos);
    GLuint buffer() const { return buffer_.id(); }

  private:
    struct Slot {
        std::optional<std::uint32_t> photo;
        std::uint64_t used = 0;
    };
    std::uint32_t slot_for(const PackageReader& package, std::uint32_t photo);

    std::uint32_t vertex_count_;
    std::vector<Slot> slots_;
    gl::Buffer buffer_;
    std::uint64_t request_ = 0;
};

}  // namespace vantage
