#include "tests/faults/written_package.h"

#include <fstream>

#include "tests/made_scenes.h"

namespace vantage {

void WrittenPackage::SetUp() {
    TemporaryFolder::SetUp();
    ::setenv("XDG_CACHE_HOME", (dir / "cache").c_str(), 1);
    SynthSpec spec = spec_named("tiny");
    spec.photos.count = 3;
    spec.photos.samples = 1;
    spec.object.triangles = 1500;
    copy_scene(spec, scene);
    const fs::path changed = dir / "changed";
    fs::copy(scene, changed, fs::copy_options::recursive);
    fs::copy_file(photos()[0], discover(changed).photos / photos()[2].filename(),
                  fs::copy_options::overwrite_existing);
    const auto words = [&](const fs::path& input) {
        return "prepare --progress none " + input.string() + " -o " + package.string();
    };
    const auto made_by = [&](const WritingCommand& c) {
        start(c);
        const Outcome done = run_command(c);
        EXPECT_EQ(done.code, 0) << c.name << done.err;
        return slurp(package);
    };
    WritingCommand first{"prepare", words(scene), "", ""};
    first.after = made_by(first);
    WritingCommand update{"prepare a changed photo", words(changed), first.after, ""};
    update.after = made_by(update);
    std::string shares;
    for (const char* part : {"1/2", "2/2"}) {
        const std::string share = dir / (std::string("share") + part[0]);
        EXPECT_EQ(
            run("prepare --progress none " + changed.string() + " -o " + share + " --shard " + part).code, 0);
        shares += " " + share;
    }
    WritingCommand merge{"merge", "merge --progress none" + shares + " -o " + package.string(), first.after,
                         update.after};
    WritingCommand refine{"refine", "refine --progress none --effect exposure=on " + package.string(),
                          first.after, ""};
    refine.after = made_by(refine);
    EXPECT_NE(first.after, update.after);
    EXPECT_NE(first.after, refine.after);
    commands = {first, update, merge, refine};
}

void WrittenPackage::start(const WritingCommand& c) const {
    fs::remove_all(out);
    fs::create_directories(out);
    if (!c.before.empty()) std::ofstream(package, std::ios::binary) << c.before;
}

Outcome WrittenPackage::run_command(const WritingCommand& c, const std::string& fault) const {
    return run(c.words, fault.empty() ? "" : fault + " LD_PRELOAD=" FAULTY_DISK);
}

void WrittenPackage::expect_old_or_new(const WritingCommand& c, const std::string& when) const {
    if (!fs::exists(package)) {
        EXPECT_TRUE(c.before.empty()) << c.name << ", " << when << ": the old package is lost";
        return;
    }
    const std::string now = slurp(package);
    EXPECT_TRUE(now == c.after || (!c.before.empty() && now == c.before))
        << c.name << ", " << when << ": neither the old nor the new package";
}

void WrittenPackage::expect_finished_by_next_run(const WritingCommand& c, const std::string& when) const {
    const Outcome next = run_command(c);
    EXPECT_EQ(next.code, 0) << c.name << ", " << when << ": " << next.err;
    EXPECT_TRUE(slurp(package) == c.after)
        << c.name << ", " << when << ": the next run wrote different bytes";
    EXPECT_FALSE(fs::exists(part_of(package))) << c.name << ", " << when;
}

}  // namespace vantage
