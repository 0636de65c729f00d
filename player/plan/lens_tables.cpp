#include "player/plan/lens_tables.h"

namespace vantage {

LensTables::LensTables(const PackageReader& package) {
    if (!effect_on(package.scene(), Effect::undistortion)) return;
    for (std::uint32_t i = 0; i < package.photos().size(); ++i)
        cameras_.push_back({intrinsics(package.photos()[i]), lens_of(package, i), {}});
    tables_.resize(cameras_.size());
}

const LensTable* LensTables::of(std::uint32_t photo) const {
    if (cameras_.empty() || !cameras_[photo].lens.distorts()) return nullptr;
    std::optional<LensTable>& table = tables_[photo];
    if (!table) table = lens_table(cameras_[photo].intrinsics, cameras_[photo].lens);
    return &*table;
}

}  // namespace vantage
