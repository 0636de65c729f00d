// Compares encodings of color tiles.
#include <squish.h>
#include <zstd.h>

#include <array>
#include <cstring>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "base/gl/context.h"
#include "base/gl/object.h"
#include "base/values/tiling.h"
#include "tests/bench/measure/exhibit.h"
#include "tests/bench/measure/mean.h"
#include "tests/bench/measure/timing.h"
#include "tests/bench/scenes/evenly_spread.h"
#include "tests/bench/sweeps/sweep.h"
#include "tests/bench/sweeps/tiles/tile_layers.h"
#include "tests/bench/sweeps/tiles/tile_pixels.h"

namespace vantage::bench {
namespace {

enum class Codec { raw, bc1_range, bc1_cluster, jpeg, png, zstd };

struct Format {
    const char* name;
    Codec codec;
    int quality = 0;
    bool lossless = false, chosen = false, shown = false;
    bool bc1() const { return codec == Codec::bc1_range || codec == Codec::bc1_cluster; }
};
// BC1 and JPEG have no alpha, which would have to be stored separately.
constexpr Format formats[] = {{"RAW", Codec::raw, 0, true, true, true},
                              {"BC1, range fit", Codec::bc1_range, 0, false, false, true},
                              {"BC1, cluster fit", Codec::bc1_cluster},
                              {"JPEG 95", Codec::jpeg, 95},
                              {"JPEG 85", Codec::jpeg, 85},
                              {"JPEG 75", Codec::jpeg, 75, false, false, true},
                              {"PNG", Codec::png, 0, true},
                              {"zstd, differences", Codec::zstd, 0, true}};

int squish_flags(Codec codec) {
    return squish::kDxt1 | (codec == Codec::bc1_range ? squish::kColourRangeFit : squish::kColourClusterFit);
}

cv::Mat as_matrix(Texels texels, int type) {
    return {tile_size, tile_size, type, const_cast<std::uint8_t*>(texels.data())};
}

Bytes encode_zstd(Texels tile) {
    Bytes differences(tile.begin(), tile.end());
    for (std::size_t row = 0; row < tile.size(); row += tile_size * 4)
        for (std::size_t i = row + 4; i < row + tile_size * 4; ++i)
            differences[i] = std::uint8_t(tile[i] - tile[i - 4]);
    Bytes out(ZSTD_compressBound(differences.size()));
    const std::size_t n = ZSTD_compress(out.data(), out.size(), differences.data(), differences.size(), 1);
    if (ZSTD_isError(n)) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(n));
    out.resize(n);
    return out;
}

void decode_zstd(Texels coded, Bytes& tile) {
    const std::size_t n = ZSTD_decompress(tile.data(), tile.size(), coded.data(), coded.size());
    if (ZSTD_isError(n)) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(n));
    for (std::size_t row = 0; row < tile.size(); row += tile_size * 4)
        for (std::size_t i = row + 4; i < row + tile_size * 4; ++i)
            tile[i] = std::uint8_t(tile[i] + tile[i - 4]);
}

Bytes encode(const Format& f, Texels tile) {
    Bytes out;
    if (f.codec == Codec::raw) return {tile.begin(), tile.end()};
    if (f.codec == Codec::zstd) return encode_zstd(tile);
    if (f.bc1()) {
        out.resize(std::size_t(squish::GetStorageRequirements(tile_size, tile_size, squish_flags(f.codec))));
        squish::CompressImage(tile.data(), tile_size, tile_size, out.data(), squish_flags(f.codec));
    } else if (f.codec == Codec::png) {
        cv::imencode(".png", as_matrix(tile, CV_8UC4), out, {cv::IMWRITE_PNG_COMPRESSION, 1});
    } else {
        cv::Mat bgr;
        cv::cvtColor(as_matrix(tile, CV_8UC4), bgr, cv::COLOR_RGBA2BGR);
        std::vector<int> how{cv::IMWRITE_JPEG_QUALITY, f.quality};
#if CV_VERSION_MAJOR > 4 || (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR >= 7)
        how.insert(how.end(), {cv::IMWRITE_JPEG_SAMPLING_FACTOR, cv::IMWRITE_JPEG_SAMPLING_FACTOR_444});
#endif
        cv::imencode(".jpg", bgr, out, how);
    }
    return out;
}

