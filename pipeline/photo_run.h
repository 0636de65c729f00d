#pragma once
#include "pipeline/due.h"
#include "pipeline/photo_stages.h"

namespace vantage {

/// What there is to know of a photo while its stages run.
struct PhotoRun {
    const PhotoStages& s;
    const PhotoInput& photo;
    PhotoAtModel at;
    bool spare_core;  ///< that no other photo wants
};

}  // namespace vantage
