// Checks a collection of packages as CI would: damaged, stale, incomplete and visually different packages
// must be found.
#include <fstream>
#include <functional>
#include <map>
#include <pugixml.hpp>

#include "base/text/error.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/run/until_stopped.h"
#include "scene/package/package_reader.h"
#include "tests/programs/overnight.h"

using namespace vantage;

namespace {

/// A collection of eight valid packages; spoil() breaks four of them.
class Collection : public Overnight {
  protected:
    const fs::path collection = dir / "collection", scans = dir / "scans", golden = dir / "golden";
    static std::string name(int i) { return "p" + std::to_string(10 + i); }
    fs::path package(int i) const { return collection / (name(i) + ".vantage"); }
    static constexpr int damaged_one = 1, stale_one = 3, incomplete_one = 5, different_one = 6, count = 8;

    void SetUp() override {
        Overnight::SetUp();
        for (const auto& folder : {collection, scans}) fs::create_directories(folder);
        copy_package(scene, {}, file);
        for (int i = 0; i < count; ++i) {
            fs::copy_file(file, package(i));
            fs::create_directory_symlink(scene, scans / name(i));
        }
    }
    /// Gives one package its own scan, in which one photo is changed.
    fs::path own_scan(int i, const std::function<void(const fs::path& photo)>& change) const {
        const fs::path own = dir / ("scan of " + name(i));
        fs::copy(scene, own, fs::copy_options::recursive);
        change(discover(own).photos / photos()[2].filename());
        fs::remove(scans / name(i));
        fs::create_directory_symlink(own, scans / name(i));
        return own;
    }
    void rot(int i) const {
        std::uint64_t at;
        {
            const PackageReader reader(package(i));
            at = reader.find(vantage::package::Type::tiles, 1, 0)->offset + 20000;
        }
        std::fstream bytes(package(i), std::ios::in | std::ios::out | std::ios::binary);
        bytes.seekp(std::streamoff(at));
        bytes << "rot";
    }
    void spoil() const {
        const auto another = [&](const fs::path& photo) {
            fs::copy_file(photos()[4], photo, fs::copy_options::overwrite_existing);
        };
        const auto redo = [&](int i, const fs::path& from) {
            prepare(read_scene(discover(from)), {}, package(i), [](const Progress&) {});
        };
        rot(damaged_one);
        own_scan(stale_one, another);
        redo(incomplete_one, own_scan(incomplete_one, [](const fs::path& p) { fs::resize_file(p, 2000); }));
        redo(different_one, own_scan(different_one, another));
    }
    std::string all() const { return collection.string() + "/*.vantage"; }
    Outcome verify(const std::string& words) const {
        return run("verify --size 160x120 -o " + (dir / "differences").string() + " " + words, "",
                   VANTAGE_PLAYER);
    }
    /// The types of the failed cases in a JUnit file, by package name.
    static std::map<std::string, std::string> failures(const fs::path& junit) {
        pugi::xml_document xml;
        EXPECT_TRUE(xml.load_file(junit.c_str()));
        const pugi::xml_node suite = xml.child("testsuite");
        EXPECT_EQ(suite.attribute("tests").as_int(), count);
        std::map<std::string, std::string> found;
        for (const pugi::xml_node c : suite.children("testcase"))
            if (c.child("failure"))
                found[fs::path(c.attribute("name").value()).stem()] =
                    c.child("failure").attribute("type").value();
        EXPECT_EQ(suite.attribute("failures").as_uint(), found.size());
        return found;
    }
};

}  // namespace

TEST_F(Collection, CheckFindsDamagedStaleAndIncompletePackages) {
    const std::string words = "check --deep " + all() + " --against " + scans.string();
    EXPECT_EQ(run(words).code, 0);
    spoil();
    const fs::path junit = dir / "check.xml";
    const Outcome found = run(words + " --junit " + junit.string());
    EXPECT_EQ(found.code, int(Exit::damaged)) << "the worst package should determine the exit code";
    const std::map<std::string, std::string> expected{
        {name(damaged_one), "damaged"}, {name(stale_one), "stale"}, {name(incomplete_one), "incomplete"}};
    EXPECT_EQ(failures(junit), expected) << found.out;
    EXPECT_EQ(std::ranges::count(found.out, '\n'), count) << found.out;
    for (const auto& [i, code] : {std::pair(damaged_one, Exit::damaged),
                                  {stale_one, Exit::stale},
                                  {incomplete_one, Exit::incomplete},
                                  {different_one, Exit::ok}})
        EXPECT_EQ(
            run("check --deep " + package(i).string() + " --against " + (scans / name(i)).string()).code,
            int(code));
    EXPECT_EQ(run("check " + (collection / "none.vantage").string()).code, int(Exit::input));
}

TEST_F(Collection, VerifyFindsChangedPictures) {
    const std::string words = all() + " --golden " + golden.string();
    const std::string one = package(0).string() + " --golden " + (golden / name(0)).string();
    EXPECT_EQ(verify(one).code, int(Exit::input)) << "there are no reference pictures yet";
    EXPECT_EQ(verify(words + " --update").code, 0);
    EXPECT_EQ(verify(one + " --tolerance 0 --max-diff-fraction 0").code, 0) << "rendering is deterministic";
    spoil();
    const fs::path junit = dir / "verify.xml";
    const Outcome found = verify(words + " --junit " + junit.string());
    const std::map<std::string, std::string> expected{{name(damaged_one), "damaged"},
                                                      {name(incomplete_one), "different"},
                                                      {name(different_one), "different"}};
    EXPECT_EQ(failures(junit), expected) << found.out;
    EXPECT_EQ(found.code, int(Exit::damaged));
    EXPECT_NE(found.out.find("of the pixels differ by more than 8, the worst by "), std::string::npos)
        << found.out;
    EXPECT_FALSE(fs::is_empty(dir / "differences" / name(different_one)));
    EXPECT_EQ(
        verify(package(different_one).string() + " --golden " + (golden / name(different_one)).string()).code,
        int(Exit::different));
}
