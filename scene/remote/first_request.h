#pragma once
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "scene/remote/origin.h"
#include "scene/remote/request.h"

namespace vantage {

/// The request that opens a file. The request determines the file's size and holds the first bytes in memory,
/// because the cached file is selected only later.
class FirstRequest : public Request {
  public:
    /// `bytes`: the number of bytes to request. `cached`: a cached copy that is complete enough to be used if
    /// it is current; otherwise null.
    FirstRequest(std::uint64_t bytes, std::string url, const Origin* cached);

    /// Waits for completion. Returns false when stopped.
    bool wait(std::stop_token stop);
    // Valid after completion:
    const std::optional<Failure>& failure() const { return failure_; }
    /// True if the cached copy is current; origin() and bytes() are then not set.
    bool unmodified() const { return unmodified_; }
    const Origin& origin() const { return *origin_; }
    std::span<const std::byte> bytes() const { return bytes_; }

    std::string condition() const override;
    std::string flaw(const Answer& answer, ByteRange asked) override;
    void store(std::uint64_t offset, std::span<const std::byte> bytes) override;
    void done(const Failure* failure) override;

  private:
    const std::string url_;
    const std::optional<Origin> cached_;
    std::optional<Origin> origin_;
    std::vector<std::byte> bytes_;
    bool unmodified_ = false;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    bool finished_ = false;
    std::optional<Failure> failure_;
};

}  // namespace vantage
