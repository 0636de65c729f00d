#include "pipeline/stages/tile_levels.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/values/bytes_of.h"
#include "base/values/halve.h"
#include "pipeline/photos/reduced.h"
#include "pipeline/stages/cut_tile.h"
#include "scene/codec/byte_planes.h"
#include "scene/codec/depth_values.h"
#include "scene/codec/jpeg_cells.h"
#include "scene/codec/jpeg_header.h"
#include "scene/codec/jpeg_pixels.h"

namespace vantage {
namespace {

using package::Form;
using package::Type;

constexpr int thumbnail_quality = 95;  ///< of JPEG

/// The texels of a tile without its border, packed.
std::vector<std::byte> cut_inner_part(const LevelTexels& level, std::size_t tile) {
    const TilePart part = inner_part(level.size, tile);
    const auto left = std::size_t(tile_left(level.size, tile) + part.left),
               top = std::size_t(tile_top(level.size, tile) + part.top), width = std::size_t(part.width());
    std::vector<std::byte> out;
    out.reserve(4 * width * std::size_t(part.height()));
    for (std::size_t y = top; y < top + std::size_t(part.height()); ++y) {
        const auto row = level.texels.subspan(4 * (y * std::size_t(level.size.width) + left), 4 * width);
        out.insert(out.end(), row.begin(), row.end());
    }
    return out;
}

Form form_for(Type type, std::span<const std::byte> texels) {
    if (type == Type::depth) return Form::depth;
    return type == Type::tiles && is_opaque(texels) ? Form::jpeg : Form::planes;
}

/// Adds a picture to the blocks, which share the header of the first picture.
void add_jpeg(std::span<const std::byte> rgba, int width, int height, int quality, CodedBlocks& out) {
    const std::vector<std::byte> jpeg = codec::encode_jpeg(rgba, width, height, quality);
    const auto header = codec::parse_jpeg_header(jpeg);
    if (!header) throw std::logic_error("libjpeg-turbo wrote a JPEG of an unexpected kind");
    const std::span all(jpeg);
    if (out.ends.empty()) out.shared.assign(jpeg.begin(), jpeg.begin() + std::ptrdiff_t(header->bytes));
    out.add(all.subspan(header->bytes));
}

/// Returns false if the tile cannot be stored in this form.
bool add_tile(std::span<const std::byte> texels, int width, int height, int quality, CodedBlocks& out) {
    if (out.form == Form::jpeg) {
        add_jpeg(texels, width, height, quality, out);
        return true;
    }
    const auto block = out.form == Form::depth ? codec::encode_depth(texels, width, height)
                                               : codec::encode_planes(texels, width, height);
    out.add(block);
    return !block.empty();
}

bool write_coded_tiles(PackageWriter& writer, Type type, std::uint32_t photo, std::uint32_t level,
                       const LevelTexels& of, int quality) {
    CodedBlocks blocks{.form = form_for(type, of.texels)};
    for (std::size_t tile = 0; tile < std::size_t(of.size.tiles()); ++tile) {
        const TilePart part = inner_part(of.size, tile);
        if (!add_tile(cut_inner_part(of, tile), part.width(), part.height(), quality, blocks)) return false;
    }
    return writer.write_coded(type, photo, level, blocks);
}

}  // namespace

int level_quality(std::span<const std::byte> jpeg, std::uint32_t level) {
    if (level == 0) return color_quality;  // compressed once more than the photo's own JPEG
    const double coarse = std::ldexp(codec::quantization_of(jpeg), -int(level));
    // The formula by which libjpeg scales its quantization tables.
    const double quality = coarse < 1 ? 100 - 50 * coarse : 50 / coarse;
    return std::clamp(int(std::lround(quality)), 1, color_quality);
}

bool write_own_jpeg(PackageWriter& writer, std::uint32_t photo, std::span<const std::byte> jpeg) {
    if (!writer.compact(Type::tiles, photo, 0)) return false;
    auto cells = codec::divide_jpeg(jpeg);
    if (!cells) return false;
    return writer.write_coded(
        Type::tiles, photo, 0,
        {Form::cells, std::move(cells->header), std::move(cells->bytes), std::move(cells->ends)});
}

void write_thumbnail(PackageWriter& writer, std::uint32_t photo, const LevelTexels& of) {
    if (writer.compact(Type::thumbnail, photo) && is_opaque(of.texels)) {
        CodedBlocks block{.form = Form::jpeg};
        add_jpeg(of.texels, of.size.width, of.size.height, thumbnail_quality, block);
        if (writer.write_coded(Type::thumbnail, photo, 0, block)) return;
    }
    writer.write(Type::thumbnail, photo, of.texels);
}

void write_tiles(PackageWriter& writer, package::Type type, std::uint32_t photo, std::uint32_t level,
                 const LevelTexels& of, int quality) {
    if (writer.compact(type, photo, level) && write_coded_tiles(writer, type, photo, level, of, quality))
        return;
    writer.write_blocks(type, photo, level, [&](std::size_t number, std::span<std::byte> tile) {
        cut_tile(of.texels, of.size, number, tile);
    });
}

RgbaImage as_stored(const PackageWriter& writer, std::uint32_t photo, std::uint32_t level,
                    const RgbaImage& image, int quality) {
    const auto texels = std::as_bytes(std::span(image.rgba));
    if (!writer.compact(Type::tiles, photo, level) || !is_opaque(texels)) return image;
    const Level size{image.width, image.height};
    RgbaImage out{image.width, image.height, std::vector<std::uint8_t>(image.rgba.size())};
    std::vector<std::byte> decoded;
    for (std::size_t tile = 0; tile < std::size_t(size.tiles()); ++tile) {
        const TilePart part = inner_part(size, tile);
        const auto jpeg =
            codec::encode_jpeg(cut_inner_part({texels, size}, tile), part.width(), part.height(), quality);
        decoded.resize(4 * std::size_t(part.width()) * std::size_t(part.height()));
        if (!codec::decode_jpeg(jpeg, part.width(), part.height(), decoded))
            throw std::logic_error("libjpeg-turbo cannot read a JPEG that it wrote");
        copy_content(decoded, part, size, tile, std::as_writable_bytes(std::span(out.rgba)));
    }
    return out;
}

void make_tiles(LevelInput& in) {
    if (in.level >= in.record.levels) return;
    if (in.level == 0 && !in.jpeg.empty() && write_own_jpeg(in.writer, in.photo, in.jpeg)) return;
    write_tiles(in.writer, package::Type::tiles, in.photo, in.level,
                {bytes_of(in.image.rgba), {in.image.width, in.image.height}},
                level_quality(in.jpeg, in.level));
}

void make_thumbnail(LevelInput& in) {
    const Level size{int(in.record.thumbnail_width), int(in.record.thumbnail_height)};
    const int wanted = std::max(size.width, size.height), here = std::max(in.image.width, in.image.height),
              next = (here + 1) / 2;
    const bool is_first_too_coarse = next < wanted && (in.level == 0 || here >= wanted);
    if (!is_first_too_coarse && !(in.last && next >= wanted)) return;
    const RgbaImage small = reduced(in.image, size);
    write_thumbnail(in.writer, in.photo, {bytes_of(small.rgba), size});
}

}  // namespace vantage
