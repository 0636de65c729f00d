#include "pipeline/input/band_groups.h"

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

/// Folders of bands, the first group in visible light.
constexpr const char* visible_bands[] = {"visible", "vis",    "rgb",         "color",
                                         "colour",  "normal", "normal light"};
constexpr const char* other_bands[] = {
    "infrared", "ir",      "nir", "irr",    "swir",   "irfc",         "ultraviolet", "uv",
    "uvf",      "uvl",     "uvr", "uvirfc", "raking", "raking light", "xray",        "x-ray",
    "xrf",      "thermal", "tir", "lwir",   "before", "after",        "transmitted", "polarized"};
constexpr const char* without_folder = "photos";  ///< the band of photos in no folder

bool is_one_of(std::span<const char* const> names, const std::string& name) {
    std::string spaced = comparable_name(name);
    std::ranges::replace(spaced, '_', ' ');
    return std::ranges::any_of(names, [&](const char* n) { return spaced == n; });
}

/// A photo's band in words, by the folders in its path; nothing if a folder of it is no band.
std::optional<std::string> band_by_folder(const fs::path& photo, const std::string& how) {
    const fs::path folders = photo.parent_path();
    if (folders.empty()) return without_folder;
    for (const fs::path& folder : folders)
        if (how == bands_by_folder || is_known_band(folder.string())) return utf8_name(folder.string());
    return {};
}

void expect_band(const std::string& name, const std::string& where) {
    if (!is_band_name(name))
        throw Error(Exit::usage,
                    fmt::format("{}: '{}' cannot be the name of a band, expected 1 to 55 bytes without / "
                                "and =",
                                where, name));
}

/// By the names that photos have for their bands; names that differ only in case are one.
BandGroups grouped(std::span<const std::string> of_photos, const std::string& where) {
    BandGroups out;
    std::map<std::string, std::uint32_t> known;
    std::vector<std::size_t> count;
    for (const std::string& name : of_photos) {
        const auto [it, added] = known.emplace(comparable_name(name), std::uint32_t(out.names.size()));
        if (added) out.names.push_back(name), count.push_back(0);
        ++count[it->second];
        out.of_photo.push_back(it->second);
    }
    if (out.names.size() > package::most_bands)
        throw Error(Exit::usage, fmt::format("{}: {} bands, expected at most {}", where, out.names.size(),
                                             package::most_bands));
    for (const std::string& name : out.names) expect_band(name, where);
    std::vector<std::uint32_t> order(out.names.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::uint32_t b) {
        const bool first = is_one_of(visible_bands, out.names[b]) || out.names[b] == without_folder;
        return std::tuple(!first, -std::int64_t(count[b]), out.names[b]);
    });
    std::vector<std::string> names;
    std::vector<std::uint32_t> place(order.size());
    for (const std::uint32_t b : order) place[b] = std::uint32_t(names.size()), names.push_back(out.names[b]);
    for (std::uint32_t& b : out.of_photo) b = place[b];
    out.names = std::move(names);
    return out;
}

BandGroups one_band(std::size_t photos) { return {{""}, std::vector<std::uint32_t>(photos, 0)}; }

BandGroups by_folder(std::span<const fs::path> photos, const std::string& how) {
    std::vector<std::string> names;
    std::string unknown, known;
    for (const fs::path& photo : photos) {
        const auto band = band_by_folder(photo, how);
        if (!band)
            unknown = utf8_name(photo.parent_path().generic_string());
        else if (!photo.parent_path().empty())
            known = *band;
        names.push_back(band.value_or(""));
    }
    if (unknown.empty()) return grouped(names, "the photos' folders");
    BandGroups out = one_band(photos.size());
    if (!known.empty())
        out.note = fmt::format(
            "'{}' may be a band, but '{}' is the name of none, so all photos are shown together; --bands "
            "folders makes each folder a band, --bands FILE groups by file names",
            known, unknown);
    return out;
}