/// Decodes a tile into `tile`, which must already be as large as a tile.
void decode(const Format& f, Texels coded, Bytes& tile) {
    if (f.codec == Codec::raw) {
        std::memcpy(tile.data(), coded.data(), tile.size());
    } else if (f.codec == Codec::zstd) {
        decode_zstd(coded, tile);
    } else if (f.bc1()) {
        squish::DecompressImage(tile.data(), tile_size, tile_size, coded.data(), squish_flags(f.codec));
    } else {
        const cv::Mat from(1, int(coded.size()), CV_8UC1, const_cast<std::uint8_t*>(coded.data()));
        const cv::Mat image = cv::imdecode(from, cv::IMREAD_UNCHANGED);
        cv::Mat to = as_matrix(tile, CV_8UC4);
        if (image.channels() == 3)
            cv::cvtColor(image, to, cv::COLOR_BGR2RGBA);
        else
            image.copyTo(to);
    }
}

/// A stored tile, and the part of it that is inside the photo; beyond that part, edge texels are repeated.
struct Tile {
    Texels texels;
    int left, top, right, bottom;
    bool whole() const { return left == 0 && top == 0 && right == tile_size && bottom == tile_size; }
};

Tile tile_of(std::span<const std::byte> block, const Level& level, int number) {
    const int x0 = number % level.columns() * tile_content - tile_border,
              y0 = number / level.columns() * tile_content - tile_border;
    return {{reinterpret_cast<const std::uint8_t*>(block.data()), block.size()},
            std::max(0, -x0),
            std::max(0, -y0),
            std::min(tile_size, level.width - x0),
            std::min(tile_size, level.height - y0)};
}

/// Evenly spread tiles of the photos' three finest levels.
std::vector<Tile> some_tiles(const PackageReader& package, const Effort& effort) {
    std::vector<Tile> all;
    for (const std::uint32_t photo : some_photos(package, effort.photos))
        for (std::uint32_t l = 0; l < std::min(3u, package.photos()[photo].levels); ++l) {
            const package::PhotoRecord& p = package.photos()[photo];
            const Level level = level_size(int(p.width), int(p.height), int(l));
            const auto* entry = package.find(package::Type::tiles, photo, l);
            for (std::size_t b = 0; entry && b < package.blocks(*entry); ++b)
                all.push_back(tile_of(package.block(*entry, b), level, int(b)));
        }
    const std::size_t most = std::clamp(effort.points / 200, std::size_t(8), std::size_t(300));
    return evenly_spread(all, most);
}

/// The mean number of tiles in a photo's pyramid.
double tiles_per_photo(const PackageReader& package) {
    std::vector<double> out;
    for (const package::PhotoRecord& p : package.photos()) {
        double n = 0;
        for (std::uint32_t l = 0; l < p.levels; ++l)
            n += level_size(int(p.width), int(p.height), int(l)).tiles();
        if (n > 0) out.push_back(n);
    }
    return mean(out);
}

/// Compares the opaque pixels of a tile with the truth.
void compare(const Tile& truth, const Bytes& tile, Differences& all) {
    for (int y = truth.top; y < truth.bottom; ++y)
        for (int x = truth.left; x < truth.right; ++x) {
            const std::size_t i = 4 * std::size_t(y * tile_size + x);
            for (std::size_t c = i; truth.texels[i + 3] == 255 && c < i + 3; ++c)
                all.add(double(truth.texels[c]) - double(tile[c]));
        }
}

/// The tiles encoded in one format.
struct Coded {
    std::vector<Bytes> tiles;
    double encode_ms = 0;  ///< per tile
    double texel_bytes = 0;
    Differences differences;
};

Coded coded(const Format& f, const std::vector<Tile>& tiles) {
    Coded out;
    out.encode_ms = milliseconds([&] {
                        for (const Tile& t : tiles) out.tiles.push_back(encode(f, t.texels));
                    }) /
                    double(tiles.size());
    Bytes tile(tile_bytes);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        decode(f, out.tiles[i], tile);
        compare(tiles[i], tile, out.differences);
        out.texel_bytes += double(out.tiles[i].size()) / double(tile_size * tile_size) / double(tiles.size());
    }
    return out;
}

/// The time per tile in milliseconds, from its bytes in memory to a texture on the card.
double upload_ms(const Format& f, const Coded& coded, const std::vector<Tile>& raw, Layers& rgba,
                 Layers* bc1) {
    Bytes tile(tile_bytes);
    return milliseconds([&] {
               for (std::size_t i = 0; i < raw.size(); ++i) {
                   if (f.codec == Codec::raw) {
                       rgba.put_rgba(raw[i].texels.data());
                   } else if (f.bc1() && bc1) {
                       bc1->put_bc1(coded.tiles[i]);
                   } else {
                       decode(f, coded.tiles[i], tile);
                       rgba.put_rgba(tile.data());
                   }
               }
           }) /
           double(raw.size());
}

