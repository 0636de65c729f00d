#pragma once
#include <string>
#include <string_view>

namespace vantage {

/// The URL without its fragment. Throws Error(input) unless it is an http or https URL.
std::string checked_url(std::string_view text);

/// A checked URL as it is shown in messages and stored in the cache, without the user name and password.
std::string shown_url(const std::string& url);

}  // namespace vantage
