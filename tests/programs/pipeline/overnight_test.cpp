// Unattended runs of vantage prepare: killed and resumed, out of disk space, with bad photos, and divided
// into shares.
#include "tests/programs/overnight.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <future>
#include <random>
#include <thread>

#include "base/files/part_file.h"
#include "base/text/error.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/finish.h"
#include "pipeline/prepare/merge_packages.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/reports/check.h"
#include "pipeline/run/settings.h"
#include "pipeline/run/until_stopped.h"
#include "scene/package/package_reader.h"
#include "tests/faults/number_from.h"
#include "tests/made_scenes.h"
#include "tests/one_line.h"

using namespace vantage;
namespace fs = std::filesystem;
using package::Stage;

namespace {

std::size_t made(const PrepareResult& p, Stage s) { return p.stages[std::size_t(s)].made; }
std::size_t kept(const PrepareResult& p, Stage s) { return p.stages[std::size_t(s)].kept; }
constexpr Stage every_stage[] = {Stage::thumbnail, Stage::tiles, Stage::masks, Stage::coordinates,
                                 Stage::coverage};

class OvernightRuns : public Overnight {
  protected:
    /// After a run that this fault kills, the next one writes the same bytes.
    void expect_resumes_after(const std::vector<std::string>& faults) const {
        const std::string bytes = undisturbed();
        for (const std::string& fault : faults) {
            fs::remove(file);
            EXPECT_EQ(with_fault(fault).code, -1) << fault;
            const Outcome next = prepare_program();
            ASSERT_EQ(next.code, 0) << fault << next.err;
            expect_whole(bytes, fault);
        }
    }
    void expect_reported_and_resumed(const std::vector<std::string>& faults) const {
        const std::string bytes = undisturbed();
        for (const std::string& fault : faults) {
            const Outcome failed = with_fault(fault);
            EXPECT_EQ(failed.code, int(Exit::storage)) << fault << failed.err;
            EXPECT_TRUE(one_line(failed.err)) << fault << failed.err;
            EXPECT_NE(failed.err.find("scene.vantage"), std::string::npos) << failed.err;
            const Outcome next = prepare_program();
            ASSERT_EQ(next.code, 0) << fault << next.err;
            expect_whole(bytes, fault);
            fs::remove(file);
        }
    }
    /// That many processes prepare it at once, and one at least finishes.
    void expect_one_package_of(const std::vector<int>& processes) const {
        const std::string bytes = undisturbed();
        for (const int n : processes) {
            fs::remove(file);
            std::vector<std::future<int>> codes;
            const auto text_of = [&](int i) { return dir / ("process" + std::to_string(i)); };
            for (int i = 0; i < n; ++i)
                codes.push_back(std::async(std::launch::async, [&, i] {
                    const int status =
                        std::system((VANTAGE_PROGRAM " prepare --progress none " + scene.string() + " -o " +
                                     file.string() + " --no-report >/dev/null 2>" + text_of(i).string())
                                        .c_str());
                    return WEXITSTATUS(status);
                }));
            int done = 0;
            for (int i = 0; i < n; ++i) {
                const int code = codes[std::size_t(i)].get();
                done += code == 0;
                const std::string said = slurp(text_of(i));
                if (code == 0) continue;
                EXPECT_EQ(code, int(Exit::storage)) << said;
                EXPECT_NE(said.find("another process is writing it"), std::string::npos) << said;
            }
            EXPECT_GE(done, 1) << n << " processes";
            expect_whole(bytes, std::to_string(n) + " processes");
        }
    }
    void expect_shares_merge(const std::vector<unsigned>& numbers) const {
        fs::resize_file(photos()[4], 1000);  // one photo is left out
        const std::string bytes = undisturbed();
        for (const unsigned n : numbers) {
            std::vector<fs::path> shares;
            for (unsigned i = 1; i <= n; ++i) {
                shares.insert(shares.begin(), dir / ("share" + std::to_string(i)));
                PrepareRun run;
                run.share = {i, n};
                prepare(
                    read_scene(discover(scene)), {}, shares.front(), [](const Progress&) {}, run);
            }
            merge(shares, file);
            expect_whole(bytes, std::to_string(n) + " shares");
            EXPECT_THROW(merge({shares.begin() + 1, shares.end()}, dir / "lacking"), Error);
        }
    }
};
class OvernightAtLength : public OvernightRuns {};

}  // namespace

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
    std::printf("%d killed, %d of them left a part to resume from\n", killed, resumed);
}

