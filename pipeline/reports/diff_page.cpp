#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <sstream>

#include "base/files/make_folder.h"
#include "base/files/replace_file.h"
#include "base/files/side_by_side.h"
#include "base/text/explained_table.h"
#include "base/text/markup.h"
#include "base/text/page_style.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/reports/diff.h"
#include "pipeline/stages/tile_levels.h"
#include "scene/package/contents/stored_tile.h"
#include "scene/package/output_file.h"
#include "scene/package/package_inputs.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using package::DirectoryEntry;
using package::PhotoRecord;
using package::Type;

constexpr int longest = 800;  ///< maximum longer side of a picture on the page, px

/// Appended to page_style.
constexpr const char* diff_style = R"(
body { max-width: 90rem; } img { width: 100%; } figure { margin-bottom: 2rem; } td { vertical-align: top; }
.equal { color: var(--better); } .differ { color: var(--worse); }
)";

/// The finest level that fits on the page.
int shown_level(const PhotoRecord& p, Type type) {
    int l = type == Type::weight_maps ? weight_map_level : 0;
    while (std::max(p.width, p.height) >> l > unsigned(longest)) ++l;
    return std::min(l, weight_map_levels_end(int(p.levels)) - 1);
}

constexpr const char* page_name = "index.html";

struct Artifact {
    Type type;
    const char* name;
    std::optional<std::size_t> weights;  ///< channel
};
constexpr Artifact artifacts[] = {{Type::tiles, "tiles", {}},
                                  {Type::weight_maps, "angle", 0},
                                  {Type::weight_maps, "depth", 1},
                                  {Type::weight_maps, "border", 2},
                                  {Type::weight_maps, "transients", 3}};

fs::path picture_of(const fs::path& folder, const std::string& stem, const Artifact& artifact) {
    return folder / (stem + "-" + artifact.name + ".png");
}

struct Pair {
    Level size;
    std::vector<std::byte> a, b;
};

/// The color of RGBA8 texels without their alpha, or one channel (a weight map) as gray.
std::vector<std::uint8_t> shown(std::span<const std::byte> texels, std::optional<std::size_t> weights) {
    std::vector<std::uint8_t> out(texels.size(), 255);
    for (std::size_t p = 0; p < texels.size(); p += 4)
        for (std::size_t c = 0; c < 3; ++c)
            out[p + c] = std::to_integer<std::uint8_t>(texels[p + weights.value_or(c)]);
    return out;
}

/// The pixels of both packages; empty unless the chunks have the same size and differ.
std::optional<Pair> differing(const PackageReader& a, const PackageReader& b, std::uint32_t i,
                              std::uint32_t j, Type type, std::uint32_t level) {
    const PhotoRecord& p = a.photos()[i];
    const DirectoryEntry *x = a.find(type, i, level), *y = b.find(type, j, level);
    const Level size = level_size(int(p.width), int(p.height), int(level));
    if (!x || !y || x->checksum == y->checksum || !holds_level(a, *x, size) || !holds_level(b, *y, size))
        return {};
    return Pair{size, join_tiles(a, *x, size), join_tiles(b, *y, size)};
}

/// The picture files and their captions.
using Pictures = std::vector<std::pair<std::string, std::string>>;

