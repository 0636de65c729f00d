// Tests compact packages: tiles that contain the photos' own JPEG data, and other compact chunks.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include "base/files/part_file.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/prepare/repack_package.h"
#include "pipeline/reports/check.h"
#include "pipeline/reports/extract.h"
#include "scene/agreement/read_level.h"
#include "scene/codec/depth_values.h"
#include "scene/codec/jpeg_pixels.h"
#include "scene/package/contents/stored_tile.h"
#include "tests/datasets.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;
using package::Type;

namespace {

using Bytes = std::vector<char>;

Bytes content(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

class CompactPackages : public TemporaryFolder {
  protected:
    /// Effects that depend on the photos are off, so that both forms have the same cameras and weights.
    static PrepareSettings settings(EffectChoice compact, unsigned threads = 2) {
        PrepareSettings s;
        s.effects[Effect::compact] = compact;
        s.threads = threads;
        for (const EffectRow& row : effect_table())
            if (from_all_photos(row)) s.effects[row.effect] = EffectChoice::off;
        return s;
    }
    static void make_anew(const std::filesystem::path& scan, const PrepareSettings& s,
                          const std::filesystem::path& out) {
        prepare(read_scene(discover(scan)), s, out, [](const Progress&) {});
    }
    static std::vector<std::byte> level(const PackageReader& p, Type type, std::uint32_t photo, int l) {
        return read_level(p, p.photos()[photo], photo, type, l);
    }
    static void expect_valid_package(const std::filesystem::path& file) {
        for (const Issue& issue : check_package(file, {.deep = true})) ADD_FAILURE() << issue.text;
    }
};

double psnr(const std::vector<std::byte>& a, const std::vector<std::byte>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double d = std::to_integer<int>(a[i]) - std::to_integer<int>(b[i]);
        sum += i % 4 == 3 ? 0 : d * d;
    }
    return 10 * std::log10(255.0 * 255.0 * 0.75 * double(a.size()) / std::max(sum, 1e-9));
}

}  // namespace

TEST_F(CompactPackages, ShowThePhotosOwnPixelsAndTheSameMasks) {
    VANTAGE_DATASET(scan, "sceaux-small");
    copy_package(scan, settings(EffectChoice::off), dir / "raw.vantage");
    copy_package(scan, settings(EffectChoice::on), dir / "compact.vantage");
    expect_valid_package(dir / "compact.vantage");
    const PackageReader raw(dir / "raw.vantage"), compact(dir / "compact.vantage");
    EXPECT_LT(compact.size(), raw.size() / 6);
    ASSERT_EQ(raw.photos().size(), compact.photos().size());
    for (std::uint32_t i = 0; i < raw.photos().size(); ++i) {
        const int levels = int(raw.photos()[i].levels);
        EXPECT_EQ(level(raw, Type::tiles, i, 0), level(compact, Type::tiles, i, 0)) << i;
        for (int l = 1; l < levels; ++l)
            EXPECT_GT(psnr(level(raw, Type::tiles, i, l), level(compact, Type::tiles, i, l)), 42) << i;
        for (int l = weight_map_level; l < weight_map_levels_end(levels); ++l) {
            EXPECT_EQ(level(raw, Type::weight_maps, i, l), level(compact, Type::weight_maps, i, l)) << i;
            const auto x = level(raw, Type::depth, i, l), y = level(compact, Type::depth, i, l);
            for (std::size_t at = 0; at < x.size(); at += 4) {
                float exact, kept;
                std::memcpy(&exact, &x[at], 4);
                std::memcpy(&kept, &y[at], 4);
                ASSERT_EQ(std::isinf(exact), std::isinf(kept));
                if (std::isinf(exact)) continue;
                ASSERT_LE(std::abs(double(exact) - double(kept)), codec::depth_error * double(exact));
            }
        }
    }
}

