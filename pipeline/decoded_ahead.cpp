#include "pipeline/decoded_ahead.h"

#include "pipeline/import/photos.h"
#include "scene/error.h"

namespace vantage {

DecodedAhead::DecodedAhead(const SceneInput& scene, const std::vector<std::size_t>& photos, Trace* trace) {
    for (const std::size_t i : photos)
        photos_[i] = std::async(std::launch::async, [&photo = scene.photos[i], trace] {
            const Traced traced(trace, "decode", photo.name);
            const std::vector<std::byte> bytes = read_file(photo.file);
            return Decoded{identify(bytes), decode_photo(photo.file, bytes, photo.decoded)};
        });
}

std::optional<RgbaImage> DecodedAhead::take(std::size_t photo, const FileIdentity& identity) {
    const auto it = photos_.find(photo);
    if (it == photos_.end() || !it->second.valid()) return std::nullopt;
    try {
        Decoded decoded = it->second.get();
        if (decoded.identity == identity) return std::move(decoded.image);
    } catch (const Error&) {
        // What is wrong with it is said when it is decoded in its turn.
    }
    return std::nullopt;
}

}  // namespace vantage
