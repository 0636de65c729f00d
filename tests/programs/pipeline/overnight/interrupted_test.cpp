// Tests runs of vantage prepare that are killed or stopped or that run out of disk space or memory, and runs
// that resume them.
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <random>

#include "base/files/part_file.h"
#include "base/text/error.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/reports/check.h"
#include "pipeline/run/settings.h"
#include "scene/package/package_reader.h"
#include "tests/faults/number_from.h"
#include "tests/made_scenes.h"
#include "tests/one_line.h"
#include "tests/programs/overnight.h"
#include "tests/programs/pipeline/overnight/overnight_runs.h"

using namespace vantage;
namespace fs = std::filesystem;
using package::Stage;

TEST_F(OvernightAtLength, ResumesToTheSameBytesWhenKilledAtRandom) {
    if (const char* other = std::getenv("VANTAGE_KILLED_SCENE")) {
        fs::remove_all(scene);
        copy_scene(read_spec(other), scene);
    }
    const auto start = std::chrono::steady_clock::now();
    prepare_here();
    const std::string bytes = slurp(file);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> instant(0.02, seconds);
    int killed = 0, resumed = 0;
    for (const int wanted = number_from("VANTAGE_KILLS", 4); killed < wanted;) {
        fs::remove(file);
        fs::remove(part_of(file));
        killed +=
            prepare_program("", "timeout --foreground -s KILL " + std::to_string(instant(random))).code == -1;
        resumed += fs::exists(part_of(file));
        const Outcome next = prepare_program();
        ASSERT_EQ(next.code, 0) << next.err;
        expect_whole(bytes, "kill " + std::to_string(killed));
    }
    std::printf("%d runs killed; %d of them left a partial package to resume from\n", killed, resumed);
}

TEST_F(OvernightAtLength, ResumesToTheSameBytesWhenKilledAtAWrite) {
    expect_resumes_after({"pwrite:77:KILL", "fsync:2:KILL_AFTER", "rename:1:KILL"});
}

TEST_F(OvernightAtLength, ResumesToTheSameBytesWhenKilledAtAnyWrite) {
    expect_resumes_after({"pwrite:1:KILL", "pwrite:2:KILL", "pwrite:3:KILL_AFTER", "pwrite:40:KILL",
                          "pwrite:150:KILL_AFTER", "ftruncate:1:KILL", "fsync:1:KILL_AFTER", "fsync:2:KILL",
                          "fsync:3:KILL", "fsync:4:KILL", "unlink:1:KILL_AFTER", "rename:1:KILL_AFTER"});
}

TEST_F(OvernightAtLength, EndsWithOneLineIfMemoryRunsOut) {
#ifdef VANTAGE_SANITIZED
    GTEST_SKIP() << "sanitizers reserve address space";
#endif
    const std::string bytes = undisturbed();
    const auto limited_to = [](int megabytes) {
        return "ulimit -v " + std::to_string(megabytes * 1000) + "; timeout 100 ";
    };
    int least = 60;  // with less, the libraries cannot be loaded
    while (run("--version", limited_to(least)).code != 0) ASSERT_LT(least += 10, 1000);
    int ran_out = 0;
    for (int megabytes = least + 20; megabytes <= least + 150; megabytes += 10) {
        const std::string limit = std::to_string(megabytes) + " MB";
        fs::remove(file);
        fs::remove(part_of(file));
        const Outcome done = prepare_program("", limited_to(megabytes));
        if (done.code != 0) {
            EXPECT_EQ(done.code, int(Exit::memory)) << limit;
            EXPECT_TRUE(one_line(done.err)) << limit << ": " << done.err;
            ++ran_out;
        }
        const Outcome next = prepare_program();
        ASSERT_EQ(next.code, 0) << limit << ": " << next.err;
        expect_whole(bytes, limit);
    }
    EXPECT_GE(ran_out, 3);
}

TEST_F(OvernightAtLength, FinishesDespiteRepeatedKills) {
    const std::string bytes = undisturbed();
    int runs = 0;
    while (with_fault("pwrite:120:KILL").code != 0) ASSERT_LT(++runs, 50) << "no progress";
    expect_whole(bytes, std::to_string(runs) + " kills");
    EXPECT_GT(runs, 1);
}

TEST_F(Overnight, FinishedWorkIsKept) {
    EXPECT_EQ(with_fault("fsync:2:KILL").code, -1);
    const PrepareResult next = prepare_here();
    for (const Stage s : every_stage) EXPECT_EQ(made(next, s), 0u) << int(s);
    for (const Stage s : every_stage) EXPECT_EQ(kept(next, s), 6u) << int(s);
}

TEST_F(Overnight, DamagedDataInThePartIsRedone) {
    const std::string bytes = undisturbed();
    EXPECT_EQ(with_fault("fsync:2:KILL").code, -1);
    std::uint64_t at = 0;
    {
        const PackageReader part(part_of(file), PackageReader::Expect::part);
        at = part.find(package::Type::tiles, 2, 0)->offset + 5000;
    }
    std::fstream part(part_of(file), std::ios::in | std::ios::out | std::ios::binary);
    part.seekp(std::streamoff(at));
    part << "bit rot";
    part.close();
    const PrepareResult next = prepare_here();
    EXPECT_EQ(made(next, Stage::tiles), 1u);
    expect_whole(bytes, "damage");
}

TEST_F(OvernightRuns, FullDiskIsReportedInOneLineAndNothingIsLost) {
    expect_reported_and_resumed({"pwrite:30:ENOSPC", "fsync:2:EIO", "rename:1:EACCES"});
}

