#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "base/text/error.h"
#include "scene/remote/answer.h"
#include "scene/remote/byte_range.h"

namespace vantage {

/// Why a request failed.
struct Failure {
    Exit code = Exit::input;
    std::string message;       ///< begins with the URL
    bool transient = false;    ///< a retry may succeed
    bool unreachable = false;  ///< the server was not reached or is busy, or the connection broke
};

/// A GET request for a range of a file. The member functions are called on the Transfers thread.
class Request {
  public:
    /// `turn`: requests with a lower turn go first, so that a caller with many requests does not block other
    /// callers.
    explicit Request(ByteRange range, std::uint64_t turn = 0) : turn_(turn), range_(range) {}
    virtual ~Request() = default;
    Request(const Request&) = delete;
    Request& operator=(const Request&) = delete;

    std::uint64_t turn() const { return turn_; }
    ByteRange range() const { return range_; }
    /// A header line to send, such as `If-None-Match: "5"`, or empty.
    virtual std::string condition() const { return {}; }
    /// Called with the headers of the last response, before its body. `asked`: the requested part of the
    /// range, that is, the range without the bytes that arrived before a disconnection. Returns the same as
    /// flaw_of(), and may call shorten().
    virtual std::string flaw(const Answer& answer, ByteRange asked) = 0;
    /// Stores the next bytes of the body, which lie within the range. May throw Error(storage).
    virtual void store(std::uint64_t offset, std::span<const std::byte> bytes) = 0;
    /// Called once: with null when all bytes are stored, or with a failure when the last try has failed. This
    /// function is not called if the request is canceled.
    virtual void done(const Failure* failure) = 0;

    /// Cancels the request; may be called from any thread. Transfers::cancel() also wakes its thread.
    void cancel() { cancelled_ = true; }
    bool cancelled() const { return cancelled_; }

  protected:
    void shorten(std::uint64_t end) { range_.end = end; }

  private:
    const std::uint64_t turn_;
    ByteRange range_;
    std::atomic<bool> cancelled_ = false;
};

}  // namespace vantage
