#pragma once
#include <atomic>
#include <deque>
#include <future>
#include <optional>
#include <thread>
#include <vector>

#include "pipeline/input/file_identity.h"
#include "pipeline/input/scene_input.h"
#include "pipeline/pixels/rgba_image.h"
#include "pipeline/run/trace.h"

namespace vantage {

/// Photos that are read and decoded before their turn: while the model is prepared, only one core has work.
class PhotoPrefetch {
  public:
    /// Begins with `threads` at a time; the scene must outlive it, and its photos stay as they are.
    PhotoPrefetch(const SceneInput& scene, const std::vector<std::size_t>& photos, unsigned threads,
                  Trace* trace);
    /// Begins no more of them.
    ~PhotoPrefetch() { next_ = photos_.size(); }

    /// The photo, once, if it was among them, is begun, could be read, and was then the file with this
    /// identity.
    std::optional<RgbaImage> take(std::size_t photo, const FileIdentity& identity);

  private:
    struct Ahead {
        std::size_t photo;
        FileIdentity identity;
        std::optional<RgbaImage> image;
        std::atomic<bool> begun = false;
        std::promise<void> decoded;
    };
    void decode(Ahead& ahead, const PhotoInput& photo, Trace* trace);

    std::deque<Ahead> photos_;
    std::atomic<std::size_t> next_ = 0;
    std::vector<std::jthread> threads_;
};

}  // namespace vantage
