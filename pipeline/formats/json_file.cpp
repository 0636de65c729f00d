#include "pipeline/formats/json_file.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/text/parse_number.h"
#include "pipeline/run/read_file.h"

namespace vantage {

JsonFile::JsonFile(const std::filesystem::path& file)
    : name_(file.string()),
      value_(std::make_shared<nlohmann::json>(parsed_json(read_plain_text(file), name_))) {}

double numeral(const LocatedJson& value) {
    if (!value.is_text()) return value.number(-max_value, max_value);
    double number = 0;
    if (!parse_number(value.text(100), number) || !(std::abs(number) <= max_value)) value.fail("a number");
    return number;
}

double numeral(const LocatedJson& object, const char* key, double otherwise) {
    return object.has(key) ? numeral(object.at(key)) : otherwise;
}

int photo_size(const LocatedJson& value) {
    const double size = numeral(value);
    if (!(size >= 1 && size <= 1 << 20 && size == std::floor(size))) value.fail("the size of a photo");
    return int(size);
}

std::vector<double> numerals(const LocatedJson& list, std::size_t count) {
    const std::vector<LocatedJson> items = list.items(max_cameras);
    if (items.size() != count) list.fail("an array of " + std::to_string(count) + " numbers");
    std::vector<double> out;
    for (const LocatedJson& item : items) out.push_back(numeral(item));
    return out;
}

std::string identifier(const LocatedJson& value) {
    if (value.is_text()) return value.text(1000);
    return std::to_string(std::llround(value.number(-max_value, max_value)));
}

}  // namespace vantage
