#pragma once
#include <string>
#include <string_view>

namespace vantage {

/// The URL without fragment. Throws Error(input) if it is not a URL of http or https.
std::string checked_url(std::string_view text);

/// A checked URL as messages and the cache show it: without user name and password.
std::string shown_url(const std::string& url);

}  // namespace vantage