TEST_F(OvernightAtLength, FailureOfAnyOperationIsReportedInOneLineAndNothingIsLost) {
    expect_reported_and_resumed(
        {"ftruncate:1:ENOSPC", "pwrite:1:ENOSPC", "pwrite:120:EIO", "pwrite:90:EACCES", "fsync:1:EIO"});
}

TEST_F(OvernightAtLength, UpdatesInPlaceWithoutRoomForBoth) {
    PrepareSettings raw;
    raw.effects = {{Effect::compact, EffectChoice::off}};
    copy_package(scene, raw, file);
    fs::copy_file(photos()[1], photos()[4], fs::copy_options::overwrite_existing);
    const std::string before = slurp(file);
    {
        const PackageReader somebody(file);
        const Outcome refused = with_fault("statvfs:1:FULL", "--effect compact=off");
        EXPECT_EQ(refused.code, int(Exit::storage));
        EXPECT_TRUE(one_line(refused.err)) << refused.err;
        EXPECT_NE(refused.err.find(" MB free"), std::string::npos) << refused.err;
        EXPECT_TRUE(slurp(file) == before)
            << "the old package should be unchanged, because another process has it open";
    }
    const Outcome done = with_fault("statvfs:1:FULL", "--effect compact=off --explain");
    ASSERT_EQ(done.code, 0) << done.err;
    EXPECT_NE(done.out.find("tiles        1 made, 5 kept"), std::string::npos) << done.out;
    expect_whole(undisturbed(raw), "in place");
}

TEST_F(Overnight, InsufficientDiskSpaceStopsAtOnce) {
    const Outcome refused = with_fault("statvfs:1:FULL");
    EXPECT_EQ(refused.code, int(Exit::storage));
    EXPECT_TRUE(one_line(refused.err)) << refused.err;
    EXPECT_NE(refused.out.find("needs    about "), std::string::npos) << refused.out;
    EXPECT_FALSE(fs::exists(part_of(file)));
}

TEST_F(Overnight, InsufficientMemoryStopsAtOnce) {
    const Outcome refused = prepare_program("--memory 1M");
    EXPECT_EQ(refused.code, int(Exit::usage));
    EXPECT_TRUE(one_line(refused.err)) << refused.err;
    EXPECT_EQ(prepare_program("--memory 2G").code, 0);
}

TEST_F(Overnight, MemoryStaysBelowTheEstimateAndTheLimit) {
#ifdef VANTAGE_SANITIZED
    GTEST_SKIP() << "sanitizers use additional memory";
#endif
    const auto megabytes = [](const std::string& text, const std::string& before) {
        const std::size_t at = text.find(before);
        return at == std::string::npos ? -1 : std::atoi(text.c_str() + at + before.size());
    };
    // In the last case, fewer photos fit into memory at a time than there are threads.
    for (const std::string options : {"--threads 1", "--threads 6", "--threads 6 --memory 140M"}) {
        fs::remove(file);
        const Outcome done = prepare_program(options);
        ASSERT_EQ(done.code, 0) << done.err;
        const int estimated = megabytes(done.out, "s, at most "), used = megabytes(done.out, "memory   ");
        EXPECT_GT(used, 0) << done.out;
        EXPECT_LE(used, estimated) << options << '\n' << done.out;
        EXPECT_LE(estimated, options.ends_with("140M") ? 147 : 1000) << done.out;
    }
}

TEST_F(Overnight, InterruptedUpdateResumes) {
    copy_package(scene, {}, file);
    const fs::path away = photos()[3];
    fs::remove(away);
    EXPECT_EQ(with_fault("pwrite:60:KILL").code, -1);
    EXPECT_EQ(check_package(file, {.deep = true}).size(), 0u)
        << "the old package should stay until the new one is complete";
    const Outcome next = prepare_program();
    EXPECT_EQ(next.code, int(Exit::incomplete)) << next.err;
    expect_whole(undisturbed(), "an interrupted change");
}

TEST_F(Overnight, InputThatVanishesMidwayStopsAndNothingIsLost) {
    const std::string bytes = undisturbed();
    const SceneInput known = read_scene(discover(scene));
    fs::rename(photos()[5], dir / "unplugged.jpg");
    PrepareSettings one_by_one;
    one_by_one.threads = 1;
    try {
        prepare(known, one_by_one, file, [](const Progress&) {});
        FAIL() << "a vanished photo must not be skipped silently";
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), Exit::input);
        EXPECT_NE(std::string(e.what()).find("0005.jpg: cannot open"), std::string::npos) << e.what();
    }
    EXPECT_FALSE(fs::exists(file));
    fs::rename(dir / "unplugged.jpg", discover(scene).photos / "0005.jpg");
    const PrepareResult next = prepare_here();
    EXPECT_EQ(kept(next, Stage::tiles), 5u);
    EXPECT_EQ(made(next, Stage::tiles), 1u);
    expect_whole(bytes, "unplugged");
}

TEST_F(Overnight, SignalFinishesPhotosInFlight) {
    const std::string bytes = undisturbed();
    for (const char* signal : {"TERM", "INT"}) {
        const Outcome stopped = prepare_program("--threads 1", std::string("timeout -s ") + signal + " 0.25");
        ASSERT_TRUE(stopped.code == 124 || stopped.code == 8 || stopped.code == 0)
            << stopped.code << stopped.err;
        const Outcome next = prepare_program();
        EXPECT_EQ(next.code, 0) << next.err;
        expect_whole(bytes, signal);
        fs::remove(file);
    }
}