/// The bands that a file names, with their patterns.
struct NamedPatterns {
    std::string name;
    std::vector<std::string> patterns;
};

[[noreturn]] void fail(const std::string& file, const std::string& what) {
    throw Error(Exit::input, file + ": " + what);
}

std::vector<NamedPatterns> read_patterns(const std::string& file) {
    if (!fs::is_regular_file(file))
        throw Error(Exit::usage,
                    "--bands " + file + ": expected auto, folders, off, or a file that names the bands");
    std::vector<NamedPatterns> out;
    try {
        for (const auto& [key, value] : toml::parse_file(file)) {
            NamedPatterns& band = out.emplace_back(NamedPatterns{std::string(key.str()), {}});
            expect_band(band.name, file);
            const auto add = [&](const toml::node& node) {
                const auto text = node.value<std::string>();
                if (!text || text->empty())
                    fail(file, band.name + ": expected a pattern such as \"*_ir.jpg\", or a list of them");
                band.patterns.push_back(*text);
            };
            if (const auto* list = value.as_array())
                for (const toml::node& node : *list) add(node);
            else
                add(value);
        }
    } catch (const toml::parse_error& e) {
        throw Error(Exit::input, fmt::format("{}:{}: {}", file, e.source().begin.line, e.description()));
    }
    if (out.empty()) fail(file, "names no band, expected a line such as infrared = \"ir/*\"");
    return out;
}

bool fits(const std::string& path, const std::string& name, const std::string& pattern) {
    const std::string& whole = pattern.find('/') == std::string::npos ? name : path;
    return ::fnmatch(utf8_name(pattern).c_str(), whole.c_str(), 0) == 0 ||
           ::fnmatch(comparable_name(pattern).c_str(), comparable_name(whole).c_str(), FNM_NOESCAPE) == 0;
}

BandGroups by_file(std::span<const fs::path> photos, const std::string& file) {
    const std::vector<NamedPatterns> bands = read_patterns(file);
    std::vector<bool> used(bands.size(), false);
    std::vector<std::string> names;
    for (const fs::path& photo : photos) {
        const std::string path = utf8_name(photo.generic_string()),
                          name = utf8_name(photo.filename().string());
        std::optional<std::size_t> own;
        for (std::size_t b = 0; b < bands.size(); ++b) {
            if (std::ranges::none_of(bands[b].patterns, [&](const auto& p) { return fits(path, name, p); }))
                continue;
            if (own)
                fail(file, fmt::format("{} is in two bands, {} and {}; expected one", path, bands[*own].name,
                                       bands[b].name));
            own = b;
            used[b] = true;
        }
        if (!own) fail(file, path + " is in no band, expected a pattern that it fits");
        names.push_back(bands[*own].name);
    }
    for (std::size_t b = 0; b < bands.size(); ++b)
        if (!used[b])
            fail(file, fmt::format("the band {} has no photo that can be used: none fits {}", bands[b].name,
                                   bands[b].patterns.empty() ? "its empty list" : bands[b].patterns.front()));
    return grouped(names, file);
}

}  // namespace

bool is_bands_file(const std::string& how) {
    return how != bands_auto && how != bands_by_folder && how != bands_off;
}

bool is_known_band(const std::string& folder) {
    return is_one_of(visible_bands, folder) || is_one_of(other_bands, folder);
}

BandGroups group_bands(std::span<const fs::path> photos, const std::string& how) {
    if (how == bands_off) return one_band(photos.size());
    return is_bands_file(how) ? by_file(photos, how) : by_folder(photos, how);
}

fs::path band_folder(const fs::path& root, const fs::path& path, const std::string& how) {
    fs::path folder = root;
    const fs::path below = path.lexically_relative(root);
    for (const fs::path& part : below) {
        folder /= part;
        if (how == bands_by_folder || (how == bands_auto && is_known_band(part.string()))) return folder;
    }
    return {};
}

}  // namespace vantage
