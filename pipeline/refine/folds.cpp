#include "pipeline/refine/folds.h"

#include <algorithm>

#include "pipeline/run/for_each_photo.h"

namespace vantage {
namespace {

/// Up to `max_folds` photos that have pixels, evenly spread.
std::vector<std::uint32_t> photos_to_hold_out(std::span<const package::PhotoRecord> photos,
                                              std::size_t max_folds) {
    std::vector<std::uint32_t> with_pixels, out;
    for (std::uint32_t i = 0; i < photos.size(); ++i)
        if (photos[i].levels > 0) with_pixels.push_back(i);
    const std::size_t n = std::min(with_pixels.size(), max_folds);
    for (std::size_t f = 0; f < n; ++f) out.push_back(with_pixels[f * with_pixels.size() / n]);
    return out;
}

}  // namespace

Folds::Folds(const FoldsInput& in)
    : in_(in), shared_(in.photos, in.samples, in.discs), photos_(cached_photos, [this](std::uint32_t photo) {
          CoarsePhoto read = read_coarse_photo(in_.package, in_.photos[photo], photo, level(photo));
          in_.package.forget_all();
          return read;
      }) {
    for (const std::uint32_t photo : photos_to_hold_out(in.photos, in.max_folds)) {
        Fold fold{photo, {}};
        for (const PhotoPair& p : shared_.best_pairs(photo, max_others))
            fold.others.push_back(p.a == photo ? p.b : p.a);
        std::ranges::sort(fold.others);
        folds_.push_back(std::move(fold));
    }
    kept_.resize(std::min(folds_.size(), kept_sightings));
}

int Folds::level(std::uint32_t photo) const { return coarse_level(in_.photos[photo], in_.long_side); }

Sightings Folds::sightings_of(const Fold& fold, const CoarsePhoto& target, std::span<const Pose> poses,
                              const Pose& own) const {
    std::vector<std::shared_ptr<const CoarsePhoto>> held;
    std::vector<OtherPhoto> others;
    for (const std::uint32_t i : fold.others) {
        held.push_back(photos_.get(i));
        others.push_back({i, held.back().get(), poses.empty() ? held.back()->pose : poses[i]});
    }
    return sightings(target, own, others);
}

std::shared_ptr<const Sightings> Folds::View::sightings() const {
    if (index < folds.kept_.size() && folds.kept_[index]) return folds.kept_[index];
    auto seen = std::make_shared<const Sightings>(folds.sightings_of(fold, target, {}, target.pose));
    if (index < folds.kept_.size()) folds.kept_[index] = seen;
    return seen;
}

Sightings Folds::View::sightings(std::span<const Pose> poses, const Pose& own) const {
    return folds.sightings_of(fold, target, poses, own);
}

void Folds::read_ahead() const {
    for (std::size_t f = 0; f < std::min(folds_.size(), cached_photos); ++f) photos_.get(folds_[f].photo);
}

void Folds::each(const std::function<void(const View&)>& visit) const {
    for_each_photo(folds_.size(), in_.threads, [&](std::size_t f) {
        const CoarsePhoto target = every_second_texel(*photos_.get(folds_[f].photo));
        visit(View{folds_[f], f, target, *this});
    });
}

}  // namespace vantage
