// How photos are grouped into bands, and what is said where they cannot be.
#include "pipeline/input/band_groups.h"

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

class BandGroupsTest : public TemporaryFolder {
  protected:
    std::string file(const std::string& text) const {
        std::ofstream(dir / "bands.toml") << text;
        return (dir / "bands.toml").string();
    }
    /// "visible: a/1.jpg; ir: b/1.jpg", or the message.
    std::string grouped(const Paths& photos, const std::string& how) const {
        try {
            const BandGroups g = group_bands(photos, how);
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

TEST_F(BandGroupsTest, KnownFoldersAreBands) {
    EXPECT_EQ(grouped({"IR/1.jpg", "Visible/1.jpg"}, "auto"), "Visible: Visible/1.jpg; IR: IR/1.jpg");
    EXPECT_EQ(grouped({"left/ir/1.jpg", "right/rgb/1.jpg", "left/rgb/2.jpg"}, "auto"),
              "rgb: right/rgb/1.jpg left/rgb/2.jpg; ir: left/ir/1.jpg");
    EXPECT_EQ(grouped({"ir/1.jpg", "IR/2.jpg"}, "auto"), "ir: ir/1.jpg IR/2.jpg") << "one band in two cases";
    EXPECT_EQ(grouped({"Raking_Light/1.jpg", "1.jpg"}, "auto"),
              "photos: 1.jpg; Raking_Light: Raking_Light/1.jpg");
}

TEST_F(BandGroupsTest, WithoutVisibleLightTheLargestComesFirst) {
    EXPECT_EQ(grouped({"after/1.jpg", "before/1.jpg", "before/2.jpg"}, "auto"),
              "before: before/1.jpg before/2.jpg; after: after/1.jpg");
}

TEST_F(BandGroupsTest, UnknownFoldersAreOneBandUnlessAskedFor) {
    EXPECT_EQ(grouped({"left/1.jpg", "right/1.jpg"}, "auto"), ": left/1.jpg right/1.jpg");
    EXPECT_EQ(group_bands(Paths{"left/1.jpg", "right/1.jpg"}, "auto").note, "");
    const BandGroups mixed = group_bands(Paths{"ir/1.jpg", "extra/1.jpg"}, "auto");
    EXPECT_EQ(mixed.names.size(), 1u);
    EXPECT_EQ(mixed.note.find("'ir' may be a band, but 'extra' is the name of none"), 0u) << mixed.note;
    EXPECT_EQ(grouped({"left/1.jpg", "right/1.jpg", "right/2.jpg"}, "folders"),
              "right: right/1.jpg right/2.jpg; left: left/1.jpg");
    EXPECT_EQ(grouped({"ir/1.jpg", "rgb/1.jpg"}, "off"), ": ir/1.jpg rgb/1.jpg");
}

TEST_F(BandGroupsTest, AFileGroupsByPatterns) {
    const Paths photos{"a_vis.jpg", "b_vis.jpg", "sub/a_ir.tif", "deep/ir/3.jpg"};
    EXPECT_EQ(grouped(photos, file("visible = \"*_vis.jpg\"\nnear = [\"*_ir.tif\", \"deep/ir/*\"]\n")),
              "visible: a_vis.jpg b_vis.jpg; near: sub/a_ir.tif deep/ir/3.jpg");
    EXPECT_EQ(grouped(photos, file("all = \"*\"\n")), "all: a_vis.jpg b_vis.jpg sub/a_ir.tif deep/ir/3.jpg");
}

TEST_F(BandGroupsTest, WhatIsWrongWithAFileIsOneLine) {
    const Paths photos{"1_vis.jpg", "1_ir.jpg"};
    EXPECT_EQ(grouped(photos, file("vis = \"*_vis.jpg\"\nir = \"*_ir.jpg\"\nuv = \"*_uv.jpg\"\n")),
              "3, bands.toml: the band uv has no photo that can be used: none fits *_uv.jpg");
    EXPECT_EQ(grouped(photos, file("ir = \"*_ir.jpg\"\nvis = \"1_*\"\n")),
              "3, bands.toml: 1_ir.jpg is in two bands, ir and vis; expected one");
    EXPECT_EQ(grouped(photos, file("vis = \"*_vis.jpg\"\n")),
              "3, bands.toml: 1_ir.jpg is in no band, expected a pattern that it fits");
    EXPECT_EQ(grouped(photos, file("vis = 3\n")),
              "3, bands.toml: vis: expected a pattern such as \"*_ir.jpg\", or a list of them");
    EXPECT_EQ(grouped(photos, file("")),
              "3, bands.toml: names no band, expected a line such as infrared = \"ir/*\"");
    EXPECT_EQ(grouped(photos, file("\"../up\" = \"*\"\n")),
              "2, bands.toml: '../up' cannot be the name of a band, expected 1 to 55 bytes without / and =");
    EXPECT_EQ(grouped(photos, file("vis = [\n")).rfind("3, bands.toml:", 0), 0u);
    EXPECT_EQ(grouped(photos, "none.toml"),
              "2, --bands none.toml: expected auto, folders, off, or a file that names the bands");
}

TEST_F(BandGroupsTest, EachBandMayHaveItsOwnCameraFile) {
    SynthSpec spec = spec_named("bands");
    spec.photos.samples = 1;
    copy_scene(spec, dir / "scene");
    const SceneInput whole = read_scene(discover(dir / "scene"));
    fs::remove_all(dir / "scene" / "sparse");
    fs::remove_all(dir / "scene" / "truth");
    for (const std::string band : {"visible", "infrared"}) {
        std::vector<NamedCamera> own;
        for (const PhotoInput& p : whole.photos)
            if (p.file.parent_path().filename() == band)
                own.push_back({p.file.filename().string(), p.camera});
        fs::create_directories(dir / "scene" / band);
        fs::rename(dir / "scene" / "images" / band, dir / "scene" / band / "images");
        write_colmap_text(dir / "scene" / band / "sparse", own);
    }
    const SceneInput scene = read_scene(discover(dir / "scene"));
    EXPECT_EQ(scene.files.more_cameras.size(), 1u);
    EXPECT_EQ(scene.bands, (std::vector<std::string>{"visible", "infrared"}));
    ASSERT_EQ(scene.photos.size(), whole.photos.size());
    EXPECT_TRUE(scene.left_out.empty());
    for (const PhotoInput& p : scene.photos) {
        const bool infrared = p.file.string().find("infrared") != std::string::npos;
        EXPECT_EQ(p.band, infrared ? 1u : 0u) << p.file;
        EXPECT_EQ(p.camera.intrinsics.width, infrared ? 260 : 331) << p.file;
    }
    InputFiles together;
    together.bands = "off";
    EXPECT_TRUE(discover(dir / "scene", together).more_cameras.empty());
}