TEST_F(OvernightRuns, ResumesToTheSameBytesWhenKilledAtAWrite) {
    expect_resumes_after({"pwrite:77:KILL", "fsync:2:KILL_AFTER", "rename:1:KILL"});
}

TEST_F(OvernightAtLength, ResumesToTheSameBytesWhenKilledAtAnyWrite) {
    expect_resumes_after({"pwrite:1:KILL", "pwrite:2:KILL", "pwrite:3:KILL_AFTER", "pwrite:40:KILL",
                          "pwrite:150:KILL_AFTER", "ftruncate:1:KILL", "fsync:1:KILL_AFTER", "fsync:2:KILL",
                          "fsync:3:KILL", "fsync:4:KILL", "unlink:1:KILL_AFTER", "rename:1:KILL_AFTER"});
}

TEST_F(OvernightAtLength, EndsWithOneLineIfMemoryRunsOut) {
#ifdef VANTAGE_SANITIZED
    GTEST_SKIP() << "sanitizers reserve address space of their own";
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
        EXPECT_TRUE(slurp(file) == before) << "the package is open elsewhere";
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

TEST_F(Overnight, RefiningLaterGivesTheSamePackage) {
    fs::remove_all(scene);
    SynthSpec spec = spec_named("tiny");
    spec.exposure = {0.7, 0.2, 0.3};
    copy_scene(spec, scene);
    copy_package(scene, {}, file);
    const std::string agreeing = slurp(file);
    PrepareSettings off;
    off.effects = {{Effect::exposure, EffectChoice::off}, {Effect::vignetting, EffectChoice::off}};
    const Outcome refined =
        run("refine " + file.string() + " --effect exposure=off --effect vignetting=off -o " +
            (dir / "off.vantage").string());
    EXPECT_EQ(refined.code, 0) << refined.err;
    undisturbed(off);
    const Outcome diff =
        run("diff " + (dir / "off.vantage").string() + " " + (dir / "undisturbed.vantage").string());
    EXPECT_EQ(diff.code, 0) << diff.out;
    EXPECT_EQ(run("refine " + (dir / "off.vantage").string()).code, 0);
    EXPECT_TRUE(slurp(dir / "off.vantage") == agreeing) << "in place, by the evidence again";
}

TEST_F(OvernightAtLength, RegisteringLaterOrByMergingGivesTheSamePackage) {
    fs::remove_all(scene);
    SynthSpec spec = spec_named("small");
    spec.photos.count = 8;
    spec.photos.samples = 1;
    spec.error.pixels = 4;
    copy_scene(spec, scene);
    // A run that is stopped while registering resumes later.
    std::atomic<bool> stop{false};
    PrepareRun stopped;
    stopped.stop = &stop;
    const auto stop_at_matching = [&](const Progress& p) { stop = std::string_view(p.stage) == "match"; };
    try {
        prepare(read_scene(discover(scene)), {}, file, stop_at_matching, stopped);
        FAIL() << "did not stop";
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), Exit::interrupted) << e.what();
    }
    EXPECT_FALSE(fs::exists(file));
    const PrepareResult one = prepare_here();
    ASSERT_TRUE(one.agreement->pose_refinement.decision.on);
    const std::string registered = slurp(file);
    const std::string a = (dir / "a.share").string(), b = (dir / "b.share").string(),
                      merged = (dir / "merged.vantage").string();
    ASSERT_EQ(run("prepare --progress none " + scene.string() + " --shard 1/2 -o " + a).code +
                  run("prepare --progress none " + scene.string() + " --shard 2/2 -o " + b).code,
              0);
    ASSERT_EQ(run("merge " + a + " " + b + " -o " + merged).code, 0);
    EXPECT_TRUE(slurp(merged) == registered);

    PrepareSettings off;
    off.effects = {{Effect::pose_refinement, EffectChoice::off}};
    EXPECT_EQ(run("refine " + merged + " --effect pose-refinement=off").code, 0);
    undisturbed(off);
    const Outcome diff = run("diff " + merged + " " + (dir / "undisturbed.vantage").string());
    EXPECT_EQ(diff.code, 0) << diff.out;
    EXPECT_EQ(run("refine " + merged).code, 0);
    EXPECT_TRUE(slurp(merged) == registered) << "in place, by the evidence again";
}

