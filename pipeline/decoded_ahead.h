#pragma once
#include <future>
#include <map>
#include <optional>

#include "pipeline/file_identity.h"
#include "pipeline/rgba_image.h"
#include "pipeline/scene_input.h"
#include "pipeline/trace.h"

namespace vantage {

/// Photos that are read and decoded before their turn, each by a thread of its own: while the model is
/// prepared, only one core has work.
class DecodedAhead {
  public:
    /// Begins; the scene must outlive it, and its photos stay as they are.
    DecodedAhead(const SceneInput& scene, const std::vector<std::size_t>& photos, Trace* trace);

    /// The photo, once, if it was among them, could be read, and was then the file with this identity.
    std::optional<RgbaImage> take(std::size_t photo, const FileIdentity& identity);

  private:
    struct Decoded {
        FileIdentity identity;
        RgbaImage image;
    };
    std::map<std::size_t, std::future<Decoded>> photos_;
};

}  // namespace vantage
