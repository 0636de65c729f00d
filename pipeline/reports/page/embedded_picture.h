#pragma once
#include <string>

#include "base/values/rgba_image.h"

namespace vantage {

/// An <img> element with the picture embedded as JPEG, blended over gray. Throws Error(storage) if the
/// picture cannot be encoded.
std::string embedded_picture(const RgbaImage& picture, const std::string& description);

}  // namespace vantage