TEST_F(Overnight, MemoryStaysBelowTheEstimateAndTheLimit) {
#ifdef VANTAGE_SANITIZED
    GTEST_SKIP() << "sanitizers use memory of their own";
#endif
    const auto megabytes = [](const std::string& text, const std::string& before) {
        const std::size_t at = text.find(before);
        return at == std::string::npos ? -1 : std::atoi(text.c_str() + at + before.size());
    };
    // The last one allows fewer photos in flight than threads.
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

TEST_F(Overnight, UnchangedInputsRerunNothing) {
    copy_package(scene, {}, file);
    const auto written = fs::last_write_time(file);
    const Outcome again = prepare_program();
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("nothing to do"), std::string::npos) << again.out;
    EXPECT_EQ(fs::last_write_time(file), written);
}

TEST_F(Overnight, ChangedPhotoIsRedoneAlone) {
    copy_package(scene, {}, file);
    fs::copy_file(photos()[1], photos()[4], fs::copy_options::overwrite_existing);
    const PrepareResult next = prepare_here();
    for (const Stage s : {Stage::thumbnail, Stage::tiles, Stage::masks}) {
        EXPECT_EQ(made(next, s), 1u) << int(s);
        EXPECT_EQ(kept(next, s), 5u) << int(s);
    }
    EXPECT_EQ(made(next, Stage::coordinates) + made(next, Stage::coverage), 0u)
        << "these stages do not read the photo";
    const auto& why = next.stages[std::size_t(Stage::tiles)].why;
    ASSERT_EQ(why.size(), 1u);
    EXPECT_EQ(why.begin()->first, "the photo's file has changed");
    expect_whole(undisturbed(), "a changed photo");
}

TEST_F(Overnight, AddedAndRemovedPhotosRerunOnlyThemselves) {
    const fs::path away = photos()[3], held = dir / "held.jpg";
    fs::rename(away, held);
    copy_package(scene, {}, file);
    fs::rename(held, away);
    const PrepareResult more = prepare_here();
    for (const Stage s : every_stage) EXPECT_EQ(made(more, s), 1u) << int(s);
    for (const Stage s : every_stage) EXPECT_EQ(kept(more, s), 5u) << int(s);
    expect_whole(undisturbed(), "an added photo");
    fs::remove(away);
    const PrepareResult fewer = prepare_here();
    for (const Stage s : every_stage) EXPECT_EQ(made(fewer, s), 0u) << int(s);
    expect_whole(undisturbed(), "a removed photo");
}

TEST_F(Overnight, ChangedSettingRerunsOnlyItsStages) {
    copy_package(scene, {}, file);
    PrepareSettings settings;
    settings.border_threshold = 0.02;
    const PrepareResult masks = prepare_here(settings);
    EXPECT_EQ(made(masks, Stage::masks), 6u);
    for (const Stage s : {Stage::thumbnail, Stage::tiles, Stage::coordinates, Stage::coverage})
        EXPECT_EQ(made(masks, s), 0u) << int(s);
    EXPECT_EQ(masks.stages[std::size_t(Stage::masks)].why.begin()->first,
              "the setting border_threshold has changed");
    expect_whole(undisturbed(settings), "another border");
    settings.thumbnail = 128;
    const PrepareResult small = prepare_here(settings);
    EXPECT_EQ(made(small, Stage::thumbnail), 6u);
    for (const Stage s : {Stage::tiles, Stage::masks, Stage::coordinates, Stage::coverage})
        EXPECT_EQ(made(small, s), 0u) << int(s);
    expect_whole(undisturbed(settings), "smaller thumbnails");
}

TEST_F(Overnight, InterruptedUpdateResumes) {
    copy_package(scene, {}, file);
    const fs::path away = photos()[3];
    fs::remove(away);
    EXPECT_EQ(with_fault("pwrite:60:KILL").code, -1);
    EXPECT_EQ(check_package(file, {.deep = true}).size(), 0u)
        << "the old package stays until the new one is complete";
    const Outcome next = prepare_program();
    EXPECT_EQ(next.code, int(Exit::incomplete)) << next.err;
    expect_whole(undisturbed(), "an interrupted change");
}

