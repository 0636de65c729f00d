#include "scene/remote/first_request.h"

namespace vantage {

FirstRequest::FirstRequest(std::uint64_t bytes, std::string url, const Origin* cached)
    : Request({0, bytes}), url_(std::move(url)), cached_(cached ? std::optional(*cached) : std::nullopt) {}

bool FirstRequest::wait(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    return changed_.wait(lock, std::move(stop), [&] { return finished_; });
}

std::string FirstRequest::condition() const {
    if (!cached_) return {};
    if (!cached_->etag.empty()) return "If-None-Match: " + cached_->etag;
    return "If-Modified-Since: " + cached_->last_modified;
}

std::string FirstRequest::flaw(const Answer& answer, ByteRange asked) {
    if (answer.status == 304 && cached_ && bytes_.empty()) {
        unmodified_ = true;
        shorten(0);
        return {};
    }
    std::string flaw = flaw_of(answer, asked, origin_ ? &*origin_ : nullptr);
    if (!flaw.empty() || origin_) return flaw;
    origin_ = origin_of(answer, url_);
    shorten(std::min(range().end, origin_->size));
    bytes_.reserve(range().size());
    return {};
}

void FirstRequest::store(std::uint64_t, std::span<const std::byte> bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

void FirstRequest::done(const Failure* failure) {
    const std::scoped_lock lock(mutex_);
    if (failure) failure_ = *failure;
    finished_ = true;
    changed_.notify_all();
}

}  // namespace vantage
