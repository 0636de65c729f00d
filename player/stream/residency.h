#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "base/gl/object.h"
#include "player/stream/layer_pool.h"
#include "player/stream/photo_pages.h"
#include "player/stream/tile_array.h"
#include "player/stream/tile_stream.h"

namespace vantage {

/// The capacity of graphics memory for each kind of resource.
struct ResidencyLayout {
    std::uint32_t color = 0, weight_maps = 0, thumbnails = 0;  ///< layers of the array textures
    std::uint32_t coordinates = 0;                             ///< photos with texture coordinates per vertex
    int thumbnail_width = 1, thumbnail_height = 1;
    std::uint32_t vertices = 0;

    std::uint64_t bytes() const;
    bool operator==(const ResidencyLayout&) const = default;
};

/// The maximum number of layers of an array texture.
std::uint32_t max_layers();

/// Divides `bytes` of graphics memory: thumbnails and coordinates (if `with_coordinates`) get at most an
/// eighth each, and tiles the rest. Never makes space for more than the package has, nor for fewer than 16
/// tiles of color and 16 of weight maps, even if these do not fit.
ResidencyLayout fit_residency(const PackageReader& package, const PackagePages& pages, std::uint64_t bytes,
                              bool with_coordinates);

/// Keeps tiles, thumbnails and texture coordinates in graphics memory. Evicts the least recently used of
/// these, but never those that the current frame uses. Must be used on the OpenGL thread.
class Residency {
  public:
    /// The delay before damaged or undelivered resources are fetched again.
    static constexpr double retry_seconds = 5;
    struct Failure {
        double at;     ///< time of the last failure, seconds
        bool damaged;  ///< if false, the resource could not be fetched
    };

    Residency(const PackageReader& package, const PackagePages& pages, const ResidencyLayout& layout);

    /// Enlarges the arrays to this many layers, or to their maximum.
    void expect(std::uint32_t color, std::uint32_t weight_maps);
    /// Begins a frame at `now` seconds; without `fade`, tiles are shown at full weight as soon as they
    /// arrive.
    void begin_frame(double now, bool fade);
    /// Marks a resource as used in this frame. If it is not resident, returns false and appends it to
    /// `missing` unless it was damaged recently.
    bool need(const StreamRequest& request, std::vector<StreamRequest>& missing);
    /// Like need(), but for all of a photo's texture coordinates.
    bool need_coordinates(std::uint32_t photo, std::vector<StreamRequest>& missing);
    /// Uploads fetched data, at most `budget` bytes or one larger piece. Returns the number of bytes
    /// uploaded.
    std::size_t upload(TileStream& stream, std::size_t budget);
    /// Evicts all weight maps and depth.
    void evict_weight_maps();
    /// Uploads all tiles of a photo at once, directly from the mapped package. Returns the number of bytes
    /// uploaded.
    std::size_t upload_whole(std::uint32_t photo, std::uint32_t levels);

    /// A page's entry for the shaders: the layer in the low 16 bits, and above them how far the page has
    /// faded in (0 to 255); or shader::not_resident.
    std::uint32_t color_entry(std::uint32_t page, bool fades) const {
        return entry(color_pool_, color_arrivals_, page, fades);
    }
    std::uint32_t weight_map_entry(std::uint32_t page) const {
        return entry(weight_map_pool_, weight_map_arrivals_, page, true);
    }
    std::optional<std::uint32_t> thumbnail_layer(std::uint32_t photo) const {
        return thumbnail_pool_.layer_of(photo);
    }
    std::optional<std::uint32_t> coordinate_slot(std::uint32_t photo) const;
    bool holds(const StreamRequest& request) const;
    /// Whether a photo's texture coordinates are resident or in flight.
    bool has_slot(std::uint32_t photo) const { return slot_pool_.layer_of(photo).has_value(); }
    /// The number of additional resources of a kind that this frame can hold.
    std::uint32_t available(Resource resource) const { return pool_of(resource).available(frame_); }
    /// Whether a resource was damaged or could not be fetched.
    bool failed(const StreamRequest& r) const { return failed_.contains(r.identity()); }
    std::size_t damaged_count() const;
    /// Resources that could not be fetched recently.
    std::size_t absent_count() const { return failed_.size() - damaged_count(); }
    /// Whether no tile is fading in.
    bool settled() const { return !fades_ || now_ < last_arrival_ || now_ >= last_arrival_ + fade_seconds; }

    const ResidencyLayout& layout() const { return layout_; }
    /// The graphics memory held, in bytes: less than layout().bytes() until many tiles have arrived.
    std::uint64_t bytes() const;
    std::uint32_t color_held() const { return color_pool_.held(); }
    std::uint32_t weight_maps_held() const { return weight_map_pool_.held(); }
    GLuint colors() const { return color_.id(); }
    GLuint weight_maps() const { return weight_maps_.id(); }
    GLuint depths() const { return depths_.id(); }
    GLuint thumbnails() const { return thumbnails_.id(); }
    GLuint coordinates() const { return coordinates_.id(); }

  private:
    static constexpr double fade_seconds = 0.25;
    const LayerPool& pool_of(Resource resource) const;
    /// Whether the request failed within the last retry_seconds. After that time it is fetched again, since
    /// the package or the network may have been restored.
    bool recently_failed(const StreamRequest& request) const;
    /// Fetches all pieces of a photo's texture coordinates again after one was restored: pieces share a
    /// checksum, and the others may have arrived while the checksum did not match.
    void discard_coordinates(const StreamRequest& restored);
    std::uint32_t entry(const LayerPool& pool, const std::vector<double>& arrivals, std::uint32_t page,
                        bool fades) const;
    /// Copies from offset `source` of the unpack buffer, or from address `source` if no buffer is bound.
    /// Returns false if no layer can be evicted.
    bool store(const StreamRequest& request, std::uintptr_t source, GLuint unpack_buffer);

    const PackageReader* package_;
    ResidencyLayout layout_;
    const PackagePages* pages_;
    LayerPool color_pool_, weight_map_pool_, thumbnail_pool_, slot_pool_;
    std::vector<double> color_arrivals_, weight_map_arrivals_;  ///< per layer, seconds
    TileArray color_, weight_maps_, depths_;
    gl::Texture thumbnails_;
    gl::Buffer coordinates_;
    struct Slot {
        std::uint32_t photo = 0xffffffffu;
        std::vector<bool> arrived;  ///< per piece
        std::uint32_t missing = 0;
    };
    std::vector<Slot> slots_;

    std::unordered_map<std::uint64_t, Failure> failed_;  ///< by identity
    std::uint64_t frame_ = 0;
    double now_ = 0, last_arrival_ = -1e9;
    bool fades_ = true;
};

}  // namespace vantage
