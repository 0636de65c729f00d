#pragma once
#include <string>
#include <string_view>

namespace vantage {

/// Base64 as in RFC 4648: padded, without line breaks.
std::string base64(std::string_view bytes);

}  // namespace vantage
