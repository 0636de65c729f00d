// Tests the page that `vantage diff -o FOLDER` writes.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

#include "base/text/error.h"
#include "pipeline/photos/image_files.h"
#include "tests/made_scenes.h"
#include "tests/programs/patterns.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

class Diff : public TemporaryFolder {
  protected:
    const fs::path page = dir / "page" / "index.html";

    void SetUp() override {
        TemporaryFolder::SetUp();
        SynthSpec spec = tiny_spec();
        copy_scene(spec, dir / "scan");
        prepare("a");
    }
    void prepare(const std::string& name, const std::string& options = "") const {
        ASSERT_EQ(run("prepare " + (dir / "scan").string() + " -o " + package(name) +
                      " --refine off --no-report " + options),
                  0)
            << slurp(dir / "says");
    }
    std::string package(const std::string& name) const { return (dir / (name + ".vantage")).string(); }
    int run(const std::string& words) const {
        const int status =
            std::system((VANTAGE_PROGRAM " " + words + " >" + (dir / "says").string() + " 2>&1").c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    int diff(const std::string& other) const {
        return run("diff " + package("a") + " " + package(other) + " -o " + (dir / "page").string());
    }
    std::size_t pictures() const {
        const auto images = matches(slurp(page), "<img [^>]*src=\"([^\"]+)\"");
        for (const auto& m : images) EXPECT_TRUE(fs::exists(dir / "page" / m[1])) << m[1];
        return images.size();
    }
    bool says(const std::string& text) const { return slurp(page).find(text) != std::string::npos; }
};

}  // namespace

TEST_F(Diff, PageOfEqualPackagesSaysSo) {
    prepare("b");
    EXPECT_EQ(diff("b"), 0);
    EXPECT_NE(slurp(dir / "says").find(page.string()), std::string::npos) << "the page's path";
    for (const char* text : {"Identical", "a.vantage", "b.vantage", "<td class=n>5<"})
        EXPECT_TRUE(says(text)) << text;
    EXPECT_EQ(pictures(), 0u);
    EXPECT_FALSE(says("<h2>"));
}

TEST_F(Diff, PageListsDifferencesWithoutPictures) {
    prepare("b", "--thumbnail-size 128");
    EXPECT_EQ(diff("b"), int(Exit::different));
    EXPECT_FALSE(says("Identical"));
    for (const char* text : {"<td>settings<td>thumbnail<td>", "<td>0003.jpg<td>thumbnail<td>", "<p>None: "})
        EXPECT_TRUE(says(text)) << text;
    EXPECT_EQ(pictures(), 0u);
}

TEST_F(Diff, PageShowsPhotosThatDiffer) {
    const fs::path photo = dir / "scan" / "images" / "0003.jpg";
    const RgbaImage image = image_files().read(photo);
    std::vector<std::byte> black(std::size_t(3 * image.width * image.height));
    image_files().write(photo, image.width, image.height, 3, Sample::u8, black);
    prepare("b");
    EXPECT_EQ(diff("b"), int(Exit::different));
    EXPECT_TRUE(says("<td>0003.jpg<td>tiles<td>"));
    EXPECT_FALSE(says("<td>0002.jpg<td>tiles<td>"));
    EXPECT_EQ(pictures(), 1u) << "only the photo should have a picture, because its weight maps are equal";
}
