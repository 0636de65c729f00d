// Tests packages that a later run updates or refines, and unusable photos.
#include <atomic>
#include <fstream>

#include "base/text/error.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/finish.h"
#include "pipeline/prepare/merge_packages.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/reports/check.h"
#include "pipeline/run/settings.h"
#include "tests/made_scenes.h"
#include "tests/one_line.h"
#include "tests/programs/overnight.h"
#include "tests/programs/pipeline/overnight/overnight_runs.h"

using namespace vantage;
namespace fs = std::filesystem;

using package::Stage;

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
    EXPECT_TRUE(slurp(dir / "off.vantage") == agreeing)
        << "refining in place, based on the stored evidence, should restore the package";
}

TEST_F(OvernightAtLength, RegisteringLaterOrByMergingGivesTheSamePackage) {
    fs::remove_all(scene);
    SynthSpec spec = spec_named("small");
    spec.photos.count = 8;
    spec.photos.samples = 1;
    spec.error.pixels = 4;
    copy_scene(spec, scene);
    // A run that is stopped during pose refinement is resumed later.
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
    EXPECT_TRUE(slurp(merged) == registered)
        << "refining in place, based on the stored evidence, should restore the package";
}

TEST_F(Overnight, UnchangedInputsRerunNothing) {
    copy_package(scene, {}, file);
    const auto written = fs::last_write_time(file);
    const Outcome again = prepare_program();
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("nothing to do"), std::string::npos) << again.out;
    EXPECT_EQ(prepare_program("--shard 0/3").code, int(Exit::usage))
        << "an invalid option of a current package";
    EXPECT_EQ(fs::last_write_time(file), written);
}

TEST_F(Overnight, ChangedPhotoIsRedoneAlone) {
    copy_package(scene, {}, file);
    fs::copy_file(photos()[1], photos()[4], fs::copy_options::overwrite_existing);
    const PrepareResult next = prepare_here();
    for (const Stage s : {Stage::thumbnail, Stage::tiles, Stage::weight_maps}) {
        EXPECT_EQ(made(next, s), 1u) << int(s);
        EXPECT_EQ(kept(next, s), 5u) << int(s);
    }
    EXPECT_EQ(made(next, Stage::coordinates) + made(next, Stage::coverage), 0u)
        << "these stages do not read the photo, so they should not be run";
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
    settings.distance = DistanceMethod::jump_flooding;
    const PrepareResult weight_maps = prepare_here(settings);
    // Jump flooding needs OpenGL, which then also renders the geometry.
    for (const Stage s : {Stage::weight_maps, Stage::coordinates, Stage::coverage})
        EXPECT_EQ(made(weight_maps, s), 6u) << int(s);
    for (const Stage s : {Stage::thumbnail, Stage::tiles}) EXPECT_EQ(made(weight_maps, s), 0u) << int(s);
    EXPECT_EQ(weight_maps.stages[std::size_t(Stage::weight_maps)].why.begin()->first,
              "the setting distance has changed");
    expect_whole(undisturbed(settings), "another method for border distances");
    settings.thumbnail = 128;
    const PrepareResult small = prepare_here(settings);
    EXPECT_EQ(made(small, Stage::thumbnail), 6u);
    for (const Stage s : {Stage::tiles, Stage::weight_maps, Stage::coordinates, Stage::coverage})
        EXPECT_EQ(made(small, s), 0u) << int(s);
    expect_whole(undisturbed(settings), "smaller thumbnails");
}

TEST_F(Overnight, UnusablePhotosAreSkippedAndListed) {
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
         {"skipped " + all[0].filename().string() + ": JPEG is corrupt or truncated",
          "skipped " + all[1].filename().string() + ": has a camera but no photo",
          std::string("skipped passer-by.jpg: has no camera"), "skipped " + all[3].filename().string() + ": ",
          "skipped " + all[4].filename().string() + ": is 120x110, but its camera expects "})
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

TEST_F(Overnight, RepairedPhotoIsIncludedAgain) {
    const std::string bytes = undisturbed();
    const fs::path bad = photos()[2];
    const std::string picture = slurp(bad);
    fs::resize_file(bad, picture.size() / 2);
    EXPECT_EQ(prepare_here().skipped.size(), 1u);
    std::ofstream(bad, std::ios::binary) << picture;
    const PrepareResult next = prepare_here();
    EXPECT_TRUE(next.skipped.empty());
    for (const Stage s : every_stage) EXPECT_EQ(made(next, s), 1u) << int(s);
    expect_whole(bytes, "repair");
}
