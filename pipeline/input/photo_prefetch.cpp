#include "pipeline/input/photo_prefetch.h"

#include <algorithm>
#include <utility>

#include "base/text/error.h"
#include "pipeline/photos/photos.h"
#include "pipeline/run/read_file.h"

namespace vantage {

PhotoPrefetch::PhotoPrefetch(const SceneInput& scene, const std::vector<std::size_t>& photos,
                             unsigned threads, Trace* trace) {
    if (threads == 0) return;
    for (const std::size_t i : photos) photos_.emplace_back().photo = i;
    for (std::size_t t = 0; t < std::min<std::size_t>(threads, photos.size()); ++t)
        threads_.emplace_back([this, &scene, trace] {
            for (std::size_t n; (n = next_++) < photos_.size();)
                decode(photos_[n], scene.photos[photos_[n].photo], trace);
        });
}

void PhotoPrefetch::decode(Entry& entry, const PhotoInput& photo, Trace* trace) {
    if (entry.claimed.exchange(true)) return;  // take() was first
    try {
        const Traced traced(trace, "decode", photo.name);
        const std::vector<std::byte> bytes = read_file(photo.file);
        entry.identity = identify(bytes);
        entry.image = decode_photo(photo.file, bytes, photo.decoded);
    } catch (const std::exception&) {
        // The error is reported when the photo is decoded again later.
    }
    entry.decoded.set_value();
}

std::optional<RgbaImage> PhotoPrefetch::take(std::size_t photo, const FileIdentity& identity) {
    const auto it = std::ranges::find(photos_, photo, &Entry::photo);
    if (it == photos_.end() || !it->claimed.exchange(true)) return std::nullopt;
    it->decoded.get_future().wait();
    if (!(it->identity == identity)) it->image.reset();
    return std::exchange(it->image, std::nullopt);
}

}  // namespace vantage
