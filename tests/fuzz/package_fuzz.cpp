// Malicious packages: a valid package with some bytes overwritten and all checksums recomputed, so that the
// checksums do not shield the code that reads the values. An input is a list of 16-byte edits: chunk, width,
// position and value.
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <vector>

#include "base/files/checksum.h"
#include "base/text/error.h"
#include "player/plan/plan.h"
#include "player/plan/plan_scene.h"
#include "player/plan/point_plan.h"
#include "player/stream/photo_pages.h"
#include "scene/package/contents/scalar_field.h"
#include "scene/package/package_shape.h"
#include "tests/fuzz/support/fuzz_target.h"
#include "tests/fuzz/support/memory_file.h"
#include "tests/fuzz/support/valid_package.h"

using namespace vantage;
using package::DirectoryEntry;
using package::Type;

namespace {

struct Edit {
    std::uint16_t chunk;  ///< 0xffff: the header, 0xfffe: the directory
    std::uint16_t width;  ///< number of bytes minus one, modulo 8
    std::uint32_t at;
    std::uint64_t value;
};
static_assert(sizeof(Edit) == 16);

void apply(const Edit& edit, const fuzz::ValidPackage& valid, std::vector<std::uint8_t>& b) {
    std::uint64_t at = 0, length = sizeof(package::Header);
    if (edit.chunk == 0xfffe) {
        at = valid.header.directory_offset, length = valid.entries.size() * sizeof(DirectoryEntry);
    } else if (edit.chunk != 0xffff) {
        const DirectoryEntry& e = valid.entries[edit.chunk % valid.entries.size()];
        at = e.offset, length = e.head_length;
    }
    const std::uint64_t place = edit.at % length;
    std::memcpy(b.data() + at + place, &edit.value,
                std::min<std::uint64_t>(edit.width % 8 + 1, length - place));
}

volatile unsigned sink;

void touch(std::span<const std::byte> bytes) {
    if (!bytes.empty()) sink = unsigned(bytes.front()) + unsigned(bytes.back());
}

/// Plans views and reads all data needed to draw them, as the player does.
void play(const PackageReader& package) {
    const PlanScene scene = make_plan_scene(package);
    const PackagePages pages = number_pages(scene.photos);
    std::vector<std::uint32_t> photos(scene.photos.size());
    std::iota(photos.begin(), photos.end(), 0u);
    const View view = scene.photos.empty()
                          ? view_towards({0, 0, -3}, {0, 0, 0}, {0, 1, 0}, 40, 64, 48)
                          : view_of_photo(scene.photos[0], std::min(1.0, 64.0 / scene.photos[0].width));
    const std::vector<std::uint32_t> seen{1, 2, 0, 1, 0xffffffffu};
    for (const Plan& plan :
         {make_plan(scene, view, {}, photos), make_plan(scene, view, {}, photos, {.seen = seen})})
        for (const PlannedPhoto& p : plan.photos)
            for (std::uint32_t l = 0; l < max_levels; ++l) {
                for (const std::uint32_t t : p.needs.color[l]) {
                    const StreamRequest r = color_request(package, pages, p.photo, l, t);
                    touch(package.block(*r.chunk, r.block));
                }
                for (const std::uint32_t t : p.needs.weight_maps[l]) {
                    const StreamRequest r = weight_map_request(package, pages, p.photo, l, t);
                    touch(package.block(*r.chunk, r.block));
                    touch(package.block(*r.second, r.block));
                }
            }
    for (const ScalarField& field : read_fields(package))
        for (const bool logarithmic : {false, true}) {
            const ValueRange range = whole_range(field, true, logarithmic);
            if (!(range.low < range.high)) std::abort();
        }
    if (const auto cloud = read_point_cloud(package)) {
        const PointPlan plan = plan_points(*cloud, view, 1000, 1);
        depth_range(*cloud, plan, view, 10);
        for (const DrawnNode& n : drawn_nodes(*cloud, plan, [](std::uint32_t node) { return node != 2; })) {
            const package::PointNode& node = cloud->nodes.at(n.node);
            touch(package.block(*package.find(Type::points), node.block)
                      .subspan(node.first * sizeof(package::PackedPoint),
                               node.count * sizeof(package::PackedPoint)));
        }
    }
    for (std::uint32_t i = 0; i < scene.photos.size(); ++i)
        if (scene.photos[i].levels) touch(package.bytes(thumbnail_request(package, i).chunk));
}

}  // namespace

FUZZ_TARGET(package)(const std::uint8_t* data, std::size_t size) {
    static const fuzz::ValidPackage valid;
    static fuzz::MemoryFile file;
    static std::vector<std::uint8_t> bytes;
    if (bytes.empty()) file.set(bytes = valid.bytes);
    for (const auto& [at, length] : valid.parts)  // undo the previous edits
        std::copy_n(valid.bytes.begin() + std::ptrdiff_t(at), length, bytes.begin() + std::ptrdiff_t(at));
    for (std::size_t i = 0; i + sizeof(Edit) <= size && i < 32 * sizeof(Edit); i += sizeof(Edit)) {
        Edit edit;
        std::memcpy(&edit, data + i, sizeof edit);
        apply(edit, valid, bytes);
    }
    fuzz::fix_checksums(bytes);
    for (const auto& [at, length] : valid.parts) file.write(at, std::span(bytes).subspan(at, length));
    try {
        const PackageReader package(file.path());
        for (const DirectoryEntry& e : package.directory()) {
            touch(package.bytes(&e));
            if (!describe(e, package).empty() && package.blocks(e) > 0) touch(package.block(e, 0));
        }
        play(package);
        if (size == 0) return 0;
    } catch (const Error& e) {
        if (size > 0) return 0;
        std::fprintf(stderr, "refused unedited: %s\n", e.what());
        std::abort();
    }
    return 0;
}
