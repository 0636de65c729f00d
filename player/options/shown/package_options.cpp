#include "player/options/shown/package_options.h"

#include <algorithm>

#include "base/cli/command.h"
#include "player/view/shots.h"

namespace vantage {

Option add_package_argument(const Command& c, PackageOptions& o, const std::string& more) {
    return c.file("FILE", o.file, "package: a file, or its URL on a server (http:// or https://)" + more)
        .type("PACKAGE");
}

void add_exclude_option(const Command& c, PackageOptions& o) {
    c.list("--exclude", o.exclude, "photos not to blend").type("PHOTO").commas();
}

void add_photo_option(const Command& c, PackageOptions& o, const std::string& help) {
    c.list("--photo", o.photos, help).type("PHOTO").commas();
}

std::vector<std::uint32_t> photos_in_use(const PackageReader& package, const PackageOptions& o) {
    const std::vector<std::uint32_t> excluded = named_photos(package, o.exclude);
    std::vector<std::uint32_t> photos;
    for (std::uint32_t p = 0; p < package.photos().size(); ++p)
        if (!std::ranges::count(excluded, p)) photos.push_back(p);
    return photos;
}

std::vector<std::uint32_t> photos_in_use(const PackageReader& package, const PackageOptions& o,
                                         std::uint32_t image_set) {
    std::vector<std::uint32_t> photos = photos_in_use(package, o);
    std::erase_if(photos, [&](std::uint32_t p) { return package.photos()[p].image_set != image_set; });
    return photos;
}

}  // namespace vantage