TEST_F(CompactPackages, AreTheDefaultUnlessPhotosTakeMoreThanRawTiles) {
    VANTAGE_DATASET(scan, "sceaux-small");
    PrepareSettings automatic = settings(EffectChoice::automatic);
    copy_package(scan, automatic, dir / "default.vantage");
    EXPECT_TRUE(effect_on(PackageReader(dir / "default.vantage").scene(), Effect::compact));
    PrepareSettings reduced = automatic;
    reduced.photo_size = 640;
    copy_package(scan, reduced, dir / "reduced.vantage");
    EXPECT_TRUE(effect_on(PackageReader(dir / "reduced.vantage").scene(), Effect::compact));
    std::filesystem::copy(scan, dir / "large", std::filesystem::copy_options::recursive);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(dir / "large"))
        if (entry.path().extension() == ".jpg") {
            std::filesystem::permissions(entry.path(), std::filesystem::perms::owner_all);
            std::filesystem::resize_file(entry.path(), 50'000'000);  // zeros after the picture
        }
    make_anew(dir / "large", automatic, dir / "large.vantage");
    EXPECT_FALSE(effect_on(PackageReader(dir / "large.vantage").scene(), Effect::compact));
}

TEST_F(CompactPackages, GeometryIsTheSameAfterItsMemoryWasGivenBack) {
    VANTAGE_DATASET(scan, "sceaux-small");
    copy_package(scan, settings(EffectChoice::on), dir / "compact.vantage");
    const PackageReader package(dir / "compact.vantage");
    ASSERT_EQ(package.find(Type::positions)->form, package::Form::zstd);
    const auto positions = package.records<Eigen::Vector3f>(Type::positions);
    const std::vector<Eigen::Vector3f> before(positions.begin(), positions.end());
    package.forget(std::as_bytes(positions));
    EXPECT_TRUE(std::ranges::equal(package.records<Eigen::Vector3f>(Type::positions), before));
}

TEST_F(CompactPackages, AreTheSameBytesOnAnyNumberOfThreadsAndAfterAnInterruption) {
    VANTAGE_DATASET(scan, "sceaux-small");
    make_anew(scan, settings(EffectChoice::on, 1), dir / "one.vantage");
    const Bytes expected = content(dir / "one.vantage");
    make_anew(scan, settings(EffectChoice::on, 3), dir / "three.vantage");
    EXPECT_TRUE(content(dir / "three.vantage") == expected);

    std::atomic<bool> stop = false;
    const auto stopping = [&](const Progress& p) {
        stop = stop || (std::string_view(p.stage) == "photos" && p.done == 3);
    };
    PrepareRun run;
    run.stop = &stop;
    EXPECT_THROW(
        prepare(read_scene(discover(scan)), settings(EffectChoice::on), dir / "late.vantage", stopping, run),
        Error);
    EXPECT_TRUE(std::filesystem::exists(part_of(dir / "late.vantage")));
    make_anew(scan, settings(EffectChoice::on), dir / "late.vantage");
    EXPECT_TRUE(content(dir / "late.vantage") == expected);
    EXPECT_FALSE(std::filesystem::exists(part_of(dir / "late.vantage")));
    EXPECT_FALSE(std::filesystem::exists(packing_of(dir / "late.vantage")));
}

TEST_F(CompactPackages, AreRepackedFromRawAndBack) {
    VANTAGE_DATASET(scan, "sceaux-small");
    copy_package(scan, settings(EffectChoice::on), dir / "compact.vantage");
    repack(dir / "compact.vantage", false, dir / "raw.vantage");
    repack(dir / "raw.vantage", true, dir / "again.vantage");
    for (const char* file : {"raw.vantage", "again.vantage"}) expect_valid_package(dir / file);
    const PackageReader compact(dir / "compact.vantage"), raw(dir / "raw.vantage"),
        again(dir / "again.vantage");
    EXPECT_LT(again.size(), raw.size() / 6);
    for (std::uint32_t i = 0; i < raw.photos().size(); ++i) {
        EXPECT_EQ(level(raw, Type::tiles, i, 0), level(compact, Type::tiles, i, 0));
        EXPECT_GT(psnr(level(raw, Type::tiles, i, 0), level(again, Type::tiles, i, 0)), 40);
        for (const Type type : {Type::weight_maps, Type::depth})
            EXPECT_EQ(level(again, type, i, weight_map_level), level(compact, type, i, weight_map_level));
    }
}

