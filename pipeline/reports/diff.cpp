#include "pipeline/reports/diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>

#include "base/text/json_text.h"
#include "base/values/tiling.h"
#include "scene/package/chunk_table.h"
#include "scene/package/contents/image_sets.h"
#include "scene/package/contents/stored_tile.h"
#include "scene/package/mismatches.h"

namespace vantage {
namespace {

using nlohmann::json;
using package::DirectoryEntry;
using package::PhotoRecord;
using package::Type;
using Differences = std::vector<Difference>;

/// A value as one line of text.
std::string brief(const json& value) {
    constexpr std::size_t longest = 60;
    const std::string text = value.is_null()     ? "none"
                             : value.is_string() ? value.get<std::string>()
                                                 : json_text(value, -1);
    return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

/// The key by which an element of a list is found in the other list: its name, or its index.
std::string key_in(const json& list, std::size_t i) {
    const json& value = list[i];
    if (value.is_object() && value.contains("name") && value["name"].is_string()) return value["name"];
    return value.is_string() ? value.get<std::string>() : std::to_string(i + 1);
}

json keyed(const json& value) {
    if (!value.is_array()) return value;
    json out = json::object();
    for (std::size_t i = 0; i < value.size(); ++i) out[key_in(value, i)] = value[i];
    return out;
}

/// Lists the values that differ, one per line, each with its path.
void diff_values(const char* of, const std::string& what, const json& a, const json& b, Differences& out) {
    if (a == b) return;
    const json x = keyed(a), y = keyed(b);
    if (!x.is_object() || !y.is_object()) {
        if (x.is_object() || y.is_object())
            out.push_back(
                {of, what, x.is_object() ? "only in the first package" : "only in the second package"});
        else
            out.push_back({of, what, brief(x) + " vs. " + brief(y)});
        return;
    }
    json keys = x;
    keys.update(y);
    for (const auto& [key, value] : keys.items())
        diff_values(of, what.empty() ? key : what + ": " + key, x.value(key, json{}), y.value(key, json{}),
                    out);
}

/// Lists at most `listed` differences of one kind and counts the others.
void diff_json(const char* of, const json& a, const json& b, Differences& out, const std::string& what = "") {
    constexpr std::size_t listed = 12;
    Differences found;
    diff_values(of, what, a, b, found);
    const std::size_t shown = std::min(listed, found.size());
    out.insert(out.end(), found.begin(), found.begin() + std::ptrdiff_t(shown));
    if (shown < found.size())
        out.push_back({of, what, fmt::format("and {} more differences", found.size() - shown)});
}

void diff_meta(const PackageReader& a, const PackageReader& b, Differences& out) {
    const json of_a = json_of(a.meta()), of_b = json_of(b.meta());
    if (!of_a.is_object() || !of_b.is_object()) {
        if (a.meta() != b.meta()) out.push_back({"settings", "", "META cannot be parsed"});
        return;
    }
    if (of_a.value("tool", "") != of_b.value("tool", ""))
        out.push_back({"settings", "tool", of_a.value("tool", "") + " vs. " + of_b.value("tool", "")});
    diff_json("settings", of_a.value("config", json{}), of_b.value("config", json{}), out);
    diff_json("inputs", of_a.value("inputs", json{}), of_b.value("inputs", json{}), out);
    for (const char* list : {"effects", "skipped", "warnings"})
        diff_json("inputs", of_a.value(list, json{}), of_b.value(list, json{}), out, list);
}

/// Whether the stored bytes of the chunks are equal.
bool same_chunk(const DirectoryEntry* a, const DirectoryEntry* b) {
    if (!a || !b) return a == b;
    return a->form == b->form && a->checksum == b->checksum && a->length == b->length &&
           a->head_length == b->head_length;
}

/// Whether chunks without blocks have the same content, compressed or not.
bool same_content(const PackageReader& a, const DirectoryEntry* of_a, const PackageReader& b,
                  const DirectoryEntry* of_b) {
    if (same_chunk(of_a, of_b)) return true;
    return of_a && of_b && a.blocks(*of_a) == 0 && b.blocks(*of_b) == 0 &&
           std::ranges::equal(a.bytes(of_a), b.bytes(of_b));
}

void diff_model(const PackageReader& a, const PackageReader& b, Differences& out) {
    const package::SceneRecord &of_a = a.scene(), &of_b = b.scene();
    if (of_a.vertices != of_b.vertices || of_a.triangles != of_b.triangles)
        out.push_back({"model", "size",
                       fmt::format("{} vertices, {} triangles vs. {}, {}", of_a.vertices, of_a.triangles,
                                   of_b.vertices, of_b.triangles)});
    for (const ChunkRow& row : chunk_table())
        if (row.name && !row.per_photo() && !same_content(a, a.find(row.type), b, b.find(row.type)))
            out.push_back({"model", row.name, "different"});
}

/// The differences between texels of bytes, or between depths (relative to the depth).
struct Texels {
    std::size_t tiles = 0, differing = 0;
    double largest = 0, total = 0;
    std::size_t count = 0;

    void add(double difference) {
        largest = std::max(largest, difference);
        total += difference;
        ++count;
    }
    double mean() const { return count ? total / double(count) : 0; }
};

void compare_bytes(std::span<const std::byte> a, std::span<const std::byte> b, Texels& out) {
    for (std::size_t i = 0; i < a.size(); ++i)
        out.add(std::abs(std::to_integer<int>(a[i]) - std::to_integer<int>(b[i])));
}

/// If only one of two depths is finite, their difference is 100 %.
void compare_depths(std::span<const std::byte> a, std::span<const std::byte> b, Texels& out) {
    for (std::size_t i = 0; i + 4 <= a.size(); i += 4) {
        float x, y;
        std::memcpy(&x, a.data() + i, 4);
        std::memcpy(&y, b.data() + i, 4);
        const bool seen = std::isfinite(x) && std::isfinite(y);
        out.add(x == y ? 0 : seen ? std::abs(double(x) - double(y)) / std::max(double(x), double(y)) : 1);
    }
}

/// Returns an empty string if all tiles are the same.
std::string compare_tiles(const PackageReader& a, const DirectoryEntry& of_a, const PackageReader& b,
                          const DirectoryEntry& of_b, const Level& level) {
    Texels t;
    const bool depth = of_a.type == std::uint32_t(Type::depth);
    t.tiles = std::size_t(level.tiles());
    std::vector<std::byte> x(tile_bytes), y(tile_bytes);
    for (std::size_t i = 0; i < t.tiles; ++i) {
        if (!read_tile(a, of_a, level, i, x) || !read_tile(b, of_b, level, i, y))
            return fmt::format("tile {} cannot be decoded", i);
        if (x == y) continue;
        ++t.differing;
        depth ? compare_depths(x, y, t) : compare_bytes(x, y, t);
    }
    if (t.differing == 0) return "";
    return depth ? fmt::format("{} of {} tiles, by at most {:.2g} % of the depth", t.differing, t.tiles,
                               100 * t.largest)
                 : fmt::format("{} of {} tiles, by at most {:.0f} of 255, mean {:.2f} over those tiles",
                               t.differing, t.tiles, t.largest, t.mean());
}

std::string compare_coordinates(const PackageReader& a, const PackageReader& b, std::uint32_t i,
                                std::uint32_t j, const PhotoRecord& photo) {
    const auto x = a.records<std::array<float, 2>>(Type::coordinates, i);
    const auto y = b.records<std::array<float, 2>>(Type::coordinates, j);
    if (x.size() != y.size()) return "of a different model";
    std::size_t visibility = 0;
    double farthest = 0;
    for (std::size_t v = 0; v < x.size(); ++v)
        if ((x[v][0] < 0) != (y[v][0] < 0))
            ++visibility;
        else
            farthest = std::max(farthest, std::hypot(double(x[v][0] - y[v][0]) * photo.width,
                                                     double(x[v][1] - y[v][1]) * photo.height));
    return fmt::format("{} vertices are visible in only one package; the others are at most {:.3g} px apart",
                       visibility, farthest);
}

std::string compare_visible(const PackageReader& a, const PackageReader& b, std::uint32_t i,
                            std::uint32_t j) {
    const auto x = a.records<std::uint64_t>(Type::visible, i), y = b.records<std::uint64_t>(Type::visible, j);
    if (x.size() != y.size()) return "of a different model";
    int bits = 0;
    for (std::size_t w = 0; w < x.size(); ++w) bits += std::popcount(x[w] ^ y[w]);
    return fmt::format("the visibility of {} triangles differs", bits);
}

std::string compare_thumbnails(const PackageReader& a, const PackageReader& b, std::uint32_t i,
                               std::uint32_t j) {
    const PhotoRecord &p = a.photos()[i], &q = b.photos()[j];
    if (p.thumbnail_width != q.thumbnail_width || p.thumbnail_height != q.thumbnail_height)
        return "different size";
    std::vector<std::byte> x(std::size_t(p.thumbnail_width) * p.thumbnail_height * 4), y(x.size());
    if (!read_thumbnail(a, i, x) || !read_thumbnail(b, j, y)) return "cannot be decoded";
    if (x == y) return "";
    Texels t;
    compare_bytes(x, y, t);
    return fmt::format("by at most {:.0f} of 255", t.largest);
}

/// Compares the finest level that differs, because coarser levels are derived from it. Returns an empty
/// string if the content is the same.
std::string compare_chunk(const PackageReader& a, const PackageReader& b, Type type, std::uint32_t level,
                          std::uint32_t i, std::uint32_t j) {
    const PhotoRecord& photo = a.photos()[i];
    const DirectoryEntry *x = a.find(type, i, level), *y = b.find(type, j, level);
    if (!x || !y) return "present in only one package";
    if (type == Type::thumbnail) return compare_thumbnails(a, b, i, j);
    if (a.blocks(*x) > 0 || b.blocks(*y) > 0) {
        const Level size = level_size(int(photo.width), int(photo.height), int(level));
        if (!holds_level(a, *x, size) || !holds_level(b, *y, size)) return "different size";
        const std::string tiles = compare_tiles(a, *x, b, *y, size);
        return tiles.empty() ? "" : fmt::format("level {}: {}", level, tiles);
    }
    if (same_content(a, x, b, y)) return "";
    if (a.content_length(x) != b.content_length(y)) return "different size";
    if (type == Type::coordinates) return compare_coordinates(a, b, i, j, photo);
    if (type == Type::visible) return compare_visible(a, b, i, j);
    return "different";
}

void diff_photo(const PackageReader& a, const PackageReader& b, std::uint32_t i, std::uint32_t j,
                Differences& out) {
    const PhotoRecord &p = a.photos()[i], &q = b.photos()[j];
    if (p.source_checksum != q.source_checksum)
        out.push_back({p.name, "file", "a different file with the same name"});
    if (p.flags != q.flags)
        out.push_back({p.name, "state", fmt::format("flags {} vs. {}", p.flags, q.flags)});
    if (std::memcmp(&p.fx, &q.fx, offsetof(PhotoRecord, corrected_direction) - offsetof(PhotoRecord, fx)) !=
        0)
        out.push_back({p.name, "camera", "different"});
    if (!std::ranges::equal(p.gain, q.gain) || !std::ranges::equal(p.vignetting, q.vignetting))
        out.push_back({p.name, "exposure",
                       fmt::format("gains {:.4f} {:.4f} {:.4f} vs. {:.4f} {:.4f} {:.4f}", p.gain[0],
                                   p.gain[1], p.gain[2], q.gain[0], q.gain[1], q.gain[2])});
    std::set<Type> reported;
    for (const auto& [row, level] : chunks_of_photo(int(std::max(p.levels, q.levels)))) {
        if (reported.contains(row->type) ||
            same_chunk(a.find(row->type, i, level), b.find(row->type, j, level)))
            continue;
        const std::string text = compare_chunk(a, b, row->type, level, i, j);
        if (text.empty()) continue;
        out.push_back({p.name, row->name, text});
        reported.insert(row->type);
    }
}

}  // namespace

Differences diff(const PackageReader& a, const PackageReader& b) {
    expect_valid(a);
    expect_valid(b);
    Differences out;
    diff_meta(a, b, out);
    diff_model(a, b, out);
    const auto of_a = a.photos(), of_b = b.photos();
    const std::vector<ImageSet> image_sets_a = read_image_sets(a), image_sets_b = read_image_sets(b);
    for (std::uint32_t i = 0; i < of_a.size(); ++i)
        if (const auto j = b.photo_index(of_a[i].name)) {
            const std::string &in_a = image_sets_a[of_a[i].image_set].name,
                              &in_b = image_sets_b[of_b[*j].image_set].name;
            if (in_a != in_b)
                out.push_back({of_a[i].name, "image_set",
                               (in_a.empty() ? "none" : in_a) + " vs. " + (in_b.empty() ? "none" : in_b)});
            diff_photo(a, b, i, *j, out);
        } else
            out.push_back({of_a[i].name, "", "only in " + a.path().string()});
    for (const PhotoRecord& p : of_b)
        if (!a.photo_index(p.name)) out.push_back({p.name, "", "only in " + b.path().string()});
    return out;
}

}  // namespace vantage
