// Tiles of colour: how they are coded, how large they are, and how far they reach into their neighbours.
#include <squish.h>
#include <zstd.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <stdexcept>
#include <unordered_set>

#include "gl/context.h"
#include "gl/object.h"
#include "pipeline/ray_scene.h"
#include "pipeline/rgba_image.h"
#include "player/plan/sampling.h"
#include "scene/package_reader.h"
#include "scene/tiling.h"
#include "tests/bench/exhibit.h"
#include "tests/bench/statistics.h"
#include "tests/bench/sweep.h"
#include "tests/bench/timing.h"

namespace vantage::bench {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Texels = std::span<const std::uint8_t>;  ///< RGBA, row by row

constexpr double psnr_most = 100;

/// Differences of channels from what they should be, up to 255.
class Differences {
  public:
    void add(double difference) {
        squares_ += difference * difference;
        ++counts_[std::size_t(std::lround(std::min(std::abs(difference), 255.0) * steps))];
        ++all_;
    }
    bool empty() const { return all_ == 0; }
    double psnr() const {
        const double mean = squares_ / double(std::max(all_, std::uint64_t(1)));
        return mean > 0 ? std::min(psnr_most, 10 * std::log10(255 * 255 / mean)) : psnr_most;
    }
    /// What 99.9 % are no larger than.
    double worst() const {
        std::uint64_t up_to = 0;
        for (std::size_t i = 0; i < counts_.size(); ++i)
            if ((up_to += counts_[i]) * 1000 >= all_ * 999) return double(i) / steps;
        return 255;
    }

  private:
    static constexpr std::size_t steps = 16;  ///< to a grey level
    double squares_ = 0;
    std::uint64_t all_ = 0;
    std::vector<std::uint64_t> counts_ = std::vector<std::uint64_t>(255 * steps + 1);
};

// --- How tiles are coded

enum class Codec { raw, bc1_range, bc1_cluster, jpeg, png, zstd };

struct Format {
    const char* name;
    Codec codec;
    int quality = 0;
    bool lossless = false, chosen = false, shown = false;
    bool bc1() const { return codec == Codec::bc1_range || codec == Codec::bc1_cluster; }
};
// BC1 and JPEG have no place for alpha: what is transparent in a photo would need it beside them.
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

/// `tile` has a tile's size.
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

/// Layers of an array texture that tiles are put into, in turn.
class Layers {
  public:
    Layers(GLenum format, int size, int count)
        : texture_(gl::make_texture_array("tiles", format, size, size, count)), size_(size), count_(count) {}
    void put_rgba(const void* texels) {
        glTextureSubImage3D(texture_.id(), 0, 0, 0, next(), size_, size_, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                            texels);
        glFinish();
    }
    void put_bc1(Texels blocks) {
        glCompressedTextureSubImage3D(texture_.id(), 0, 0, 0, next(), size_, size_, 1,
                                      GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GLsizei(blocks.size()), blocks.data());
        glFinish();
    }

