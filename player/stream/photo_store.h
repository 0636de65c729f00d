#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <memory_resource>
#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

#include "player/plan/selection/tile_needs.h"
#include "player/stream/photo_block.h"
#include "player/stream/photo_pages.h"
#include "player/stream/residency.h"
#include "player/stream/tile_stream.h"

namespace vantage {

/// The parts of the photos that are resident or in flight. In each frame, call begin_frame(), request the
/// needed parts, call stream() or load(), and then write_pages() for the shaders. Must be used on the OpenGL
/// thread.
class PhotoStore {
  public:
    PhotoStore(const PackageReader& package, std::uint64_t ring_bytes);

    /// Allocates at most `bytes` of graphics memory. Keeps the current allocation if it is at most `bytes`
    /// and more than half the size of a new one. Otherwise, evicts everything. Throws Error(usage) if `bytes`
    /// is insufficient.
    void fit(std::uint64_t bytes, bool with_coordinates);
    /// Makes space for this many tiles at once. If the arrays' limits are lower, raises them and evicts
    /// everything. Leaves the limits unchanged if all arrays together would otherwise exceed `bytes`.
    void make_room(std::uint32_t color, std::uint32_t weight_maps, std::uint64_t bytes);
    std::uint64_t bytes() const { return residency_ ? residency_->bytes() : 0; }
    bool has_coordinates() const { return residency_ && residency_->layout().coordinates > 0; }

    /// Replaces the stored transient weights in the weight maps: `weights` returns a photo's map (see
    /// set_weights). The function is called when a tile of the photo's weight maps is about to be fetched,
    /// and must remain valid. An empty function restores the stored weights. Evicts all weight maps. Nothing
    /// may be in flight.
    void use_weights(std::function<const TransientMap*(std::uint32_t photo)> weights);

    /// Begins a frame at `now` seconds; without `fade`, tiles are shown at full weight as soon as they
    /// arrive.
    void begin_frame(double now, bool fade);
    /// Requests the minimum for drawing a photo: color of its base level, coarsest weight maps, and, if
    /// `coordinates` is set, texture coordinates.
    void need_base(std::uint32_t photo, bool coordinates);
    /// Requests tiles. Returns the number of these parts that are not resident, not counting damaged parts.
    std::size_t need(std::uint32_t photo, const TileNeeds& needs);
    /// Like need(), but with the lowest priority and only while there is space.
    void prefetch(std::uint32_t photo, const TileNeeds& needs);
    /// The number of these tiles that are not resident.
    std::size_t missing(std::uint32_t photo, const TileNeeds& needs) const;
    void need_thumbnail(std::uint32_t photo);

    /// Uploads at most `budget` bytes of fetched data, or one larger piece, and fetches this frame's
    /// requests. Returns the number of bytes uploaded.
    std::size_t stream(std::size_t budget);
    /// Like stream(), but waits for the requests until the budget is used up.
    std::size_t await(std::size_t budget);
    /// The number of resources that the picture needs and that are being fetched.
    std::size_t to_come() const { return to_come_; }
    /// Fetches and uploads everything requested since the last call or the start of the frame. Waits. Throws
    /// Error(input) if a server does not deliver the data.
    void load();
    /// Like load(), but uploads at most `budget` bytes. Returns the number of bytes uploaded.
    std::size_t load(std::size_t budget);
    /// Uploads a complete photo in this frame, without a time limit. Returns the number of bytes uploaded.
    std::size_t load_whole(std::uint32_t photo);

    bool base_resident(std::uint32_t photo, bool coordinates) const;
    const PackagePages& pages() const { return pages_; }
    const Residency& residency() const { return *residency_; }
    StreamedSoFar streamed() const { return stream_.streamed(); }
    std::size_t waiting() const { return stream_.waiting(); }
    /// The reason why a server recently failed to deliver requested data; empty if it did not fail.
    std::string failure() const {
        return residency_ && residency_->absent_count() > 0 ? stream_.failure() : std::string();
    }
    std::size_t ring_bytes() const { return stream_.ring_bytes(); }

    /// The size of a photo's page table, in 32-bit words.
    std::size_t table_words(std::uint32_t photo) const;
    /// Writes the page table at word `next`, advances `next`, and sets the fields of `block` that depend on
    /// it.
    void write_pages(std::uint32_t photo, PhotoBlock& block, std::byte* table, std::uint32_t& next) const;
    void bind() const;

  private:
    /// Urgency of a missing piece, in increasing order.
    enum class Urgency {
        prefetch,     ///< needed for future frames
        panel,        ///< thumbnails that only panels show
        tile,         ///< coarse levels before fine ones
        coordinates,  ///< required to draw a photo with coordinates per vertex
        base,         ///< required to draw a photo at all
    };
    struct Wanted {
        StreamRequest request;
        Urgency urgency;
        std::uint32_t level;   ///< of a tile
        std::uint32_t number;  ///< position in the order of the requests
    };
    void enlarge(std::uint32_t color, std::uint32_t weight_maps, std::uint64_t bytes);
    void want(StreamRequest request, Urgency urgency, std::uint32_t level = 0);
    std::size_t want(std::uint32_t photo, const TileNeeds& needs, Urgency urgency);
    /// Sorts wanted_ by urgency, then by level (coarse before fine), then in the order of the requests.
    void sort_wanted();

    const PackageReader* package_;
    std::span<const package::PhotoRecord> photos_;
    PackagePages pages_;
    std::size_t largest_piece_;
    TileStream stream_;
    std::unique_ptr<Residency> residency_;
    std::function<const TransientMap*(std::uint32_t photo)> weights_;
    std::vector<Wanted> wanted_;                         ///< not resident
    std::pmr::unsynchronized_pool_resource identities_;  ///< memory reused between frames
    std::pmr::unordered_set<std::uint64_t> wanted_identities_{&identities_};
    std::vector<StreamRequest> missing_, ordered_;
    std::size_t to_come_ = 0;
};

}  // namespace vantage
