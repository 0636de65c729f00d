#include "player/pictures/orthophoto.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/cli/progress_line.h"
#include "base/cli/standard_output.h"
#include "base/files/make_folder.h"
#include "base/files/png_rows.h"
#include "base/files/replace_file.h"
#include "base/gl/context.h"
#include "base/text/error.h"
#include "base/text/formatted.h"
#include "base/text/lower_extension.h"
#include "player/pictures/tiff_rows.h"
#include "player/survey/survey.h"
#include "scene/package/contents/point_cloud.h"
#include "scene/package/output_file.h"
#include "scene/package/package_inputs.h"

namespace vantage {
namespace {

constexpr int tile_pixels = 1024;
constexpr std::int64_t max_row_bytes = std::int64_t(64) << 20;

/// The view of the whole picture; the views of its tiles only differ in size and principal point.
View view_of(const Orthophoto& o, const package::SceneRecord& scene) {
    const Eigen::Map<const Eigen::Vector3d> origin(scene.origin);
    const Eigen::Vector3d middle = origin - o.plane.origin;
    const double size = std::max(bounds_from_origin(scene).diagonal().norm(), o.resolution);
    View view = orthographic_view(Eigen::Vector3d::Zero(), o.plane.right, -o.plane.up, 1 / o.resolution, size,
                                  {o.width, o.height});
    view.intrinsics.cx = (o.plane.right.dot(middle) - o.upper_left.x()) / o.resolution;
    view.intrinsics.cy = (o.upper_left.y() - o.plane.up.dot(middle)) / o.resolution;
    return view;
}

/// A part of a view.
View cut(View view, int left, int top, int width, int height) {
    view.intrinsics.width = width;
    view.intrinsics.height = height;
    view.intrinsics.cx -= left;
    view.intrinsics.cy -= top;
    return view;
}

RenderSettings orthophoto_settings(const PackageReader& package, const OrthophotoOptions& o) {
    if (points_only(package.scene()))
        throw Error(Exit::usage, package.path().string() + ": has points only; an orthophoto needs a mesh");
    RenderSettings settings = render_settings(package, o.blending, Purpose::pictures);
    settings.photos = 0;  // a selection of photos would differ between tiles
    settings.background = ShowBackground::off;
    settings.points.show = false;
    settings.fill_holes = o.blending.holes == "shade";
    settings.fill_background = false;
    settings.light = light_settings(o.light);
    if (o.cuts.size() > max_sections)
        throw Error(Exit::usage, formatted("--cut: expected at most %zu planes", max_sections));
    const Eigen::Map<const Eigen::Vector3d> origin(package.scene().origin);
    for (const std::string& cut : o.cuts) settings.sections.push_back(parse_section(cut, origin));
    return settings;
}

struct Files {
    std::filesystem::path picture, world;  ///< `world` is empty for a TIFF, which includes the georeference
};

/// The output files, with links resolved. Throws Error(usage) if one of them must not be replaced.
Files output_files(const PackageReader& package, const OrthophotoOptions& o) {
    std::filesystem::path file = o.output.file;
    if (file.empty()) file = package.path().stem().string() + "-orthophoto.png";
    const Inputs inputs = inputs_of(package);
    if (lower_extension(file) == ".tif" || lower_extension(file) == ".tiff")
        return {output_file(file, Product::tiff, inputs, o.output.force), {}};
    if (lower_extension(file) != ".png")
        throw Error(Exit::usage, file.string() + ": expected a name that ends with .png or .tif");
    std::filesystem::path world = file;
    world.replace_extension(".pgw");
    return {output_file(file, Product::png, inputs, o.output.force),
            output_file(world, Product::world, inputs, o.output.force)};
}

}  // namespace

Orthophoto orthophoto_of(const PicturePlane& plane, const Eigen::AlignedBox2d& extent, double resolution) {
    constexpr double rounding = 1 - 1e-9;
    const Eigen::Vector2d pixels = (extent.sizes() * (rounding / resolution)).array().ceil().max(1);
    if (!(pixels.maxCoeff() <= PngRows::max_pixels))
        throw Error(
            Exit::usage,
            formatted(
                "--resolution %g: the picture would have %.6g x %.6g pixels, at most %d a side are possible",
                resolution, pixels.x(), pixels.y(), PngRows::max_pixels));
    return {plane, {extent.min().x(), extent.max().y()}, resolution, int(pixels.x()), int(pixels.y())};
}

TileSize tile_size_for(int width) {
    const std::int64_t rows = max_row_bytes / (4 * std::int64_t(width)) / 2 * 2;
    return {tile_pixels, int(std::clamp<std::int64_t>(rows, 16, tile_pixels))};
}

TilesNotShown draw_orthophoto(Renderer& renderer, const Orthophoto& o, const PictureSpec& spec, TileSize tile,
                              const std::function<void(std::span<const std::uint8_t>)>& row,
                              const std::function<void(std::size_t done, std::size_t all)>& progress) {
    const View whole = view_of(o, renderer.package().scene());
    const auto across = std::size_t((o.width + tile.width - 1) / tile.width),
               down = std::size_t((o.height + tile.height - 1) / tile.height);
    const std::size_t stride = 4 * std::size_t(o.width);
    TilesNotShown lacking;
    std::size_t done = 0;
    std::vector<std::uint8_t> rows(stride * std::size_t(std::min(tile.height, o.height)));
    for (int top = 0; top < o.height; top += tile.height) {
        const int height = std::min(tile.height, o.height - top);
        for (int left = 0; left < o.width; left += tile.width) {
            // All tiles have the same size, even at the border, to avoid another allocation.
            const View view =
                cut(whole, left, top, std::min(tile.width, o.width), std::min(tile.height, o.height));
            const Picture part = take_picture(renderer, view, spec.settings, spec.photos, spec.side);
            lacking.add(part.report);
            const int bytes = 4 * std::min(part.width, o.width - left);
            for (int y = 0; y < height; ++y)
                std::copy_n(part.rgba.begin() + std::ptrdiff_t(y) * part.width * 4, bytes,
                            rows.begin() + std::ptrdiff_t(stride) * y + std::ptrdiff_t(left) * 4);
            progress(++done, across * down);
        }
        for (std::size_t y = 0; y < std::size_t(height); ++y)
            row(std::span(rows).subspan(stride * y, stride));
    }
    return lacking;
}

int run_orthophoto(const PackageReader& package, const OrthophotoOptions& o) {
    const RenderSettings settings = orthophoto_settings(package, o);
    const PicturePlane plane = parse_plane(o.plane, up_of(package.scene()));
    const Orthophoto picture = orthophoto_of(
        plane, o.extent.empty() ? extent_on(plane, package.scene()) : parse_extent(o.extent), o.resolution);
    const Files files = output_files(package, o);
    const gl::HeadlessContext context;
    Renderer renderer(package, memory_budget(o.memory));
    if (files.picture.has_parent_path()) make_folder(files.picture.parent_path());
    const std::vector<std::uint32_t> photos = photos_in_use(package, o.package);
    TilesNotShown lacking;
    const auto write = [&](auto&& file) {
        ProgressLine progress(ProgressStyle::automatic, 10);
        lacking = draw_orthophoto(
            renderer, picture, {settings, photos, o.samples}, tile_size_for(picture.width),
            [&](std::span<const std::uint8_t> row) { file.add(row); },
            [&](std::size_t done, std::size_t all) {
                progress.show({"tiles", "", done, all});
            });
        file.finish();
    };
    if (files.world.empty()) {
        write(TiffRows(files.picture, picture.width, picture.height, picture.upper_left, picture.resolution));
    } else {
        write(PngRows(files.picture, picture.width, picture.height));
        replace_file(files.world, world_file_text(picture.upper_left, picture.resolution));
    }
    std::fprintf(text_output(), "%s  %dx%d, %g units per pixel, upper left corner %.10g, %.10g\n",
                 files.picture.c_str(), picture.width, picture.height, picture.resolution,
                 picture.upper_left.x(), picture.upper_left.y());
    results().update({{"file", files.picture.string()},
                      {"width", picture.width},
                      {"height", picture.height},
                      {"resolution", picture.resolution},
                      {"upper_left", {picture.upper_left.x(), picture.upper_left.y()}}});
    return exit_for(package, lacking);
}

}  // namespace vantage