  private:
    int next() { return at_++ % count_; }
    gl::Texture texture_;
    int size_, count_, at_ = 0;
};

/// Of the photos that have tiles, at most `count`, evenly spread.
std::vector<std::uint32_t> some_photos(const PackageReader& package, std::size_t count) {
    std::vector<std::uint32_t> all, out;
    for (std::uint32_t i = 0; i < package.photos().size(); ++i)
        if (package.photos()[i].levels > 0) all.push_back(i);
    const std::size_t some = std::min(count, all.size());
    for (std::size_t i = 0; i < some; ++i) out.push_back(all[(2 * i + 1) * all.size() / (2 * some)]);
    return out;
}

/// A stored tile, and the part of it that is the photo's: beyond its edges the last texel is repeated.
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

/// Tiles of the photos' three finest levels, evenly spread over all of them.
std::vector<Tile> some_tiles(const PackageReader& package, const Effort& effort) {
    std::vector<Tile> all, out;
    for (const std::uint32_t photo : some_photos(package, effort.photos))
        for (std::uint32_t l = 0; l < std::min(3u, package.photos()[photo].levels); ++l) {
            const package::PhotoRecord& p = package.photos()[photo];
            const Level level = level_size(int(p.width), int(p.height), int(l));
            const auto* entry = package.find(package::Type::tiles, photo, l);
            for (std::size_t b = 0; entry && b < package.blocks(*entry); ++b)
                all.push_back(tile_of(package.block(*entry, b), level, int(b)));
        }
    const std::size_t most = std::clamp(effort.points / 200, std::size_t(8), std::size_t(300));
    const std::size_t some = std::min(most, all.size());
    for (std::size_t i = 0; i < some; ++i) out.push_back(all[(2 * i + 1) * all.size() / (2 * some)]);
    return out;
}

/// Tiles of a photo's whole pyramid, mean.
double tiles_a_photo(const PackageReader& package) {
    std::vector<double> out;
    for (const package::PhotoRecord& p : package.photos()) {
        double n = 0;
        for (std::uint32_t l = 0; l < p.levels; ++l)
            n += level_size(int(p.width), int(p.height), int(l)).tiles();
        if (n > 0) out.push_back(n);
    }
    return mean(out);
}

/// Opaque RGB of a tile beside what it should be.
void compare(const Tile& truth, const Bytes& tile, Differences& all) {
    for (int y = truth.top; y < truth.bottom; ++y)
        for (int x = truth.left; x < truth.right; ++x) {
            const std::size_t i = 4 * std::size_t(y * tile_size + x);
            for (std::size_t c = i; truth.texels[i + 3] == 255 && c < i + 3; ++c)
                all.add(double(truth.texels[c]) - double(tile[c]));
        }
}

/// A format's tiles, coded.
struct Coded {
    std::vector<Bytes> tiles;
    double encode_ms = 0;  ///< a tile
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

/// Milliseconds a tile, from its bytes in memory to a texture that the card has.
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

/// The tile that a format changes most, of those that lie in their photo as a whole; else the first.
std::size_t worst_tile(const Format& f, const Coded& coded, const std::vector<Tile>& tiles) {
    Bytes tile(tile_bytes);
    std::size_t worst = 0;
    double least = 2 * psnr_most;
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
    coded(formats[0], tiles);  // brings them into memory, so that no disk is timed
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
        // Coding all of a photo's tiles, scaled up from these.
        m.values = {{"psnr", all[f].differences.psnr()},
                    {"worst", all[f].differences.worst()},
                    {"texel_bytes", all[f].texel_bytes},
                    {"tile_ms", ms[f]},
                    {"photo_ms", all[f].encode_ms * tiles_a_photo(package)}};
        out.push_back(std::move(m));
    }
    show(scene, folder, tiles, all, out);
    return out;
}

// --- How large they are

/// A level of a photo, put together from its tiles.
RgbaImage level_image(const PackageReader& package, std::uint32_t photo, int level) {
    const package::PhotoRecord& record = package.photos()[photo];
    const Level size = level_size(int(record.width), int(record.height), level);
    RgbaImage out{size.width, size.height, Bytes(std::size_t(size.width) * std::size_t(size.height) * 4)};
    const auto* entry = package.find(package::Type::tiles, photo, std::uint32_t(level));
    for (int t = 0; entry && t < int(package.blocks(*entry)); ++t) {
        const auto block = package.block(*entry, std::size_t(t));
        const int x0 = t % size.columns() * tile_content, y0 = t / size.columns() * tile_content;
        const int w = std::min(tile_content, size.width - x0), h = std::min(tile_content, size.height - y0);
        for (int y = 0; y < h; ++y)
            std::memcpy(&out.rgba[4 * (std::size_t(y0 + y) * std::size_t(size.width) + std::size_t(x0))],
                        &block[4 * std::size_t((y + tile_border) * tile_size + tile_border)],
                        4 * std::size_t(w));
    }
    return out;
}

/// A square out of an image; its edges repeat their last texel.
Bytes cut(const RgbaImage& image, int x0, int y0, int size) {
    Bytes out(std::size_t(size) * std::size_t(size) * 4);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const std::size_t from =
                std::size_t(std::clamp(y0 + y, 0, image.height - 1)) * std::size_t(image.width) +
                std::size_t(std::clamp(x0 + x, 0, image.width - 1));
            std::memcpy(&out[4 * (std::size_t(y) * std::size_t(size) + std::size_t(x))],
                        &image.rgba[4 * from], 4);
        }
    return out;
}

