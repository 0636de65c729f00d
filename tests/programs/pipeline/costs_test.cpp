// Tests `vantage costs` by running it as a user does.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "base/text/error.h"
#include "tests/one_line.h"
#include "tests/programs/overnight.h"

namespace vantage {
namespace {

class CostsProgram : public Overnight {
  protected:
    Outcome costs(const std::string& words) const { return run("costs " + words + " -o " + folder.string()); }
    nlohmann::json results() const { return nlohmann::json::parse(slurp(folder / "costs.json")); }
    const fs::path folder = dir / "costs";
};

class CostsProgramAtLength : public CostsProgram {};

TEST_F(CostsProgramAtLength, MeasuresContinuesAndJoinsResults) {
    const Outcome first = costs(scene.string() + " --minutes 0.1");
    ASSERT_EQ(first.code, 0) << first.err;
    EXPECT_NE(first.out.find("for a laptop without a graphics card"), std::string::npos) << first.out;
    EXPECT_NE(first.out.find("vantage prepare " + scene.string() + " -o scene.vantage"), std::string::npos);
    const nlohmann::json scan = results()["scans"][0], defaults = scan["trials"][0];
    EXPECT_EQ(scan["photos"], 6);
    EXPECT_EQ(scan["held_out"][0].size(), 2u);
    EXPECT_EQ(defaults["psnr"].size(), 2u);
    for (const double psnr : defaults["psnr"]) EXPECT_TRUE(psnr > 15 && psnr < 60) << psnr;
    EXPECT_GT(defaults["frame_ms"][0], 0);
    EXPECT_FALSE(fs::exists(folder / "work"));
    const std::string page = slurp(folder / "index.html");
    EXPECT_NE(page.find("<svg"), std::string::npos);
    EXPECT_EQ(page.find("nan"), std::string::npos);

    ASSERT_EQ(costs(scene.string() + " --minutes 0.1").code, 0);
    const nlohmann::json later = results()["scans"][0];
    EXPECT_EQ(later["trials"][0], defaults) << "measured again";
    EXPECT_GT(later["trials"].size(), scan["trials"].size());

    ASSERT_EQ(prepare_program("--explain").code, 0);
    const Outcome explained = prepare_program("--explain");
    EXPECT_NE(explained.out.find("measured on this scan by 'vantage costs'"), std::string::npos)
        << explained.out;

    ASSERT_EQ(costs(file.string() + " --minutes 0.1").code, 0);
    const nlohmann::json of_package = results()["scans"][0];
    EXPECT_TRUE(of_package["excluded"]) << "the measurements of another input were kept";
    EXPECT_TRUE(of_package["trials"][0]["prepare_seconds"].empty());
    const std::string one = (folder / "costs.json").string();
    const Outcome joined = run("costs " + one + " " + one + " --json -o " + (dir / "both").string());
    ASSERT_EQ(joined.code, 0) << joined.err;
    EXPECT_EQ(nlohmann::json::parse(joined.out)["scans"].size(), 2u);
}

TEST_F(CostsProgram, RefusesInputsThatItCannotMeasure) {
    const auto expect_error = [&](const std::string& words, Exit code, const std::string& says) {
        const Outcome o = costs(words);
        EXPECT_EQ(o.code, int(code)) << words << o.err;
        EXPECT_TRUE(one_line(o.err)) << o.err;
        EXPECT_NE(o.err.find(says), std::string::npos) << o.err;
    };
    expect_error((dir / "none").string(), Exit::input, "does not exist");
    std::ofstream(dir / "church.toml") << "# a scene file\n";
    expect_error((dir / "church.toml").string(), Exit::usage, "is a scene file");
    for (
        const char* text :
        {"{}", "",
         R"({"version":"1","date":"","processor":"","renderer":"","cores":1,)"
         R"("scans":[{"name":"a","key":"","input":"","photos":4,"triangles":1,"width":1,"height":1,"picture":1,)"
         R"("photo_bytes":0,"held_out":[],"excluded":false,"complete":true,"trials":[],"recipes":[]}]})"}) {
        std::ofstream(dir / "other.json") << text;
        expect_error((dir / "other.json").string(), Exit::input, "is not a results file of 'vantage costs'");
    }
    fs::create_directories(folder);
    std::ofstream(folder / "index.html") << "<p>a page of the user</p>";
    expect_error(scene.string(), Exit::usage, "index.html");
    EXPECT_EQ(slurp(folder / "index.html"), "<p>a page of the user</p>");
    fs::remove(folder / "index.html");
    for (const fs::path& photo : photos())
        if (photo.stem() > "0002") fs::remove(photo);
    expect_error(scene.string(), Exit::input, "has 3 usable photos; expected at least 4");
}

}  // namespace
}  // namespace vantage
