#include "pipeline/refine/transient.h"

#include <array>

#include "pipeline/refine/prediction.h"
#include "pipeline/refine/verdict.h"
#include "pipeline/run/for_each_photo.h"

namespace vantage {

TransientView transient_view(const CoarsePhoto& photo) {
    TransientView v{photo.k.width, photo.k.height, photo.k, photo.pose, {}};
    v.texels.resize(photo.texels.size());
    for (std::size_t i = 0; i < v.texels.size(); ++i)
        set_color(v.texels[i], photo.texels[i].linear, photo.texels[i].z);
    find_ranges(v);
    return v;
}

std::vector<TransientMap> transient_maps(const TransientViews& uncorrected, const PhotoColors& colors,
                                         const TransientPartners& partners, unsigned threads) {
    const std::size_t n = colors.ln_gain.size();
    std::vector<TransientMap> out(n);
    LruCache<TransientView> views(cached_views, [&](std::uint32_t i) {
        return corrected(*uncorrected.get(i), colors.ln_gain[i], colors.vignetting[i]);
    });
    for_each_photo(n, threads, [&](std::size_t i) {
        out[i] = transient_of(std::uint32_t(i), partners.of(std::uint32_t(i)), views);
    });
    return out;
}

namespace {

/// The maps of the photos from which a fold's photo is predicted; empty for other photos.
std::vector<TransientMap> maps_without(const Folds& folds, const Fold& fold,
                                       const TransientPartners& partners, const PhotoColors& colors,
                                       const TransientViews& uncorrected) {
    const LruCache<TransientView> views(cached_views, [&](std::uint32_t i) {
        return corrected(*uncorrected.get(i), colors.ln_gain[i], colors.vignetting[i]);
    });
    std::vector<TransientMap> out(folds.input().photos.size());
    for (const std::uint32_t i : fold.others) out[i] = transient_of(i, partners.of(i, fold.photo), views);
    return out;
}

}  // namespace

Judgment validate_transients(const Folds& folds, const TransientViews& uncorrected,
                             const TransientPartners& partners, std::span<const PhotoColors> fits,
                             bool gains_on, bool vignetting_on) {
    const FoldsInput& in = folds.input();
    std::vector<ValidatedPhoto> photos(folds.all().size());
    folds.each([&](const Folds::View& v) {
        const auto kept = v.sightings();
        const Sightings& seen = *kept;
        const std::size_t f = v.index;
        const auto maps = maps_without(folds, v.fold, partners, fits[f], uncorrected);
        std::vector<Grid<const std::uint8_t>> weights;
        for (const TransientMap& m : maps)
            weights.push_back({m.weight.empty() ? nullptr : m.weight.data(), m.width, m.height});
        const Alternative without = alternative(fits[f], gains_on, vignetting_on, v.fold.photo);
        Alternative with = without;
        with.transients = weights;
        const std::array predictions{predict(v.target, seen, without), predict(v.target, seen, with)};
        const std::vector<ValidationScore> scores = score(own_color(v.target), predictions);
        photos[f] = {in.photos[v.fold.photo].name, scores[0], scores[1]};
    });
    return summarize(photos);
}

}  // namespace vantage