/// Texels of a photo's level in squares of 8, which every tile's content is a multiple of.
constexpr int block_size = 8;
struct Block {
    std::uint32_t photo, level, x, y;
    std::uint64_t key() const {
        return std::uint64_t(photo) << 40 | std::uint64_t(level) << 34 | std::uint64_t(x) << 17 | y;
    }
};
using Blocks = std::unordered_set<std::uint64_t>;

/// A photo that a view may show.
struct Source {
    std::uint32_t photo;
    int levels;
    Intrinsics k;
    Pose pose;
    Eigen::Vector3d center;
};

/// The package's model for casting rays.
struct Surface {
    std::vector<Eigen::Vector3f> positions;
    std::vector<std::uint32_t> indices;
    RayScene rays;
};

Surface surface(const PackageReader& package) {
    std::vector<Eigen::Vector3f> positions;
    for (const auto& p : package.records<std::array<float, 3>>(package::Type::positions))
        positions.emplace_back(p[0], p[1], p[2]);
    const auto indices = package.records<std::uint32_t>(package::Type::indices);
    RayScene rays(positions, indices);
    return {std::move(positions), {indices.begin(), indices.end()}, std::move(rays)};
}

/// The blocks that a trilinear sample of the photo takes.
void mark(const Source& source, const SurfaceSample& sample, const Eigen::Vector2d& pixel, Blocks& out) {
    // As footprint_of() and color_at() in the shaders.
    const double lod =
        std::clamp(level_of_detail(sample, source.k, source.pose) - 0.02, 0.0, double(source.levels - 1));
    for (int l = int(lod); l <= int(std::ceil(lod)); ++l) {
        const double scale = 1.0 / (block_size << l);
        out.insert(Block{source.photo, std::uint32_t(l), std::uint32_t(pixel.x() * scale),
                         std::uint32_t(pixel.y() * scale)}
                       .key());
    }
}

/// Marks what up to four photos show of a point: those nearest in angle of the ones that see it.
void mark_point(const Surface& surface, const std::vector<Source>& sources, const View& view,
                const Eigen::Vector3d& p, const Eigen::Vector3d& normal, Blocks& out) {
    const auto sample = surface_sample(view, p, normal, 1);
    if (!sample) return;
    const Eigen::Vector3d to_eye = (view.cam_from_origin.center() - p).normalized();
    std::vector<std::pair<double, const Source*>> by_angle;
    for (const Source& s : sources) {
        const Eigen::Vector3d to_photo = s.center - p;
        // Photos from behind show the surface's other side.
        if (normal.dot(to_photo) * normal.dot(to_eye) > 0)
            by_angle.emplace_back(-to_photo.normalized().dot(to_eye), &s);
    }
    std::sort(by_angle.begin(), by_angle.end());
    int photos = 0;
    for (const auto& [angle, s] : by_angle) {
        const auto seen = project(s->k, s->pose, p);
        const double almost_there = 1 - 0.3 / std::max(s->k.fx, s->k.fy);
        if (!seen || !in_frame(s->k, seen->pixel) ||
            surface.rays.occluded(s->center, p - s->center, 0, almost_there))
            continue;
        mark(*s, *sample, seen->pixel, out);
        if (++photos == 4) return;
    }
}

/// The blocks that a view shows, by a ray every `step` pixels.
Blocks shown_blocks(const PackageReader& package, const Surface& surface, const TrueView& view, int step) {
    std::vector<Source> sources;
    for (const std::uint32_t i : view.photos) {
        const package::PhotoRecord& p = package.photos()[i];
        const Pose pose = cam_from_origin(p);
        if (p.levels > 0) sources.push_back({i, int(p.levels), intrinsics(p), pose, pose.center()});
    }
    const Intrinsics& k = view.view.intrinsics;
    const Pose& pose = view.view.cam_from_origin;
    const Eigen::Vector3d eye = pose.center();
    Blocks out;
    for (int y = step / 2; y < k.height; y += step)
        for (int x = step / 2; x < k.width; x += step) {
            const Eigen::Vector3d ray =
                pose.R.transpose() * Eigen::Vector3d((x + 0.5 - k.cx) / k.fx, (y + 0.5 - k.cy) / k.fy, 1);
            const auto hit = surface.rays.first_hit(eye, ray);
            if (!hit) continue;
            const auto corner = [&](std::size_t i) -> Eigen::Vector3d {
                return surface.positions[surface.indices[3 * hit->triangle + i]].cast<double>();
            };
            const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
            mark_point(surface, sources, view.view, eye + hit->distance * ray, normal, out);
        }
    return out;
}

