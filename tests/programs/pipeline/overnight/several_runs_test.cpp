// Tests packages prepared by several processes, either simultaneously or as shards. The results are compared.
#include <cstdlib>
#include <fstream>
#include <future>
#include <thread>

#include "base/files/part_file.h"
#include "base/text/error.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/merge_packages.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/settings.h"
#include "tests/made_scenes.h"
#include "tests/one_line.h"
#include "tests/programs/overnight.h"
#include "tests/programs/pipeline/overnight/overnight_runs.h"

using namespace vantage;
namespace fs = std::filesystem;

TEST_F(Overnight, OnlyOneProcessWritesAtATime) {
    copy_package(scene, {}, file);
    std::vector<ChunkPlan> plan{{package::Type::meta, package::scene_wide, 0, 4}};
    PackageWriter other(file, plan);
    const Outcome second = prepare_program("--thumbnail-size 128");
    EXPECT_EQ(second.code, int(Exit::storage));
    EXPECT_TRUE(one_line(second.err)) << second.err;
    EXPECT_NE(second.err.find("another process is writing it"), std::string::npos) << second.err;
}

TEST_F(OvernightRuns, SeveralProcessesMayWriteOnePackage) { expect_one_package_of({3}); }

TEST_F(OvernightAtLength, AnyNumberOfProcessesMayWriteOnePackage) { expect_one_package_of({2, 10}); }

TEST_F(Overnight, ProcessThatOpensAPartJustBeforeItIsCompletedLeavesThePackageAlone) {
    const std::string bytes = undisturbed();
    const fs::path completed = dir / "completed";
    auto late = std::async(std::launch::async, [&] {
        return std::system(
            ("FAULT=flock:1:WAIT FAULT_CONTINUE=" + completed.string() +
             " LD_PRELOAD=" FAULTY_DISK " timeout 120 " VANTAGE_PROGRAM " prepare --progress none " +
             scene.string() + " -o " + file.string() + " --no-report --thumbnail-size 128 >/dev/null 2>&1")
                .c_str());
    });
    while (!fs::exists(part_of(file))) std::this_thread::yield();
    EXPECT_EQ(prepare_program("--no-report").code, 0);
    const fs::path kept = dir / "kept.vantage";
    fs::create_hard_link(file, kept);
    std::ofstream(completed).close();
    EXPECT_EQ(WEXITSTATUS(late.get()), 0);
    EXPECT_TRUE(slurp(kept) == bytes) << "a complete package was modified";
    EXPECT_FALSE(fs::exists(part_of(file)));
    EXPECT_FALSE(slurp(file) == bytes) << "the late process should finish with its own settings";
}

TEST_F(OvernightRuns, SharesMergeToTheBytesOfASingleRun) { expect_shares_merge({3}); }

TEST_F(OvernightAtLength, AnyNumberOfSharesMergesToTheBytesOfASingleRun) {
    expect_shares_merge({1, 2, 5, 8});
}

TEST_F(Overnight, SharesOfDifferentSettingsAreRejected) {
    for (const std::uint32_t i : {1u, 2u}) {
        PrepareRun run;
        run.share = {i, 2};
        PrepareSettings settings;
        settings.distance = i == 1 ? DistanceMethod::exact : DistanceMethod::jump_flooding;
        prepare(
            read_scene(discover(scene)), settings, dir / std::to_string(i), [](const Progress&) {}, run);
    }
    const Outcome merged =
        run("merge " + (dir / "1").string() + " " + (dir / "2").string() + " -o " + file.string());
    EXPECT_EQ(merged.code, int(Exit::input));
    EXPECT_TRUE(one_line(merged.err)) << merged.err;
    EXPECT_FALSE(fs::exists(file));
    EXPECT_EQ(run("check " + (dir / "1").string()).code, int(Exit::damaged)) << "a shard is not a package";
}

TEST_F(Overnight, DiffListsDifferences) {
    copy_package(scene, {}, file);
    const fs::path other = dir / "other.vantage";
    fs::copy_file(file, other);
    EXPECT_EQ(run("diff " + file.string() + " " + other.string()).code, 0);
    fs::copy_file(photos()[1], photos()[4], fs::copy_options::overwrite_existing);
    prepare_here();
    const Outcome d =
        run("diff " + file.string() + " " + other.string() + " -o " + (dir / "pictures").string());
    EXPECT_EQ(d.code, int(Exit::different)) << d.err;
    const std::string name = photos()[4].filename().string();
    EXPECT_NE(d.out.find(name + ": tiles: level 0: "), std::string::npos) << d.out;
    EXPECT_EQ(d.out.find(photos()[3].filename().string()), std::string::npos)
        << "the other photos should be equal: " << d.out;
    EXPECT_TRUE(fs::exists(dir / "pictures" / (photos()[4].stem().string() + "-tiles.png")));
}
