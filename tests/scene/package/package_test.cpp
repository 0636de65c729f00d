#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <utility>

#include "base/files/checksum.h"
#include "base/text/error.h"
#include "scene/package/package_reader.h"
#include "scene/package/package_writer.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;
using package::Type;

namespace {

class Package : public TemporaryFolder {
  protected:
    fs::path file = dir / "a.vantage";
    const std::string text = "{\"tool\":\"test\"}";
    std::vector<std::byte> blocks{std::size_t(3 * 4096), std::byte{7}};

    void write(const fs::path& to) {
        const std::vector<ChunkPlan> plan{{Type::meta, package::scene_wide, 0, text.size()},
                                          {Type::tiles, 0, 2, 0, 3, 4096}};
        PackageWriter writer(to, plan);
        writer.write_blocks(Type::tiles, 0, 2, [&](std::size_t b, std::span<std::byte> block) {
            std::memcpy(block.data(), blocks.data() + 4096 * b, 4096);
        });  // any order
        writer.write(Type::meta, package::scene_wide, std::as_bytes(std::span(text)));
        EXPECT_FALSE(fs::exists(to)) << "the final name exists before finish()";
        writer.finish();
    }
    void dump(const std::string& bytes) { std::ofstream(file, std::ios::binary) << bytes; }
};

}  // namespace

TEST_F(Package, ReadsBackWhatWasWritten) {
    write(file);
    const PackageReader reader(file);
    EXPECT_EQ(reader.meta(), text);
    const auto* e = reader.find(Type::tiles, 0, 2);
    ASSERT_NE(e, nullptr);
    ASSERT_EQ(reader.blocks(*e), 3u);
    for (std::size_t b = 0; b < 3; ++b) {
        EXPECT_TRUE(reader.block_valid(*e, b));
        EXPECT_EQ(std::memcmp(reader.block(*e, b).data(), blocks.data() + 4096 * b, 4096), 0);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(reader.block(*e, b).data()) % package::alignment, 0u);
    }
    EXPECT_EQ(reader.find(Type::tiles, 1, 2), nullptr);
}

TEST_F(Package, IsDeterministic) {
    write(file);
    write(dir / "b.vantage");
    EXPECT_EQ(slurp(file), slurp(dir / "b.vantage"));
}

TEST_F(Package, AbandonedWriterLeavesNothingBehind) {
    {
        const std::vector<ChunkPlan> plan{{Type::meta, package::scene_wide, 0, 4}};
        PackageWriter writer(file, plan);
        EXPECT_THROW(writer.checksum_of(Type::meta, package::scene_wide), std::logic_error);
        EXPECT_THROW(writer.finish(), std::logic_error);
    }
    EXPECT_TRUE(fs::is_empty(dir));
}

TEST_F(Package, TruncatedAnywhereIsDamaged) {
    write(file);
    const std::string whole = slurp(file);
    for (std::size_t n = 0; n < whole.size(); n = n < 300 ? n + 1 : n + 777) {
        dump(whole.substr(0, n));
        try {
            const PackageReader reader(file);
            FAIL() << "accepted " << n << " of " << whole.size() << " bytes";
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::damaged) << n;
        }
    }
}

TEST_F(Package, EveryFlippedByteOfHeaderAndDirectoryIsDetected) {
    write(file);
    const std::string whole = slurp(file);
    for (std::size_t n = 0; n < sizeof(package::Header) + 2 * sizeof(package::DirectoryEntry); ++n) {
        std::string bad = whole;
        bad[n] = char(bad[n] ^ 0x40);
        dump(bad);
        EXPECT_THROW(PackageReader{file}, Error) << "byte " << n;
    }
}

TEST_F(Package, FlippedByteIsDetectedInItsBlock) {
    write(file);
    std::string bad = slurp(file);
    std::uint64_t at;
    {
        const PackageReader reader(file);
        const auto* e = reader.find(Type::tiles, 0, 2);
        at = e->offset + e->head_length + 4096 + 5;
    }
    bad[at] = char(bad[at] ^ 1);
    dump(bad);
    const PackageReader reader(file);
    const auto* e = reader.find(Type::tiles, 0, 2);
    EXPECT_TRUE(reader.head_valid(*e));
    EXPECT_TRUE(reader.block_valid(*e, 0));
    EXPECT_FALSE(reader.block_valid(*e, 1));
    EXPECT_TRUE(reader.block_valid(*e, 2));
}

TEST_F(Package, OfAnotherVersionIsRefused) {
    write(file);
    std::string other = slurp(file);
    package::Header h;
    std::memcpy(&h, other.data(), sizeof h);
    for (const auto& [version, says] : {std::pair{package::version - 1, "prepare it again"},
                                        std::pair{package::version + 1, "made by a newer version"}}) {
        h.version = version;
        h.header_checksum =
            checksum(std::as_bytes(std::span(&h, 1)).first(offsetof(package::Header, header_checksum)));
        std::memcpy(other.data(), &h, sizeof h);
        dump(other);
        try {
            const PackageReader reader(file);
            ADD_FAILURE() << "version " << version << " is accepted";
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::input);
            EXPECT_NE(std::string(e.what()).find(says), std::string::npos) << e.what();
        }
    }
}