/// Bytes of the tiles that hold these blocks, the border around each tile's content included.
double tile_bytes_of(const Blocks& blocks, int size) {
    if (size == block_size) return double(blocks.size()) * size * size * 4;
    constexpr std::uint64_t mask = (1u << 17) - 1;
    const std::uint64_t content = std::uint64_t((size - 2 * tile_border) / block_size);
    Blocks tiles;
    for (const std::uint64_t b : blocks)
        tiles.insert((b & ~(mask << 17 | mask)) | (b >> 17 & mask) / content << 17 | (b & mask) / content);
    return double(tiles.size()) * size * size * 4;
}

/// Tiles of a size, cut out of an image: some 16 MB, so that they are not all in the processor's caches.
std::vector<Bytes> cut_some(const RgbaImage& image, int size) {
    const int count = std::clamp((1 << 22) / (size * size), 4, 256);
    std::vector<Bytes> out;
    for (int i = 0; i < count; ++i)
        out.push_back(cut(image, i * size % image.width, i * size / image.width * size, size));
    return out;
}

// The first has no border: what is shown, as if that could be read alone.
constexpr int tile_sizes[] = {block_size, 64, 128, 256, 512, 1024};

/// Milliseconds to upload a tile, by size.
std::vector<double> upload_ms(const RgbaImage& image, int repeats) {
    std::vector<std::vector<Bytes>> tiles;
    std::vector<Layers> layers;
    for (const int size : tile_sizes) {
        tiles.push_back(cut_some(image, size));
        layers.emplace_back(GL_SRGB8_ALPHA8, size, 4);
        for (int i = 0; i < 4; ++i)
            layers.back().put_rgba(tiles.back()[0].data());  // its memory is there now
    }
    std::vector<double> ms = medians_in_turn(std::size(tile_sizes), repeats, [&](std::size_t s) {
        return milliseconds([&] {
            for (const Bytes& t : tiles[s]) layers[s].put_rgba(t.data());
        });
    });
    for (std::size_t s = 0; s < ms.size(); ++s) ms[s] /= double(tiles[s].size());
    return ms;
}

std::vector<Measurement> measure_sizes(const BenchScene& scene, const Effort& effort) {
    const gl::HeadlessContext context;
    const PackageReader package(scene.package);
    const std::vector<std::uint32_t> photos = some_photos(package, 1);
    const auto triangles = package.records<std::uint32_t>(package::Type::indices, package::scene_wide, false);
    if (photos.empty() || triangles.empty() || scene.views.empty()) return {};
    const Surface model = surface(package);
    std::vector<Blocks> shown;
    for (const TrueView& v : scene.views)
        shown.push_back(shown_blocks(package, model, v, effort.points < 20000 ? 4 : 2));
    const std::vector<double> ms = upload_ms(level_image(package, photos[0], 0), effort.repeats);
    gl::check("uploading tiles");
    std::vector<Measurement> out;
    for (std::size_t s = 0; s < std::size(tile_sizes); ++s) {
        const int size = tile_sizes[s];
        std::vector<double> read;
        for (const Blocks& b : shown) read.push_back(tile_bytes_of(b, size));
        Measurement m;
        m.curve = "tile size";
        m.exact = size == block_size;
        m.chosen = size == tile_size;
        m.setting = m.exact ? "8x8, what is shown" : std::to_string(size);
        m.values = {{"read_bytes", mean(read)}, {"tile_ms", ms[s]}};
        out.push_back(std::move(m));
    }
    return out;
}

// --- How far they reach into their neighbours

/// A level cut into tiles of 256 texels of which `border` on each side are the neighbours'.
struct Cut {
    int content, columns;
    std::vector<RgbaImage> tiles;
};

Cut cut_all(const RgbaImage& image, int border) {
    const int content = tile_size - 2 * border;
    Cut out{content, (image.width + content - 1) / content, {}};
    for (int y = 0; y < image.height; y += content)
        for (int x = 0; x < image.width; x += content)
            out.tiles.push_back({tile_size, tile_size, cut(image, x - border, y - border, tile_size)});
    return out;
}

