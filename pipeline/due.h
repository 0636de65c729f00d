#pragma once
#include <array>

#include "pipeline/stage_keys.h"
#include "scene/package_format.h"

namespace vantage {

/// The stages still to be done for a photo.
struct Due {
    std::array<bool, stage_count> stage{};
    bool operator[](package::Stage s) const { return stage[std::size_t(s)]; }
    bool geometry() const {
        return (*this)[package::Stage::masks] || (*this)[package::Stage::coordinates] ||
               (*this)[package::Stage::coverage] || (*this)[package::Stage::samples];
    }
    bool pixels(const package::PhotoRecord& r) const {
        const bool alpha = r.flags & package::photo_has_alpha;  // as known from the run that made the tiles
        return (*this)[package::Stage::tiles] || (*this)[package::Stage::thumbnail] ||
               (*this)[package::Stage::samples] || ((*this)[package::Stage::masks] && alpha);
    }
};

}  // namespace vantage
