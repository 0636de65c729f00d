#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "base/gl/object.h"
#include "player/stream/layer_pool.h"
#include "player/stream/residency.h"
#include "player/stream/tile_stream.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {

/// Keeps blocks of a cloud's points in graphics memory. Evicts the least recently used blocks, but never
/// those that the current frame uses. Must be used on the OpenGL thread.
class PointStore {
  public:
    /// The maximum graphics memory for points, and the maximum for the upload buffer.
    static constexpr std::uint64_t max_bytes = std::uint64_t(256) << 20, ring_bytes = std::uint64_t(4) << 20;

    /// Uses `bytes` of graphics memory for points, but at least two blocks.
    PointStore(const PackageReader& package, const PointCloud& cloud, std::uint64_t bytes = max_bytes);

    /// Begins a frame at `now` seconds.
    void begin_frame(double now);
    /// Marks the node's block as used in this frame, and requests it if it is not resident. Returns whether
    /// the block is resident.
    bool need(const package::PointNode& node);
    bool resident(const package::PointNode& node) const { return pool_.layer_of(node.block).has_value(); }
    /// Whether the node's block is pending: it is neither resident nor damaged, and there is space for it.
    bool awaits(const package::PointNode& node) const {
        return !resident(node) && !failed_.contains(node.block) && pool_.available(frame_) > 0;
    }
    /// Uploads fetched data, at most `budget` bytes or one block. Returns the number of bytes uploaded.
    std::size_t stream(std::size_t budget);
    /// Waits for all requested blocks that fit. Throws Error(input) if a server does not deliver the blocks.
    void load();

    /// The index of the node's first point in buffer().
    std::uint32_t first_point(const package::PointNode& node) const {
        return *pool_.layer_of(node.block) * package::point_block + node.first;
    }
    /// The buffer of points, which stream() or load() may replace with a larger one.
    GLuint buffer() const { return points_.id(); }
    /// Graphics memory by which the buffer may still grow, in bytes.
    std::uint64_t growth() const;
    std::size_t damaged() const;
    std::size_t absent() const { return failed_.size() - damaged(); }
    /// The reason why a server recently failed to deliver requested data; empty if it did not fail.
    std::string failure() const { return absent() > 0 ? stream_.failure() : std::string(); }

  private:
    bool place(const Fetched& fetched);
    void grow(std::uint32_t layers);

    const package::DirectoryEntry* chunk_;
    LayerPool pool_;
    std::uint32_t capacity_;  ///< layers of the pool for which the buffer has space
    gl::Buffer points_;
    std::vector<StreamRequest> missing_;
    std::vector<bool> requested_;  ///< one per block: whether it was requested in this frame
    std::unordered_map<std::uint32_t, Residency::Failure> failed_;  ///< by block
    std::uint64_t frame_ = 0;
    double now_ = 0;
    TileStream stream_;  ///< declared last, because its threads use the package
};

}  // namespace vantage
