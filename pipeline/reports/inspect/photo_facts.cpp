#include "pipeline/reports/inspect/photo_facts.h"

#include <algorithm>
#include <functional>
#include <map>
#include <tuple>

#include "base/text/error.h"
#include "base/text/file_name.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/masks.h"
#include "pipeline/input/photo_matches.h"
#include "pipeline/photos/photos.h"
#include "pipeline/reports/inspect/file_facts.h"

namespace vantage {

std::size_t PhotoFacts::photos() const {
    std::size_t sum = 0;
    for (const PhotoGroup& group : groups) sum += group.photos;
    return sum;
}

std::uint64_t PhotoFacts::bytes() const {
    std::uint64_t sum = 0;
    for (const PhotoGroup& group : groups) sum += group.bytes;
    return sum;
}

double PhotoFacts::pixels() const {
    double sum = 0;
    for (const PhotoGroup& group : groups) sum += double(group.photos) * group.size.width * group.size.height;
    return sum;
}

PhotoFacts photo_facts(const std::filesystem::path& folder) {
    PhotoFacts facts;
    Masks masks;
    std::map<std::tuple<std::string, int, int>, PhotoGroup> groups;
    for (const std::filesystem::path& file : photos_below(folder)) {
        PhotoSize size;
        try {
            size = read_photo_header(file).size;
        } catch (const Error& e) {
            facts.unreadable.push_back({name_below(folder, file), reason_of(e, file)});
        }
        const std::string format = format_of(file);
        PhotoGroup& group = groups[{format, size.width, size.height}];
        group = {format, size, group.photos + 1, group.bytes + length_of(file)};
        facts.masks += !masks.of(file).empty();
    }
    for (const auto& [key, group] : groups) facts.groups.push_back(group);
    std::ranges::stable_sort(facts.groups, std::greater{}, &PhotoGroup::photos);
    return facts;
}

}  // namespace vantage
