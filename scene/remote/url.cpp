#include "scene/remote/url.h"

#include <curl/curl.h>

#include <memory>

#include "base/text/error.h"
#include "base/text/is_url.h"

namespace vantage {

namespace {

struct Free {
    void operator()(CURLU* url) const { curl_url_cleanup(url); }
    void operator()(char* text) const { curl_free(text); }
};

/// The URL without these parts; empty if the URL is malformed.
std::string without(const std::string& text, std::initializer_list<CURLUPart> parts) {
    const std::unique_ptr<CURLU, Free> url(curl_url());
    if (!url || curl_url_set(url.get(), CURLUPART_URL, text.c_str(), 0) != CURLUE_OK) return {};
    for (const CURLUPart part : parts) curl_url_set(url.get(), part, nullptr, 0);
    char* found = nullptr;
    if (curl_url_get(url.get(), CURLUPART_URL, &found, 0) != CURLUE_OK) return {};
    return std::unique_ptr<char, Free>(found).get();
}

}  // namespace

std::string checked_url(std::string_view text) {
    const std::string given(text);
    const bool whole = given.find('\0') == std::string::npos;
    std::string url = is_url(text) && whole ? without(given, {CURLUPART_FRAGMENT}) : "";
    if (url.empty()) throw Error(Exit::input, given + ": not a URL, expected https://host/path");
    return url;
}

std::string shown_url(const std::string& url) {
    return without(url, {CURLUPART_USER, CURLUPART_PASSWORD, CURLUPART_OPTIONS});
}

}  // namespace vantage
