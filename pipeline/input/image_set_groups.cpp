#include "pipeline/input/image_set_groups.h"

#include <fmt/format.h>
#include <fnmatch.h>
#include <toml++/toml.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "base/text/error.h"
#include "base/text/file_name.h"
#include "base/text/photo_names.h"
#include "scene/package/package_format.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

/// Names of image set folders, the first group for visible light.
constexpr const char* visible_image_sets[] = {"visible", "vis",    "rgb",         "color",
                                              "colour",  "normal", "normal light"};
constexpr const char* other_image_sets[] = {
    "infrared", "ir",      "nir", "irr",    "swir",   "irfc",         "ultraviolet", "uv",
    "uvf",      "uvl",     "uvr", "uvirfc", "raking", "raking light", "xray",        "x-ray",
    "xrf",      "thermal", "tir", "lwir",   "before", "after",        "transmitted", "polarized"};
constexpr const char* without_folder = "photos";  ///< the image set of photos outside any folder

bool is_one_of(std::span<const char* const> names, const std::string& name) {
    std::string spaced = comparable_name(name);
    std::ranges::replace(spaced, '_', ' ');
    return std::ranges::any_of(names, [&](const char* n) { return spaced == n; });
}

/// The name of a photo's image set, from the folders in its path; empty if none of them names an image set.
std::optional<std::string> image_set_by_folder(const fs::path& photo, const std::string& how) {
    const fs::path folders = photo.parent_path();
    if (folders.empty()) return without_folder;
    for (const fs::path& folder : folders)
        if (how == image_sets_by_folder || is_known_image_set(folder.string()))
            return utf8_name(folder.string());
    return {};
}

void expect_image_set(const std::string& name, const std::string& where) {
    if (!is_image_set_name(name))
        throw Error(
            Exit::usage,
            fmt::format("{}: '{}' cannot be the name of an image set, expected 1 to 55 bytes without / "
                        "and =",
                        where, name));
}

/// Groups photos by the names of their image sets, ignoring case.
ImageSetGroups grouped(std::span<const std::string> of_photos, const std::string& where) {
    ImageSetGroups out;
    std::map<std::string, std::uint32_t> known;
    std::vector<std::size_t> count;
    for (const std::string& name : of_photos) {
        const auto [it, added] = known.emplace(comparable_name(name), std::uint32_t(out.names.size()));
        if (added) out.names.push_back(name), count.push_back(0);
        ++count[it->second];
        out.of_photo.push_back(it->second);
    }
    if (out.names.size() > package::max_image_sets)
        throw Error(Exit::usage, fmt::format("{}: {} image sets, expected at most {}", where,
                                             out.names.size(), package::max_image_sets));
    for (const std::string& name : out.names) expect_image_set(name, where);
    std::vector<std::uint32_t> order(out.names.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::uint32_t b) {
        const bool first = is_one_of(visible_image_sets, out.names[b]) || out.names[b] == without_folder;
        return std::tuple(!first, -std::int64_t(count[b]), out.names[b]);
    });
    std::vector<std::string> names;
    std::vector<std::uint32_t> place(order.size());
    for (const std::uint32_t b : order) place[b] = std::uint32_t(names.size()), names.push_back(out.names[b]);
    for (std::uint32_t& b : out.of_photo) b = place[b];
    out.names = std::move(names);
    return out;
}

ImageSetGroups one_image_set(std::size_t photos) { return {{""}, std::vector<std::uint32_t>(photos, 0)}; }

ImageSetGroups by_folder(std::span<const fs::path> photos, const std::string& how) {
    std::vector<std::string> names;
    std::string unknown, known;
    for (const fs::path& photo : photos) {
        const auto image_set = image_set_by_folder(photo, how);
        if (!image_set)
            unknown = utf8_name(photo.parent_path().generic_string());
        else if (!photo.parent_path().empty())
            known = *image_set;
        names.push_back(image_set.value_or(""));
    }
    if (unknown.empty()) return grouped(names, "the photos' folders");
    ImageSetGroups out = one_image_set(photos.size());
    if (!known.empty())
        out.note = fmt::format(
            "'{}' may be an image set, but '{}' is not the name of one, so all photos are shown together; "
            "--image-sets folders makes each folder an image set, and --image-sets FILE groups by file names",
            known, unknown);
    return out;
}