/// The tile with the largest error among those entirely inside their photo, or the first tile if there is
/// none.
std::size_t worst_tile(const Format& f, const Coded& coded, const std::vector<Tile>& tiles) {
    Bytes tile(tile_bytes);
    std::size_t worst = 0;
    double least = 2 * psnr_cap;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        Differences d;
        decode(f, coded.tiles[i], tile);
        compare(tiles[i], tile, d);
        if (!tiles[i].whole() || d.empty() || d.psnr() >= least) continue;
        least = d.psnr();
        worst = i;
    }
    return worst;
}

Picture picture(const Bytes& tile) { return {tile_size, tile_size, tile, {}}; }

void show(const BenchScene& scene, const std::filesystem::path& folder, const std::vector<Tile>& tiles,
          const std::array<Coded, std::size(formats)>& all, std::vector<Measurement>& out) {
    const std::size_t tile = worst_tile(formats[1], all[1], tiles);
    const Bytes raw(tiles[tile].texels.begin(), tiles[tile].texels.end());
    Bytes other(tile_bytes);
    decode(formats[1], all[1].tiles[tile], other);
    const Window window = worst_window(picture(raw), picture(other));
    for (std::size_t f = 0; f < std::size(formats); ++f) {
        if (!formats[f].shown) continue;
        decode(formats[f], all[f].tiles[tile], other);
        out[f].exhibits.push_back(keep_exhibit(folder, scene.name + "-tiles-" + std::to_string(f),
                                               formats[f].name, picture(other), window));
    }
}

std::vector<Measurement> measure_formats(const BenchScene& scene, const Effort& effort,
                                         const std::filesystem::path& folder) {
    const gl::HeadlessContext context;
    const PackageReader package(scene.package);
    const std::vector<Tile> tiles = some_tiles(package, effort);
    if (tiles.empty()) return {};
    std::array<Coded, std::size(formats)> all;
    coded(formats[0], tiles);  // reads the tiles into memory, so that the disk is not timed
    for (std::size_t f = 0; f < std::size(formats); ++f) all[f] = coded(formats[f], tiles);
    if (all[0].differences.empty()) return {};  // nothing opaque
    Layers rgba(GL_SRGB8_ALPHA8, tile_size, 16);
    std::optional<Layers> bc1;
    if (epoxy_has_gl_extension("GL_EXT_texture_compression_s3tc"))
        bc1.emplace(GL_COMPRESSED_RGB_S3TC_DXT1_EXT, tile_size, 16);
    const auto ms = medians_in_turn(std::size(formats), effort.repeats, [&](std::size_t f) {
        return upload_ms(formats[f], all[f], tiles, rgba, bc1 ? &*bc1 : nullptr);
    });
    gl::check("uploading tiles");
    std::vector<Measurement> out;
    for (std::size_t f = 0; f < std::size(formats); ++f) {
        Measurement m;
        m.curve = "format";
        m.setting = formats[f].name;
        m.exact = formats[f].lossless;
        m.chosen = formats[f].chosen;
        // photo_ms is extrapolated from these tiles to all tiles of a photo.
        m.values = {{"psnr", all[f].differences.psnr()},
                    {"worst", all[f].differences.worst()},
                    {"texel_bytes", all[f].texel_bytes},
                    {"tile_ms", ms[f]},
                    {"photo_ms", all[f].encode_ms * tiles_per_photo(package)}};
        out.push_back(std::move(m));
    }
    show(scene, folder, tiles, all, out);
    return out;
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const std::filesystem::path& folder) {
    return {{"all", [=, &scene] { return measure_formats(scene, effort, folder); }}};
}

}  // namespace

extern const Sweep tile_format_sweep;
const Sweep tile_format_sweep{"tile-format",
                              "Tile formats",
                              "Tiles are stored as uncompressed texels for direct upload. What would a "
                              "compressed format save, and what would it cost?",
                              "the prepared texels of the photo",
                              "0 of 255",
                              {{"texel_bytes", "psnr"}, {"tile_ms", "psnr"}, {"texel_bytes", "worst"}},
                              jobs};

}  // namespace vantage::bench
