// Tests the grouping of photos into image sets, and the error messages if photos cannot be
// grouped.
#include "pipeline/input/image_set_groups.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/text/error.h"
#include "pipeline/formats/export_colmap.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/synth/synthesize.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

using Paths = std::vector<fs::path>;

class ImageSetGroupsTest : public TemporaryFolder {
  protected:
    std::string file(const std::string& text) const {
        std::ofstream(dir / "image_sets.toml") << text;
        return (dir / "image_sets.toml").string();
    }
    /// The groups as text, such as "visible: a/1.jpg; ir: b/1.jpg", or the error message.
    std::string grouped(const Paths& photos, const std::string& how) const {
        try {
            const ImageSetGroups g = group_image_sets(photos, how);
            std::string out;
            for (std::size_t b = 0; b < g.names.size(); ++b) {
                out += (b ? "; " : "") + g.names[b] + ":";
                for (std::size_t i = 0; i < photos.size(); ++i)
                    if (g.of_photo[i] == b) out += " " + photos[i].string();
            }
            return out;
        } catch (const Error& e) {
            std::string text = e.what();
            if (text.starts_with(dir.string())) text.erase(0, dir.string().size() + 1);
            return std::to_string(int(e.code())) + ", " + text;
        }
    }
};

}  // namespace

TEST_F(ImageSetGroupsTest, KnownFoldersAreImageSets) {
    EXPECT_EQ(grouped({"IR/1.jpg", "Visible/1.jpg"}, "auto"), "Visible: Visible/1.jpg; IR: IR/1.jpg");
    EXPECT_EQ(grouped({"left/ir/1.jpg", "right/rgb/1.jpg", "left/rgb/2.jpg"}, "auto"),
              "rgb: right/rgb/1.jpg left/rgb/2.jpg; ir: left/ir/1.jpg");
    EXPECT_EQ(grouped({"ir/1.jpg", "IR/2.jpg"}, "auto"), "ir: ir/1.jpg IR/2.jpg")
        << "upper and lower case should give the same image set";
    EXPECT_EQ(grouped({"Raking_Light/1.jpg", "1.jpg"}, "auto"),
              "photos: 1.jpg; Raking_Light: Raking_Light/1.jpg");
}

TEST_F(ImageSetGroupsTest, WithoutVisibleLightTheLargestComesFirst) {
    EXPECT_EQ(grouped({"after/1.jpg", "before/1.jpg", "before/2.jpg"}, "auto"),
              "before: before/1.jpg before/2.jpg; after: after/1.jpg");
}

TEST_F(ImageSetGroupsTest, UnknownFoldersAreOneImageSetUnlessAskedFor) {
    EXPECT_EQ(grouped({"left/1.jpg", "right/1.jpg"}, "auto"), ": left/1.jpg right/1.jpg");
    EXPECT_EQ(group_image_sets(Paths{"left/1.jpg", "right/1.jpg"}, "auto").note, "");
    const ImageSetGroups mixed = group_image_sets(Paths{"ir/1.jpg", "extra/1.jpg"}, "auto");
    EXPECT_EQ(mixed.names.size(), 1u);
    EXPECT_EQ(mixed.note.find("'ir' may be an image set, but 'extra' is not the name of one"), 0u)
        << mixed.note;
    EXPECT_EQ(grouped({"left/1.jpg", "right/1.jpg", "right/2.jpg"}, "folders"),
              "right: right/1.jpg right/2.jpg; left: left/1.jpg");
    EXPECT_EQ(grouped({"ir/1.jpg", "rgb/1.jpg"}, "off"), ": ir/1.jpg rgb/1.jpg");
}