TEST_F(Overnight, UnusablePhotosAreLeftOutAndListed) {
    const std::vector<fs::path> all = photos();
    fs::resize_file(all[0], fs::file_size(all[0]) / 2);             // truncated
    fs::remove(all[1]);                                             // missing
    fs::copy_file(all[2], all[2].parent_path() / "passer-by.jpg");  // no camera
    std::ofstream(all[3], std::ios::trunc) << "not a picture";      // not a photo
    SynthSpec other = spec_named("tiny");
    other.photos.count = 1;
    other.photos.width = 120;
    other.photos.height = 110;
    copy_scene(other, dir / "other");
    fs::copy_file(discover(dir / "other").photos / "0000.jpg", all[4], fs::copy_options::overwrite_existing);
    const Outcome done = prepare_program();
    EXPECT_EQ(done.code, int(Exit::incomplete)) << done.err;
    for (const std::string& line :
         {"left out " + all[0].filename().string() + ": JPEG is corrupt or truncated",
          "left out " + all[1].filename().string() + ": has a camera but no photo",
          std::string("left out passer-by.jpg: has no camera"),
          "left out " + all[3].filename().string() + ": ",
          "left out " + all[4].filename().string() + ": is 120x110, but its camera expects "})
        EXPECT_NE(done.out.find(line), std::string::npos) << line << "\n" << done.out;
    std::printf("%s", done.out.c_str());
    const std::vector<Issue> issues = check_package(file, {.deep = true, .against = scene});
    EXPECT_EQ(worst(issues), Exit::incomplete);
    EXPECT_EQ(issues.size(), 5u);
    const Outcome again = prepare_program();
    EXPECT_EQ(again.code, int(Exit::incomplete)) << "still";
    EXPECT_NE(again.out.find("nothing to do"), std::string::npos) << again.out;
    const Outcome strict = prepare_program("--strict --thumbnail-size 128");
    EXPECT_EQ(strict.code, int(Exit::input));
    EXPECT_TRUE(one_line(strict.err)) << strict.err;
}

TEST_F(Overnight, StrictStopsAtATruncatedPhoto) {
    fs::resize_file(photos()[0], fs::file_size(photos()[0]) / 2);
    const Outcome strict = prepare_program("--strict");
    EXPECT_EQ(strict.code, int(Exit::input));
    EXPECT_TRUE(one_line(strict.err)) << strict.err;
    EXPECT_NE(strict.err.find("0000.jpg: JPEG is corrupt or truncated"), std::string::npos) << strict.err;
}

TEST_F(Overnight, InputThatVanishesMidwayStopsAndNothingIsLost) {
    const std::string bytes = undisturbed();
    const SceneInput known = read_scene(discover(scene));
    fs::rename(photos()[5], dir / "unplugged.jpg");
    PrepareSettings one_by_one;
    one_by_one.threads = 1;
    try {
        prepare(known, one_by_one, file, [](const Progress&) {});
        FAIL() << "a vanished photo must not be left out silently";
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

TEST_F(Overnight, RepairedPhotoIsIncludedAgain) {
    const std::string bytes = undisturbed();
    const fs::path bad = photos()[2];
    const std::string picture = slurp(bad);
    fs::resize_file(bad, picture.size() / 2);
    EXPECT_EQ(prepare_here().left_out.size(), 1u);
    std::ofstream(bad, std::ios::binary) << picture;
    const PrepareResult next = prepare_here();
    EXPECT_TRUE(next.left_out.empty());
    for (const Stage s : every_stage) EXPECT_EQ(made(next, s), 1u) << int(s);
    expect_whole(bytes, "repair");
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
             scene.string() + " -o " + file.string() + " --no-report --border-width 48 >/dev/null 2>&1")
                .c_str());
    });
    while (!fs::exists(part_of(file))) std::this_thread::yield();
    EXPECT_EQ(prepare_program("--no-report").code, 0);
    const fs::path kept = dir / "kept.vantage";
    fs::create_hard_link(file, kept);
    std::ofstream(completed).close();
    EXPECT_EQ(WEXITSTATUS(late.get()), 0);
    EXPECT_TRUE(slurp(kept) == bytes) << "a complete package was written to";
    EXPECT_FALSE(fs::exists(part_of(file)));
    EXPECT_FALSE(slurp(file) == bytes) << "the late process did its work, with its own settings";
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
        settings.border_width = 60 + i;
        prepare(
            read_scene(discover(scene)), settings, dir / std::to_string(i), [](const Progress&) {}, run);
    }
    const Outcome merged =
        run("merge " + (dir / "1").string() + " " + (dir / "2").string() + " -o " + file.string());
    EXPECT_EQ(merged.code, int(Exit::input));
    EXPECT_TRUE(one_line(merged.err)) << merged.err;
    EXPECT_FALSE(fs::exists(file));
    EXPECT_EQ(run("check " + (dir / "1").string()).code, int(Exit::damaged)) << "a share is not a package";
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
        << "the others are equal: " << d.out;
    EXPECT_TRUE(fs::exists(dir / "pictures" / (photos()[4].stem().string() + "-tiles.png")));
}
