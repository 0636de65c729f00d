#include "pipeline/formats/xml_file.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/text/error.h"
#include "base/text/parse_number.h"
#include "pipeline/run/read_file.h"

namespace vantage {
namespace {

std::string in_quotes(std::string_view text) {
    constexpr std::size_t most = 40;
    std::string out = "'" + std::string(text.substr(0, most)) + (text.size() > most ? "...'" : "'");
    std::ranges::replace_if(
        out, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    return out;
}

std::size_t line_of(const std::string& text, std::ptrdiff_t offset) {
    const auto end = text.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ptrdiff_t(text.size()));
    return 1 + std::size_t(std::count(text.begin(), end, '\n'));
}

}  // namespace

XmlFile::XmlFile(std::filesystem::path file) : file_(std::move(file)), text_(read_plain_text(file_)) {
    const pugi::xml_parse_result parsed = document_.load_buffer(text_.data(), text_.size());
    if (parsed) return;
    throw Error(Exit::input, file_.string() + ", line " + std::to_string(line_of(text_, parsed.offset)) +
                                 ": is not XML: " + parsed.description());
}

void XmlFile::fail(pugi::xml_node at, const std::string& expected, const std::string& found) const {
    throw Error(Exit::input, file_.string() + ", line " + std::to_string(line_of(text_, at.offset_debug())) +
                                 ": <" + at.name() + ">: expected " + expected + ", found " + found);
}

std::vector<double> XmlFile::numbers(pugi::xml_node element, const std::string& text,
                                     std::size_t count) const {
    std::vector<double> out;
    constexpr const char* blanks = " \t\r\n";
    for (std::size_t at = text.find_first_not_of(blanks); at != text.npos;) {
        const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
        const std::string_view word = std::string_view(text).substr(at, end - at);
        double value = 0;
        if (!parse_number(word, value) || !std::isfinite(value)) fail(element, "a number", in_quotes(word));
        out.push_back(value);
        at = text.find_first_not_of(blanks, end);
    }
    if (out.size() != count)
        fail(element, std::to_string(count) + (count == 1 ? " number" : " numbers"),
             std::to_string(out.size()));
    return out;
}

std::vector<double> XmlFile::numbers(pugi::xml_node element, std::size_t count) const {
    return numbers(element, element.child_value(), count);
}

double XmlFile::number(pugi::xml_node element, const char* name) const {
    const pugi::xml_node child = element.child(name);
    if (!child) fail(element, std::string("<") + name + ">", "none");
    return numbers(child, 1).front();
}

double XmlFile::number(pugi::xml_node element, const char* name, double otherwise) const {
    return element.child(name) ? number(element, name) : otherwise;
}

double XmlFile::attribute(pugi::xml_node element, const char* name) const {
    const pugi::xml_attribute attribute = element.attribute(name);
    if (!attribute) fail(element, std::string("the attribute ") + name, "none");
    return numbers(element, attribute.value(), 1).front();
}

double XmlFile::attribute(pugi::xml_node element, const char* name, double otherwise) const {
    return element.attribute(name) ? attribute(element, name) : otherwise;
}

int XmlFile::size(pugi::xml_node element, double value) const {
    if (!(value >= 1 && value <= 1 << 20 && value == std::floor(value)))
        fail(element, "the size of a photo", in_quotes(std::to_string(value)));
    return int(value);
}

}  // namespace vantage
