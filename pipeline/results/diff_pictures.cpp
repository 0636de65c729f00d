#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "pipeline/formats/images/image_files.h"
#include "pipeline/package/tile_levels.h"
#include "pipeline/results/diff.h"
#include "scene/error.h"
#include "scene/make_folder.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using package::DirectoryEntry;
using package::PhotoRecord;
using package::Type;

constexpr int longest = 800;  ///< px of a picture on the page
constexpr int gain = 8;       ///< of the difference, so that small ones show

/// The finest level that a page can show.
int shown_level(const PhotoRecord& p, Type type) {
    int l = type == Type::masks ? mask_level : 0;
    while (std::max(p.width, p.height) >> l > unsigned(longest)) ++l;
    return std::min(l, mask_levels_end(int(p.levels)) - 1);
}

struct Pair {
    Level size;
    std::vector<std::byte> a, b;
};

/// Colour, or one of the masks as grey: A, B and what differs, one beside the other.
std::vector<std::byte> side_by_side(const Pair& pair, int mask) {
    const auto w = std::size_t(pair.size.width), h = std::size_t(pair.size.height);
    std::vector<std::byte> out(3 * w * h * 4, std::byte{255});
    for (std::size_t y = 0; y < h; ++y)
        for (std::size_t x = 0; x < w; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t from = (y * w + x) * 4 + (mask < 0 ? c : std::size_t(mask));
                const std::size_t to = (y * 3 * w + x) * 4 + c;
                const int a = std::to_integer<int>(pair.a[from]), b = std::to_integer<int>(pair.b[from]);
                out[to] = pair.a[from];
                out[to + 4 * w] = pair.b[from];
                out[to + 8 * w] = std::byte(std::min(255, gain * std::abs(a - b)));
            }
    return out;
}

/// The pixels of both, where both have them in one size and they differ.
std::optional<Pair> differing(const PackageReader& a, const PackageReader& b, std::uint32_t i,
                              std::uint32_t j, Type type, std::uint32_t level) {
    const PhotoRecord& p = a.photos()[i];
    const DirectoryEntry *x = a.find(type, i, level), *y = b.find(type, j, level);
    if (!x || !y || x->length != y->length || x->checksum == y->checksum) return {};
    const Level size = level_size(int(p.width), int(p.height), int(level));
    return Pair{size, join_tiles(a, *x, size), join_tiles(b, *y, size)};
}

void write_page(const fs::path& folder, const PackageReader& a, const PackageReader& b,
                const std::vector<std::pair<std::string, std::string>>& pictures) {
    std::ofstream out(folder / "index.html");
    out << "<!doctype html><meta charset=utf-8><title>What differs</title>\n<style>body{font:15px/1.5 "
           "system-ui,"
           "sans-serif;margin:2rem auto;max-width:90rem;padding:0 1rem}img{width:100%}figure{margin:0 0 "
           "2rem}</style>\n"
        << "<h1>What differs</h1><p>Left " << a.path().filename().string() << ", middle "
        << b.path().filename().string() << ", right the difference, " << gain << " times.</p>\n";
    for (const auto& [caption, file] : pictures)
        out << "<figure><figcaption>" << caption << "</figcaption><img src=\"" << file
            << "\" alt=\"\"></figure>\n";
    out.flush();
    if (!out) throw Error(Exit::storage, (folder / "index.html").string() + ": cannot write");
}

}  // namespace

void write_difference_pictures(const PackageReader& a, const PackageReader& b, const fs::path& folder) {
    make_folder(folder);
    std::vector<std::pair<std::string, std::string>> pictures;
    const auto photos = a.photos();
    for (std::uint32_t i = 0; i < photos.size(); ++i) {
        const auto j = b.photo_index(photos[i].name);
        if (!j) continue;
        const std::string name = photos[i].name, stem = name.substr(0, name.rfind('.'));
        const auto add = [&](Type type, const char* what, int mask) {
            const auto pair = differing(a, b, i, *j, type, std::uint32_t(shown_level(photos[i], type)));
            if (!pair) return;
            const std::string file = stem + "-" + what + ".png";
            image_files().write(folder / file, 3 * pair->size.width, pair->size.height, 4, Sample::u8,
                                side_by_side(*pair, mask));
            pictures.push_back({name + ": " + what, file});
        };
        add(Type::tiles, "tiles", -1);
        add(Type::masks, "angle", 0);
        add(Type::masks, "depth", 1);
        add(Type::masks, "border", 2);
        add(Type::masks, "consensus", 3);
    }
    write_page(folder, a, b, pictures);
}

}  // namespace vantage