std::string count_of(std::size_t count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

void write_compared(std::ostream& out, const PackageReader& a, const PackageReader& b) {
    const Column columns[] = {{"", ""},
                              {"package", "the file, as named on the command line"},
                              {"size", "size of the file, in MB (1000000 bytes)", true},
                              {"photos", "number of photos, with and without pixels", true},
                              {"vertices", "number in the mesh, or in the stand-in for points", true},
                              {"triangles", "number in the mesh, or in the stand-in for points", true}};
    out << explained_table(columns);
    for (const auto& [letter, package] : {std::pair{'A', &a}, std::pair{'B', &b}})
        out << fmt::format(
            "<tr><td>{}<td>{}<td class=n>{:.1f}<td class=n>{}<td class=n>{}<td class=n>{}</tr>\n", letter,
            escaped(package->path().string()), double(package->size()) / 1e6, package->photos().size(),
            package->scene().vertices, package->scene().triangles);
    out << "</table>\n";
}

void write_differences(std::ostream& out, const std::vector<Difference>& all) {
    const Column columns[] = {
        {"in", "the photo, or the part of the package: settings, inputs or model"},
        {"what",
         "the setting, or the data made from the photo. Tiles: pixels; weight maps: blending weight; "
         "coordinates: positions of vertices in the photo"},
        {"difference",
         "A vs. B. Levels are those of the photo's pyramid: level 0 is full size, and each further level is "
         "half the size of the one before"}};
    out << "<h2>Differences</h2>\n" << explained_table(columns);
    for (const Difference& d : all)
        out << "<tr><td>" << escaped(d.of) << "<td>" << escaped(d.what) << "<td>" << escaped(d.text)
            << "</tr>\n";
    out << "</table>\n";
}

void write_pictures(std::ostream& out, const Pictures& pictures) {
    out << "<h2>Pictures</h2>\n";
    if (pictures.empty()) {
        out << "<p>None: no photo or weight map differs at the size shown here, " << longest << " px.</p>\n";
        return;
    }
    out << "<p>Left: A. Middle: B. Right: the difference, multiplied by " << shown_gain
        << "; black means equal.</p>\n";
    for (const auto& [caption, file] : pictures)
        out << "<figure><figcaption>" << escaped(caption) << "</figcaption><img loading=lazy src=\""
            << escaped(file) << "\" alt=\"" << escaped(caption) << "\"></figure>\n";
}

fs::path write_page(const fs::path& folder, const PackageReader& a, const PackageReader& b,
                    const std::vector<Difference>& all, const Pictures& pictures) {
    const fs::path file = folder / page_name;
    std::ostringstream out;
    const auto name = [](const PackageReader& p) { return escaped(p.path().filename().string()); };
    const std::string title = name(a) + " and " + name(b);
    out << "<!doctype html>\n<html lang=en><meta charset=utf-8><title>" << title << "</title>\n<style>"
        << page_style << diff_style << "</style>\n<h1>" << title << "</h1>\n";
    if (all.empty())
        out << "<p class=equal>Identical: settings, inputs, effects, model, and all photos with everything "
               "made from them.</p>\n";
    else
        out << "<p class=differ>" << count_of(all.size(), "difference") << ", listed below.</p>\n";
    write_compared(out, a, b);
    if (!all.empty()) {
        write_differences(out, all);
        write_pictures(out, pictures);
    }
    out << "</html>\n";
    replace_file(file, out.view());
    return file;
}

}  // namespace

void expect_replaceable(const PackageReader& a, const PackageReader& b, const fs::path& folder, bool force) {
    Inputs inputs = inputs_of(a);
    const Inputs others = inputs_of(b);
    inputs.files.push_back(b.path());
    inputs.contents.insert(inputs.contents.end(), others.contents.begin(), others.contents.end());
    output_file(folder / page_name, Product::page, inputs, force);
    for (const std::string& stem : a.photo_stems())
        for (const Artifact& artifact : artifacts)
            output_file(picture_of(folder, stem, artifact), Product::png, inputs, force);
}

fs::path write_difference_page(const PackageReader& a, const PackageReader& b,
                               const std::vector<Difference>& all, const fs::path& folder) {
    make_folder(folder);
    Pictures pictures;
    const auto photos = a.photos();
    const std::vector<std::string> stems = a.photo_stems();
    for (std::uint32_t i = 0; i < photos.size(); ++i) {
        const auto j = b.photo_index(photos[i].name);
        if (!j) continue;
        const std::string name = photos[i].name;
        for (const auto& [type, what, weights] : artifacts) {
            const auto pair = differing(a, b, i, *j, type, std::uint32_t(shown_level(photos[i], type)));
            if (!pair) continue;
            const fs::path file = picture_of(folder, stems[i], {type, what, weights});
            const auto picture =
                side_by_side(shown(pair->a, weights), shown(pair->b, weights), std::size_t(pair->size.width));
            image_files().write(file, 3 * pair->size.width, pair->size.height, 4, Sample::u8,
                                std::as_bytes(std::span(picture)));
            pictures.push_back({name + ": " + what, file.filename().string()});
        }
    }
    return write_page(folder, a, b, all, pictures);
}

}  // namespace vantage
