#include "base/text/photo_names.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>

#include "base/text/file_name.h"

namespace vantage {

std::string_view stem_of(std::string_view name) { return name.substr(0, name.rfind('.')); }

std::vector<std::size_t> photos_meant(std::span<const std::string_view> names, std::string_view wanted) {
    if (const auto same = std::ranges::find(names, wanted); same != names.end())
        return {std::size_t(same - names.begin())};
    const auto listed_if = [&](const auto& is_meant) {
        std::vector<std::size_t> out;
        for (std::size_t i = 0; i < names.size(); ++i)
            if (is_meant(names[i])) out.push_back(i);
        return out;
    };
    auto out = listed_if([&](std::string_view name) { return stem_of(name) == wanted; });
    if (!out.empty()) return out;
    const std::string comparable = comparable_name(wanted);
    return listed_if([&](std::string_view name) {
        return comparable_name(name) == comparable || comparable_name(stem_of(name)) == comparable;
    });
}

std::string first_of(std::span<const std::string> names, std::size_t most) {
    std::string out;
    for (const std::string& name : names.first(std::min(names.size(), most)))
        out += (out.empty() ? "" : ", ") + name;
    return names.size() > most ? out + " and " + std::to_string(names.size() - most) + " more" : out;
}

std::string listed(std::span<const std::string_view> names, std::span<const std::size_t> indices) {
    std::string out;
    for (std::size_t i = 0; i < indices.size(); ++i)
        out += (i == 0 ? "" : i + 1 == indices.size() ? " and " : ", ") + std::string(names[indices[i]]);
    return out;
}

std::vector<std::string> file_stems(std::span<const std::string_view> names) {
    const std::set<std::string_view> whole(names.begin(), names.end());
    std::map<std::string_view, std::size_t> count;
    for (const std::string_view name : names) ++count[stem_of(name)];
    std::vector<std::string> out;
    for (const std::string_view name : names) {
        const std::string_view stem = stem_of(name);
        const bool taken = count[stem] > 1 || (stem != name && whole.contains(stem));
        out.emplace_back(taken ? name : stem);
    }
    return out;
}

bool is_image_set_name(std::string_view name) {
    if (name.empty() || name.size() > 55 || name == "." || name == "..") return false;
    return std::ranges::none_of(name, [](char c) { return c == '/' || c == '=' || std::uint8_t(c) < 32; });
}

}  // namespace vantage
