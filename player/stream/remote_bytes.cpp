#include "player/stream/remote_bytes.h"

#include <algorithm>
#include <array>

#include "base/text/error.h"

namespace vantage {
namespace {

constexpr unsigned groups_in_flight = 3;
constexpr std::size_t requests_per_group = 4, max_arrivals = 48;

}  // namespace

RemoteBytes::RemoteBytes(const PackageReader& package, std::function<void()> arrived)
    : package_(package), arrived_(std::move(arrived)) {
    for (unsigned i = 0; i < groups_in_flight; ++i)
        threads_.emplace_back([this](std::stop_token stop) { work(stop); });
}

RemoteBytes::~RemoteBytes() {
    for (std::jthread& t : threads_) t.request_stop();
    want({});
    threads_.clear();
}

void RemoteBytes::want(std::span<const StreamRequest> requests) {
    {
        const std::scoped_lock lock(mutex_);
        wanted_.assign(requests.begin(), requests.end());
        std::unordered_set<std::uint64_t> identities;
        for (const StreamRequest& r : wanted_) identities.insert(r.identity());
        const auto stale = [&](const StreamRequest& r) { return !identities.contains(r.identity()); };
        std::erase_if(arrivals_, [&](const auto& a) { return !identities.contains(a.first); });
        for (Group* group : groups_)
            if (std::ranges::all_of(group->requests, stale)) group->stop.request_stop();
    }
    work_.notify_all();
}

std::optional<RemoteBytes::Arrival> RemoteBytes::take(
    const std::function<bool(const StreamRequest&)>& accepts) {
    const std::scoped_lock lock(mutex_);
    const auto next = std::ranges::find_if(
        wanted_, [&](const StreamRequest& r) { return arrivals_.contains(r.identity()); });
    if (next == wanted_.end()) return {};
    const auto found = arrivals_.find(next->identity());
    if (found->second.held && !accepts(*next)) return {};
    Arrival out = std::move(found->second);
    arrivals_.erase(found);
    wanted_.erase(next);
    work_.notify_all();
    return out;
}

std::vector<StreamRequest> RemoteBytes::next_requests() const {
    std::vector<StreamRequest> out;
    for (const StreamRequest& r : wanted_) {
        if (out.size() == requests_per_group ||
            arrivals_.size() + fetching_.size() + out.size() >= max_arrivals)
            break;
        if (!arrivals_.contains(r.identity()) && !fetching_.contains(r.identity())) out.push_back(r);
    }
    return out;
}

void RemoteBytes::work(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    Group group;
    while (work_.wait(lock, stop, [&] { return !(group.requests = next_requests()).empty(); })) {
        group.stop = {};
        for (const StreamRequest& r : group.requests) fetching_.insert(r.identity());
        groups_.push_back(&group);
        fetch(group, lock);
        std::erase(groups_, &group);
        for (const StreamRequest& r : group.requests) fetching_.erase(r.identity());
    }
}

void RemoteBytes::fetch(Group& group, std::unique_lock<std::mutex>& lock) {
    lock.unlock();
    Held held;
    std::string failure;
    try {
        held = hold(group);
    } catch (const Error& e) {
        if (e.code() != Exit::interrupted) failure = e.what();
    }
    lock.lock();
    if (!held && failure.empty()) return;  // stopped
    for (const StreamRequest& r : group.requests)
        if (std::ranges::any_of(wanted_,
                                [&](const StreamRequest& w) { return w.identity() == r.identity(); }))
            arrivals_[r.identity()] = {r, held, failure};
    lock.unlock();
    arrived_();
    lock.lock();
}

Held RemoteBytes::hold(const Group& group) const {
    std::vector<TilePlace> tiles;
    std::vector<PackageReader::Part> parts;
    for (const StreamRequest& r : group.requests) {
        if (r.resource == Resource::points) {
            parts.push_back(package_.head(*r.chunk));
            parts.push_back(package_.block(*r.chunk, r.block));
        } else if (r.bytes) {
            parts.push_back(package_.raw(*r.chunk));
        }
        for (const TilePlace& tile : tiles_of(package_, r)) tiles.push_back(tile);
    }
    Held others = package_.hold(parts, group.stop.get_token());
    Held of_tiles = hold_tiles(package_, tiles, group.stop.get_token());
    return std::make_shared<std::array<Held, 2>>(std::array{std::move(others), std::move(of_tiles)});
}

}  // namespace vantage
