#pragma once
#include <string>

#include "pipeline/pixels/rgba_image.h"

namespace vantage {

/// An <img> element that holds its picture as JPEG; alpha is shown on grey. Throws Error(storage) where the
/// picture cannot be encoded.
std::string embedded_picture(const RgbaImage& picture, const std::string& description);

}  // namespace vantage