/// An image set that a file names, with its patterns.
struct NamedPatterns {
    std::string name;
    std::vector<std::string> patterns;
};

[[noreturn]] void fail(const std::string& file, const std::string& what) {
    throw Error(Exit::input, file + ": " + what);
}

std::vector<NamedPatterns> read_patterns(const std::string& file) {
    if (!fs::is_regular_file(file))
        throw Error(Exit::usage, "--image-sets " + file +
                                     ": expected auto, folders, off, or a file that names the image sets");
    std::vector<NamedPatterns> out;
    try {
        for (const auto& [key, value] : toml::parse_file(file)) {
            NamedPatterns& image_set = out.emplace_back(NamedPatterns{std::string(key.str()), {}});
            expect_image_set(image_set.name, file);
            const auto add = [&](const toml::node& node) {
                const auto text = node.value<std::string>();
                if (!text || text->empty())
                    fail(file,
                         image_set.name + ": expected a pattern such as \"*_ir.jpg\", or a list of them");
                image_set.patterns.push_back(*text);
            };
            if (const auto* list = value.as_array())
                for (const toml::node& node : *list) add(node);
            else
                add(value);
        }
    } catch (const toml::parse_error& e) {
        throw Error(Exit::input, fmt::format("{}:{}: {}", file, e.source().begin.line, e.description()));
    }
    if (out.empty()) fail(file, "names no image set, expected a line such as infrared = \"ir/*\"");
    return out;
}

bool fits(const std::string& path, const std::string& name, const std::string& pattern) {
    const std::string& whole = pattern.find('/') == std::string::npos ? name : path;
    return ::fnmatch(utf8_name(pattern).c_str(), whole.c_str(), 0) == 0 ||
           ::fnmatch(comparable_name(pattern).c_str(), comparable_name(whole).c_str(), FNM_NOESCAPE) == 0;
}

ImageSetGroups by_file(std::span<const fs::path> photos, const std::string& file) {
    const std::vector<NamedPatterns> image_sets = read_patterns(file);
    std::vector<bool> used(image_sets.size(), false);
    std::vector<std::string> names;
    for (const fs::path& photo : photos) {
        const std::string path = utf8_name(photo.generic_string()),
                          name = utf8_name(photo.filename().string());
        std::optional<std::size_t> own;
        for (std::size_t b = 0; b < image_sets.size(); ++b) {
            if (std::ranges::none_of(image_sets[b].patterns,
                                     [&](const auto& p) { return fits(path, name, p); }))
                continue;
            if (own)
                fail(file, fmt::format("{} is in two image sets, {} and {}; expected one", path,
                                       image_sets[*own].name, image_sets[b].name));
            own = b;
            used[b] = true;
        }
        if (!own) fail(file, path + " is in no image set, expected a pattern that matches it");
        names.push_back(image_sets[*own].name);
    }
    for (std::size_t b = 0; b < image_sets.size(); ++b)
        if (!used[b])
            fail(file,
                 fmt::format(
                     "the image set {} has no photo that can be used: none matches {}", image_sets[b].name,
                     image_sets[b].patterns.empty() ? "its empty list" : image_sets[b].patterns.front()));
    return grouped(names, file);
}

}  // namespace

bool is_image_sets_file(const std::string& how) {
    return how != image_sets_auto && how != image_sets_by_folder && how != image_sets_off;
}

bool is_known_image_set(const std::string& folder) {
    return is_one_of(visible_image_sets, folder) || is_one_of(other_image_sets, folder);
}

ImageSetGroups group_image_sets(std::span<const fs::path> photos, const std::string& how) {
    if (how == image_sets_off) return one_image_set(photos.size());
    return is_image_sets_file(how) ? by_file(photos, how) : by_folder(photos, how);
}

fs::path image_set_folder(const fs::path& root, const fs::path& path, const std::string& how) {
    fs::path folder = root;
    const fs::path below = path.lexically_relative(root);
    for (const fs::path& part : below) {
        folder /= part;
        if (how == image_sets_by_folder || (how == image_sets_auto && is_known_image_set(part.string())))
            return folder;
    }
    return {};
}

}  // namespace vantage
