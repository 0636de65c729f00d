// LAS files, written byte by byte according to ASPRS (2019) and read back.
#include "pipeline/formats/las.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>

#include "base/text/error.h"
#include "pipeline/formats/cloud.h"
#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

struct Format {
    int number, length, color;
};
constexpr Format all_formats[] = {{0, 20, -1}, {1, 28, -1}, {2, 26, 20}, {3, 34, 28},
                                  {4, 57, -1}, {5, 63, 28}, {6, 30, -1}, {7, 36, 30},
                                  {8, 38, 30}, {9, 59, -1}, {10, 67, 30}};

class Las : public TemporaryFolder {
  protected:
    template <class T>
    static void put(std::string& bytes, std::size_t at, const T& value) {
        std::memcpy(&bytes[at], &value, sizeof value);
    }
    /// Points along a line far from zero, in records that end with `extra` additional bytes.
    static std::string file(const Format& f, int points, int version = 2, std::uint16_t red = 0xff00,
                            int extra = 0) {
        const std::size_t header = version >= 4 ? 375 : 227, gap = 54;  // a record between header and points
        std::string las(header + gap, '\0');
        las.replace(0, 4, "LASF");
        las[24] = 1, las[25] = char(version), las[104] = char(f.number);
        put(las, 94, std::uint16_t(header));
        put(las, 96, std::uint32_t(header + gap));
        put(las, 105, std::uint16_t(f.length + extra));
        put(las, version >= 4 ? 247 : 107, std::uint32_t(points));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            put(las, 131 + 8 * axis, 0.01);
            put(las, 155 + 8 * axis, axis == 1 ? 5'000'000.0 : 400'000.0);
        }
        for (int i = 0; i < points; ++i) {
            std::string record(std::size_t(f.length + extra), '\0');
            for (std::size_t axis = 0; axis < 3; ++axis)
                put(record, 4 * axis, std::int32_t(i * int(axis + 1)));
            put(record, 12, std::uint16_t(40 * i));
            if (f.color >= 0) put(record, std::size_t(f.color), red);
            las += record;
        }
        return las;
    }
    Mesh read(const std::string& bytes) {
        std::ofstream(dir / "scan.las", std::ios::binary) << bytes;
        return read_las(dir / "scan.las", warnings);
    }
    std::string complaint(const std::string& bytes) {
        try {
            read(bytes);
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::input);
            return e.what();
        }
        return "read";
    }
    std::vector<std::string> warnings;
};

}  // namespace

TEST_F(Las, EveryFormatGivesPlacesToTheLastDigitAndColors) {
    for (const Format& f : all_formats)
        for (const int version : {2, 4})
            for (const int extra : {0, 7}) {
                const Mesh m = read(file(f, 100, version, 0xff00, extra));
                ASSERT_EQ(m.positions.size(), 100u) << f.number;
                EXPECT_NEAR((m.positions[99] - Eigen::Vector3d(400'000.99, 5'000'001.98, 400'002.97)).norm(),
                            0, 1e-8)
                    << f.number;
                ASSERT_EQ(m.colors.size(), 100u) << f.number;
                if (f.color >= 0)
                    EXPECT_EQ(m.colors[50], (std::array<std::uint8_t, 4>{254, 0, 0, 255})) << f.number;
                else
                    EXPECT_EQ(m.colors[99], (std::array<std::uint8_t, 4>{255, 255, 255, 255})) << f.number;
            }
}

TEST_F(Las, ColorsOfEightBitsInSixteenKeepTheirBrightness) {
    EXPECT_EQ(read(file(all_formats[2], 3, 2, 200)).colors[1][0], 200);
}

TEST_F(Las, WithheldPointsAreDroppedAndCounted) {
    for (const auto& [format, flag] : {std::pair(2, 0x80), std::pair(7, 0x04)}) {
        std::string bytes = file(all_formats[format], 4);
        bytes[227 + 54 + std::size_t(all_formats[format].length) + 15] = char(flag);
        warnings.clear();
        EXPECT_EQ(read(bytes).positions.size(), 3u);
        ASSERT_EQ(warnings.size(), 1u);
        EXPECT_NE(warnings[0].find("1 point marked as withheld dropped"), std::string::npos);
    }
}

TEST_F(Las, DamagedFilesAreRefusedWithAReason) {
    const std::string valid = file(all_formats[3], 10);
    const auto with = [&](std::size_t at, auto value) {
        std::string bytes = valid;
        put(bytes, at, value);
        return complaint(bytes);
    };
    const auto says = [](const std::string& text, const char* part) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    says(complaint(""), "is not a LAS file");
    says(complaint("PLY\n" + valid), "is not a LAS file");
    says(complaint(valid.substr(0, 150)), "cut off in its header");
    says(complaint(valid.substr(0, valid.size() - 1)), "says 10 points, but the file has 9");
    says(complaint(valid.substr(0, 240)), "says 10 points, but the file has 0");
    says(with(107, std::uint32_t(0)), "has no points");
    says(with(107, std::uint32_t(0xffffffff)), "expected at most");
    says(with(104, std::uint8_t(11)), "point format 11");
    says(with(104, std::uint8_t(0x83)), "is compressed (LAZ)");
    says(with(105, std::uint16_t(33)), "expected at least 34");
    says(with(96, std::uint32_t(100)), "begin inside the header");
    says(with(131, 0.0), "scale or offset");
    says(with(155, std::nan("")), "scale or offset");
    says(with(24, std::uint8_t(2)), "LAS version 2");
}

TEST_F(Las, IsAPointCloudByItsName) {
    EXPECT_TRUE(is_cloud_file("a/SCAN.LAS"));
    EXPECT_TRUE(is_cloud_file("scan.laz"));
    EXPECT_FALSE(is_cloud_file("scan.obj"));
}
