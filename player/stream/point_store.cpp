#include "player/stream/point_store.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text/error.h"

namespace vantage {
namespace {

constexpr std::uint64_t block_bytes = package::point_block * sizeof(package::PackedPoint);
/// Initial capacity in blocks. More is allocated on demand, since a larger buffer would delay the first
/// picture.
constexpr std::uint32_t first_capacity = 16;

gl::Buffer buffer_of(std::uint32_t blocks) {
    return gl::make_buffer("points", blocks * block_bytes, nullptr, GL_DYNAMIC_STORAGE_BIT);
}

}  // namespace

PointStore::PointStore(const PackageReader& package, const PointCloud& cloud, std::uint64_t bytes)
    : chunk_(package.find(package::Type::points)),
      pool_(std::uint32_t(
                std::min<std::uint64_t>(cloud.blocks, std::max<std::uint64_t>(2, bytes / block_bytes))),
            cloud.blocks),
      capacity_(std::min(pool_.layers(), first_capacity)),
      points_(buffer_of(capacity_)),
      requested_(cloud.blocks),
      stream_(package, ring_bytes, 1) {}

void PointStore::begin_frame(double now) {
    ++frame_;
    now_ = now;
    missing_.clear();
    requested_.assign(requested_.size(), false);
}

bool PointStore::need(const package::PointNode& node) {
    if (pool_.use(node.block, frame_)) return true;
    if (const auto found = failed_.find(node.block);
        found != failed_.end() && std::abs(now_ - found->second.at) > Residency::retry_seconds)
        failed_.erase(found);
    if (!requested_[node.block] && !failed_.contains(node.block))
        missing_.push_back(
            {.resource = Resource::points, .key = node.block, .chunk = chunk_, .block = node.block});
    requested_[node.block] = true;
    return false;
}

bool PointStore::place(const Fetched& fetched) {
    if (fetched.state != Fetched::State::valid) {
        failed_[fetched.request.key] = {now_, fetched.state == Fetched::State::damaged};
        return false;
    }
    failed_.erase(fetched.request.key);
    const auto slot = pool_.place(fetched.request.key, frame_);
    if (slot && *slot >= capacity_) grow(*slot + 1);
    if (slot)
        glCopyNamedBufferSubData(stream_.buffer(), points_.id(), GLintptr(fetched.piece->offset),
                                 GLintptr(*slot * block_bytes), GLsizeiptr(block_bytes));
    return slot.has_value();
}

void PointStore::grow(std::uint32_t layers) {
    const std::uint32_t capacity = std::min(pool_.layers(), std::max(layers, 2 * capacity_));
    gl::Buffer larger = buffer_of(capacity);
    glCopyNamedBufferSubData(points_.id(), larger.id(), 0, 0, GLsizeiptr(capacity_ * block_bytes));
    points_ = std::move(larger);
    capacity_ = capacity;
}

std::uint64_t PointStore::growth() const { return (pool_.layers() - capacity_) * block_bytes; }

std::size_t PointStore::damaged() const {
    return std::size_t(std::ranges::count_if(failed_, [](const auto& f) { return f.second.damaged; }));
}

std::size_t PointStore::stream(std::size_t budget) {
    std::erase_if(missing_, [&](const StreamRequest& r) {
        return pool_.layer_of(r.key).has_value() || failed_.contains(r.key);
    });
    missing_.resize(std::min<std::size_t>(missing_.size(), pool_.available(frame_)));
    stream_.want(missing_);
    std::size_t uploaded = 0;
    while (uploaded == 0 || uploaded + block_bytes <= budget) {
        const auto fetched = stream_.take(block_bytes);
        if (!fetched) break;
        if (place(*fetched)) uploaded += block_bytes;
        stream_.release(*fetched);
    }
    stream_.fence();
    return uploaded;
}

void PointStore::load() {
    do stream(max_bytes);
    while (stream_.wait());
    stream(max_bytes);
    if (absent() > 0) throw Error(Exit::input, stream_.failure());
}

}  // namespace vantage