TEST_F(CompactPackages, GiveThePhotosBackAsJpeg) {
    VANTAGE_DATASET(scan, "sceaux-small");
    copy_package(scan, settings(EffectChoice::on), dir / "compact.vantage");
    for (int twice = 0; twice < 2; ++twice) extract(dir / "compact.vantage", dir / "files", {}, false);
    const PackageReader package(dir / "compact.vantage");
    std::size_t compared = 0;
    for (const package::PhotoRecord& p : package.photos()) {
        const auto pixels = [&](const std::filesystem::path& file) {
            const Bytes jpeg = content(file);
            std::vector<std::byte> rgba(std::size_t(p.width) * p.height * 4);
            EXPECT_TRUE(
                codec::decode_jpeg(std::as_bytes(std::span(jpeg)), int(p.width), int(p.height), rgba));
            return rgba;
        };
        const std::filesystem::path given = dir / "files" / "photos" / p.name;
        EXPECT_TRUE(pixels(given) == pixels(std::filesystem::path(scan) / "images" / p.name)) << p.name;
        ++compared;
    }
    EXPECT_GT(compared, 1);
    std::filesystem::copy_file(std::filesystem::path(scan) / "images" / package.photos()[0].name,
                               dir / "files" / "photos" / package.photos()[0].name,
                               std::filesystem::copy_options::overwrite_existing);
    EXPECT_THROW(extract(dir / "compact.vantage", dir / "files", {}, false), Error)
        << "not a folder that extract wrote";
}

TEST_F(CompactPackages, AreReadByAProgramThatKnowsOnlyTheTextOfTheFormat) {
    VANTAGE_DATASET(scan, "sceaux-small");
    copy_package(scan, settings(EffectChoice::on), dir / "compact.vantage");
    repack(dir / "compact.vantage", false, dir / "raw.vantage");
    const auto read = [&](const char* compact, const char* raw) {
        return std::system(
            (INDEPENDENT_READER " " + (dir / compact).string() + " " + (dir / raw).string()).c_str());
    };
    EXPECT_EQ(read("compact.vantage", "raw.vantage"), 0);
    EXPECT_NE(read("raw.vantage", "raw.vantage"), 0)
        << "packages whose chunks are all raw should be rejected";
}

TEST_F(CompactPackages, ADamagedCellCostsTheTilesThatShowIt) {
    VANTAGE_DATASET(scan, "sceaux-small");
    copy_package(scan, settings(EffectChoice::on), dir / "compact.vantage");
    std::uint64_t at = 0;
    {
        const PackageReader p(dir / "compact.vantage");
        const package::DirectoryEntry& e = *p.find(Type::tiles, 0, 0);
        ASSERT_EQ(e.form, package::Form::cells);
        at = e.offset + e.head_length + p.block(e, 0).size() / 2;
    }
    {
        std::fstream file(dir / "compact.vantage", std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(std::streamoff(at));
        file.put('\x55').put('\xaa').put('\x55');
    }
    const PackageReader p(dir / "compact.vantage");
    const package::DirectoryEntry& e = *p.find(Type::tiles, 0, 0);
    const Level size = level_size(int(p.photos()[0].width), int(p.photos()[0].height), 0);
    std::vector<std::byte> tile(tile_bytes);
    EXPECT_FALSE(read_tile(p, e, size, 0, tile));
    EXPECT_TRUE(read_tile(p, e, size, std::size_t(size.tiles()) - 1, tile));
    EXPECT_EQ(worst(check_package(dir / "compact.vantage", {.deep = true})), Exit::damaged);
}
