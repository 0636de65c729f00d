#pragma once
#include <vector>

#include "scene/package/package_format.h"

namespace vantage {

/// One record and one state per photo, in the scene's order. While photos are prepared, each entry is written
/// by the photo's own thread.
struct PhotoTables {
    std::vector<package::PhotoRecord> records;
    std::vector<package::PhotoState> states;
};

}  // namespace vantage