/// Linear between four texels, clamped at the image's edges; alpha, too.
std::array<double, 4> bilinear(const RgbaImage& image, double x, double y) {
    const double fx = std::floor(x - 0.5), fy = std::floor(y - 0.5), s = x - 0.5 - fx, t = y - 0.5 - fy;
    const auto texel = [&](int i, int j) {
        return &image.rgba[4 * (std::size_t(std::clamp(int(fy) + j, 0, image.height - 1)) *
                                    std::size_t(image.width) +
                                std::size_t(std::clamp(int(fx) + i, 0, image.width - 1)))];
    };
    std::array<double, 4> out;
    for (std::size_t c = 0; c < 4; ++c)
        out[c] = (1 - t) * ((1 - s) * texel(0, 0)[c] + s * texel(1, 0)[c]) +
                 t * ((1 - s) * texel(0, 1)[c] + s * texel(1, 1)[c]);
    return out;
}

/// Samples through the tiles beside samples of the whole, at random places.
void compare(const RgbaImage& whole, int border, std::size_t points, Differences& all) {
    const Cut tiles = cut_all(whole, border);
    std::mt19937 engine(3);
    // 256ths of a texel, as graphics cards have it, so that rounding does not count.
    const auto place = [&](int length) { return double(engine() % (std::uint32_t(length) * 256)) / 256; };
    for (std::size_t i = 0; i < points; ++i) {
        const double x = place(whole.width), y = place(whole.height);
        const int column = int(x) / tiles.content, row = int(y) / tiles.content;
        const auto truth = bilinear(whole, x, y);
        if (truth[3] < 255) continue;
        const auto found = bilinear(tiles.tiles[std::size_t(row * tiles.columns + column)],
                                    x - column * tiles.content + border, y - row * tiles.content + border);
        for (std::size_t c = 0; c < 3; ++c) all.add(found[c] - truth[c]);
    }
}

std::vector<Measurement> measure_borders(const BenchScene& scene, const Effort& effort) {
    const PackageReader package(scene.package);
    constexpr int borders[] = {0, 1, 2, 4, 8};
    std::array<Differences, std::size(borders)> all;
    for (const std::uint32_t photo : some_photos(package, effort.photos)) {
        const RgbaImage whole = level_image(package, photo, 0);
        for (std::size_t b = 0; b < std::size(borders); ++b)
            compare(whole, borders[b], effort.points, all[b]);
    }
    if (all[0].empty()) return {};
    std::vector<Measurement> out;
    for (std::size_t b = 0; b < std::size(borders); ++b) {
        const double share = double(tile_size) / (tile_size - 2 * borders[b]);
        Measurement m;
        m.curve = "border";
        m.setting = std::to_string(borders[b]);
        m.exact = borders[b] >= 1;  // four texels reach half a texel beyond the tile's own
        m.chosen = borders[b] == tile_border;
        m.values = {{"psnr", all[b].psnr()}, {"worst", all[b].worst()}, {"texel_bytes", 4 * share * share}};
        out.push_back(std::move(m));
    }
    return out;
}

std::vector<Job> jobs(const BenchScene& scene, const Effort& effort, const std::filesystem::path& folder) {
    return {{"format", [=, &scene] { return measure_formats(scene, effort, folder); }},
            {"size", [=, &scene] { return measure_sizes(scene, effort); }},
            {"border", [=, &scene] { return measure_borders(scene, effort); }}};
}

}  // namespace

extern const Sweep tile_format_sweep;
const Sweep tile_format_sweep{"tiles",
                              "Tiles of colour",
                              "Tiles are stored as the graphics card takes them, 256 texels wide, with 4 of "
                              "their neighbours'. What would "
                              "a coded format, another size or another border give and cost?",
                              "the photo's texels as they were prepared",
                              "0 of 255",
                              {{"texel_bytes", "psnr", true, false},
                               {"tile_ms", "psnr", true, false},
                               {"texel_bytes", "worst", true, false},
                               {"tile_ms", "read_bytes", true, true}},
                              jobs,
                              true};

}  // namespace vantage::bench
