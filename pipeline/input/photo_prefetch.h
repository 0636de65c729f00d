#pragma once
#include <atomic>
#include <deque>
#include <future>
#include <optional>
#include <thread>
#include <vector>

#include "base/values/rgba_image.h"
#include "pipeline/input/file_identity.h"
#include "pipeline/input/scene_input.h"
#include "pipeline/run/trace.h"

namespace vantage {

/// Reads and decodes photos ahead of time, on cores that are idle while one thread prepares the model.
class PhotoPrefetch {
  public:
    /// Starts decoding, on `threads` threads, the photos of the scene whose indices are in `photos`, in this
    /// order. If `threads` is 0, no photo is decoded. The scene and `trace` (may be null) must outlive this
    /// object, and the photos must not change.
    PhotoPrefetch(const SceneInput& scene, const std::vector<std::size_t>& photos, unsigned threads,
                  Trace* trace);
    /// Cancels the decoding of photos that has not started, and waits for photos that are being decoded.
    ~PhotoPrefetch() { next_ = photos_.size(); }

    /// Returns a photo, waiting for it if it is being decoded; nullopt if decoding has not started (it is
    /// then canceled), failed, or read a file with another identity. Must be called at most once per photo.
    std::optional<RgbaImage> take(std::size_t photo, const FileIdentity& identity);

  private:
    struct Entry {
        std::size_t photo;
        FileIdentity identity;
        std::optional<RgbaImage> image;
        std::atomic<bool> claimed = false;  ///< set by a decoding thread, or by take() to prevent decoding
        std::promise<void> decoded;
    };
    void decode(Entry& entry, const PhotoInput& photo, Trace* trace);

    std::deque<Entry> photos_;
    std::atomic<std::size_t> next_ = 0;
    std::vector<std::jthread> threads_;
};

}  // namespace vantage
