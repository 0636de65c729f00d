#pragma once
#include <vector>

#include "scene/package/package_format.h"

namespace vantage {

/// One record and one state per photo, in the scene's order. While photos are being prepared, each entry is
/// written by the thread that processes its photo.
struct PhotoTables {
    std::vector<package::PhotoRecord> records;
    std::vector<package::PhotoState> states;
};

}  // namespace vantage
