#pragma once
#include <cstdint>
#include <list>
#include <span>
#include <unordered_map>
#include <vector>

#include "gl/object.h"
#include "scene/package_reader.h"

namespace vantage {

/// A tile of the package: chunk and index in it; `page` is its place in the page table.
struct TileRequest {
    const package::DirectoryEntry* chunk;
    std::uint32_t tile;
    std::uint32_t page;
};

/// Tiles of all photos in the layers of one array texture, least recently used first to go, and the page
/// table that tells shaders which layer holds which tile. Uploads go straight from the mapped package.
/// Belongs to the OpenGL thread.
class TileCache {
  public:
    /// `format` is the texture's, `layout` and `type` the package's texels. `layers` is cut to what the card
    /// allows.
    TileCache(const char* label, GLenum format, GLenum layout, GLenum type, int layers, std::uint32_t pages,
              GLenum filter);

    /// Makes the tiles resident, in order, uploading at most `budget`; tiles of this request are not evicted
    /// for each other. A tile whose checksum is wrong stays out. Returns how many are missing afterwards.
    std::size_t require(const PackageReader& package, std::span<const TileRequest> tiles, std::size_t budget);

    GLuint texture() const { return texture_.id(); }
    /// Brings the page table on the card up to date.
    const gl::Buffer& page_table();
    std::size_t resident() const { return by_page_.size(); }
    std::size_t layers() const { return layers_; }
    std::size_t uploaded() const { return uploaded_; }
    std::size_t damaged() const { return damaged_.size(); }

  private:
    struct Resident {
        std::uint32_t page, layer;
        std::uint64_t used;
    };
    bool upload(const PackageReader& package, const TileRequest& tile);

    gl::Texture texture_;
    gl::Buffer table_;
    GLenum layout_, type_;
    std::size_t layers_;
    std::vector<std::uint32_t> pages_;
    bool pages_changed_ = true;
    std::list<Resident> residents_;  ///< least recently used first
    std::unordered_map<std::uint32_t, std::list<Resident>::iterator> by_page_;
    std::unordered_map<std::uint32_t, bool> damaged_;
    std::uint64_t request_ = 0;
    std::size_t uploaded_ = 0;
};

}  // namespace vantage