TEST_F(ImageSetGroupsTest, AFileGroupsByPatterns) {
    const Paths photos{"a_vis.jpg", "b_vis.jpg", "sub/a_ir.tif", "deep/ir/3.jpg"};
    EXPECT_EQ(grouped(photos, file("visible = \"*_vis.jpg\"\nnear = [\"*_ir.tif\", \"deep/ir/*\"]\n")),
              "visible: a_vis.jpg b_vis.jpg; near: sub/a_ir.tif deep/ir/3.jpg");
    EXPECT_EQ(grouped(photos, file("all = \"*\"\n")), "all: a_vis.jpg b_vis.jpg sub/a_ir.tif deep/ir/3.jpg");
}

TEST_F(ImageSetGroupsTest, WhatIsWrongWithAFileIsOneLine) {
    const Paths photos{"1_vis.jpg", "1_ir.jpg"};
    EXPECT_EQ(grouped(photos, file("vis = \"*_vis.jpg\"\nir = \"*_ir.jpg\"\nuv = \"*_uv.jpg\"\n")),
              "3, image_sets.toml: the image set uv has no photo that can be used: none matches *_uv.jpg");
    EXPECT_EQ(grouped(photos, file("ir = \"*_ir.jpg\"\nvis = \"1_*\"\n")),
              "3, image_sets.toml: 1_ir.jpg is in two image sets, ir and vis; expected one");
    EXPECT_EQ(grouped(photos, file("vis = \"*_vis.jpg\"\n")),
              "3, image_sets.toml: 1_ir.jpg is in no image set, expected a pattern that matches it");
    EXPECT_EQ(grouped(photos, file("vis = 3\n")),
              "3, image_sets.toml: vis: expected a pattern such as \"*_ir.jpg\", or a list of them");
    EXPECT_EQ(grouped(photos, file("")),
              "3, image_sets.toml: names no image set, expected a line such as infrared = \"ir/*\"");
    EXPECT_EQ(grouped(photos, file("\"../up\" = \"*\"\n")),
              "2, image_sets.toml: '../up' cannot be the name of an image set, expected 1 to 55 bytes "
              "without / and =");
    EXPECT_EQ(grouped(photos, file("vis = [\n")).rfind("3, image_sets.toml:", 0), 0u);
    EXPECT_EQ(grouped(photos, "none.toml"),
              "2, --image-sets none.toml: expected auto, folders, off, or a file that names the image sets");
}

TEST_F(ImageSetGroupsTest, EachImageSetMayHaveItsOwnCameraFile) {
    SynthSpec spec = spec_named("image_sets");
    spec.photos.samples = 1;
    copy_scene(spec, dir / "scene");
    const SceneInput whole = read_scene(discover(dir / "scene"));
    fs::remove_all(dir / "scene" / "sparse");
    fs::remove_all(dir / "scene" / "truth");
    for (const std::string image_set : {"visible", "infrared"}) {
        std::vector<NamedCamera> own;
        for (const PhotoInput& p : whole.photos)
            if (p.file.parent_path().filename() == image_set)
                own.push_back({p.file.filename().string(), p.camera});
        fs::create_directories(dir / "scene" / image_set);
        fs::rename(dir / "scene" / "images" / image_set, dir / "scene" / image_set / "images");
        write_colmap_text(dir / "scene" / image_set / "sparse", own);
    }
    const SceneInput scene = read_scene(discover(dir / "scene"));
    EXPECT_EQ(scene.files.more_cameras.size(), 1u);
    EXPECT_EQ(scene.image_sets, (std::vector<std::string>{"visible", "infrared"}));
    ASSERT_EQ(scene.photos.size(), whole.photos.size());
    EXPECT_TRUE(scene.skipped.empty());
    for (const PhotoInput& p : scene.photos) {
        const bool infrared = p.file.string().find("infrared") != std::string::npos;
        EXPECT_EQ(p.image_set, infrared ? 1u : 0u) << p.file;
        EXPECT_EQ(p.camera.intrinsics.width, infrared ? 260 : 331) << p.file;
    }
    InputFiles together;
    together.image_sets = "off";
    EXPECT_TRUE(discover(dir / "scene", together).more_cameras.empty());
}
