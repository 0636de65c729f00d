#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "gl/object.h"
#include "player/stream/layer_pool.h"
#include "player/stream/photo_pages.h"
#include "player/stream/tile_stream.h"

namespace vantage {

/// How many of each resource the graphics card holds.
struct ResidencyLayout {
    std::uint32_t color = 0, masks = 0, thumbnails = 0;  ///< layers of the array textures
    std::uint32_t coordinates = 0;                       ///< photos whose vertices' coordinates are held
    int thumbnail_width = 1, thumbnail_height = 1;
    std::uint32_t vertices = 0;

    std::uint64_t bytes() const;
    bool operator==(const ResidencyLayout&) const = default;
};

/// What `bytes` of graphics memory hold of a package: thumbnails and coordinates (`with_coordinates`) first,
/// then tiles; no more than there is. Throws Error(usage) where not even a few tiles have room.
ResidencyLayout fit_residency(const PackageReader& package, const PackagePages& pages, std::uint64_t bytes,
                              bool with_coordinates);

/// Tiles, thumbnails and texture coordinates on the graphics card; the least recently used give way, and what
/// the current frame uses never does. Belongs to the OpenGL thread.
class Residency {
  public:
    /// What was damaged is not looked at again for so long.
    static constexpr double retry_seconds = 5;

    Residency(const PackageReader& package, const PackagePages& pages, const ResidencyLayout& layout);

    /// Begins a frame at `now` seconds; without `fade`, what arrives is there at once.
    void begin_frame(double now, bool fade);
    /// Marks a resource as used in this frame. Where it is not resident (nor lately damaged), it is appended
    /// to `missing` and false returned.
    bool need(const StreamRequest& request, std::vector<StreamRequest>& missing);
    /// The same for all of a photo's texture coordinates.
    bool need_coordinates(std::uint32_t photo, std::vector<StreamRequest>& missing);
    /// Uploads what is fetched, at most `budget` bytes, or one piece that is larger. Returns the bytes
    /// uploaded.
    std::size_t upload(TileStream& stream, std::size_t budget);
    /// Uploads at once all that a photo has, straight from the mapped package. Returns the bytes uploaded.
    std::size_t upload_whole(std::uint32_t photo, std::uint32_t levels);

    /// For shaders: the layer and, above it, how far it has faded in (0 to 255); not resident: 2^32 - 1.
    std::uint32_t color_entry(std::uint32_t page) const { return entry(color_pool_, color_births_, page); }
    std::uint32_t mask_entry(std::uint32_t page) const { return entry(mask_pool_, mask_births_, page); }
    std::optional<std::uint32_t> thumbnail_layer(std::uint32_t photo) const {
        return thumbnail_pool_.layer_of(photo);
    }
    std::optional<std::uint32_t> coordinate_slot(std::uint32_t photo) const;
    bool holds(const StreamRequest& request) const;
    /// How many more resources of a sort this frame can hold.
    std::uint32_t room(Resource resource) const { return pool_of(resource).room(frame_); }
    bool damaged(const StreamRequest& r) const { return damaged_.contains(r.identity()); }
    std::size_t damaged_count() const { return damaged_.size(); }
    /// Nothing is fading in.
    bool settled() const { return now_ < last_birth_ || now_ >= last_birth_ + fade_seconds; }

    const ResidencyLayout& layout() const { return layout_; }
    std::uint32_t color_held() const { return color_pool_.held(); }
    std::uint32_t masks_held() const { return mask_pool_.held(); }
    GLuint colors() const { return color_.id(); }
    GLuint masks() const { return masks_.id(); }
    GLuint depths() const { return depths_.id(); }
    GLuint thumbnails() const { return thumbnails_.id(); }
    GLuint coordinates() const { return coordinates_.id(); }

  private:
    static constexpr double fade_seconds = 0.25;
    const LayerPool& pool_of(Resource resource) const;
    /// Damaged, and too lately to look again: a package may be restored while it is shown.
    bool given_up(const StreamRequest& request) const;
    /// A restored piece of texture coordinates answers for its chunk: its others came while that was damaged.
    void doubt(const StreamRequest& restored);
    std::uint32_t entry(const LayerPool& pool, const std::vector<double>& births, std::uint32_t page) const;
    /// Copies from the unpack buffer at `source`, or from memory there where there is none. False where
    /// nothing can give way.
    bool store(const StreamRequest& request, std::uintptr_t source, GLuint unpack_buffer);

    const PackageReader* package_;
    ResidencyLayout layout_;
    const PackagePages* pages_;
    LayerPool color_pool_, mask_pool_, thumbnail_pool_, slot_pool_;
    std::vector<double> color_births_, mask_births_;
    gl::Texture color_, masks_, depths_, thumbnails_;
    gl::Buffer coordinates_;
    struct Slot {
        std::uint32_t photo = 0xffffffffu;
        std::vector<bool> arrived;  ///< which pieces
        std::uint32_t missing = 0;
    };
    std::vector<Slot> slots_;
    std::unordered_map<std::uint64_t, double> damaged_;  ///< by identity: when last found so; while needed
    std::uint64_t frame_ = 0;
    double now_ = 0, last_birth_ = -1e9;
    bool fades_ = true;
};

}  // namespace vantage
