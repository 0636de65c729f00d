#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

#include "player/plan/tile_needs.h"
#include "player/stream/photo_block.h"
#include "player/stream/photo_pages.h"
#include "player/stream/residency.h"
#include "player/stream/tile_stream.h"

namespace vantage {

/// The photos as far as they are on the graphics card, and what is on its way there. A frame says what it
/// needs, streams or loads, and writes what shaders read. Belongs to the OpenGL thread.
class PhotoStore {
  public:
    PhotoStore(const PackageReader& package, std::uint64_t ring_bytes);

    /// Makes room for tiles in `bytes` of graphics memory; what was resident is gone where that changes.
    /// Throws Error(usage).
    void fit(std::uint64_t bytes, bool with_coordinates);
    std::uint64_t bytes() const { return residency_ ? residency_->layout().bytes() : 0; }
    bool has_coordinates() const { return residency_ && residency_->layout().coordinates > 0; }

    /// Begins a frame at `now` seconds; without `fade`, what arrives is there at once.
    void begin_frame(double now, bool fade);
    /// What lets a photo be shown at all: its thumbnail, its coarsest masks, and with `coordinates` those.
    void need_base(std::uint32_t photo, bool coordinates);
    /// Tiles. Returns how many of them are missing.
    std::size_t need(std::uint32_t photo, const TileNeeds& needs);
    /// The same, but after everything else, and not kept if there is no room.
    void foresee(std::uint32_t photo, const TileNeeds& needs);
    /// How many of these tiles are not resident.
    std::size_t missing(std::uint32_t photo, const TileNeeds& needs) const;
    void need_thumbnail(std::uint32_t photo);

    /// Uploads of what arrives at most `budget` bytes, or one piece that is larger, and asks for what this
    /// frame misses. Returns the bytes.
    std::size_t stream(std::size_t budget);
    /// Waits for all that was needed since the last call, or the frame began.
    void load();
    /// Uploads all of a photo in this frame, however long it takes. Returns the bytes.
    std::size_t load_whole(std::uint32_t photo);

    bool base_resident(std::uint32_t photo, bool coordinates) const;
    const PackagePages& pages() const { return pages_; }
    const Residency& residency() const { return *residency_; }
    std::uint64_t bytes_read() const { return stream_.bytes_read(); }
    std::size_t waiting() const { return stream_.waiting(); }
    std::size_t ring_bytes() const { return stream_.ring_bytes(); }

    /// Words that a photo's pages fill in a pass's table.
    std::size_t table_words(std::uint32_t photo) const;
    /// Writes them behind `next`, which moves on, and what of the photo's block depends on them.
    void write_pages(std::uint32_t photo, PhotoBlock& block, std::byte* table, std::uint32_t& next) const;
    void bind() const;

  private:
    void wish(const StreamRequest& request, int urgency);
    std::size_t need(std::uint32_t photo, const TileNeeds& needs, int urgency);

    const PackageReader* package_;
    std::span<const package::PhotoRecord> photos_;
    PackagePages pages_;
    TileStream stream_;
    std::unique_ptr<Residency> residency_;
    struct Wish {
        StreamRequest request;
        int urgency;
    };
    std::vector<Wish> wishes_;
    std::unordered_set<std::uint64_t> wished_;
    std::vector<StreamRequest> missing_, ordered_;
};

}  // namespace vantage
