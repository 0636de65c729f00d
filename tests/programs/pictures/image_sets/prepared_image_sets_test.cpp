// Tests image sets in packages, scores and messages.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/text/error.h"
#include "pipeline/output/meta.h"
#include "pipeline/prepare/refine_package.h"
#include "pipeline/reports/check.h"
#include "player/plan/plan_scene.h"
#include "scene/package/contents/image_sets.h"
#include "tests/fuzz/support/valid_package.h"
#include "tests/programs/pictures/image_sets/image_set_scene.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

class ImageSetsAtLength : public ImageSets {};

nlohmann::json effect_in(const PackageReader& package, const std::string& name) {
    const nlohmann::json meta = parse_meta(package);
    for (const auto& row : meta.at("effects"))
        if (row.at("name") == name) return row;
    return {};
}

bool is_neutral(const package::PhotoRecord& p) {
    return std::ranges::all_of(p.gain, [](double g) { return g == 1; });
}

}  // namespace

TEST_F(ImageSets, ExposureIsDecidedPerImageSet) {
    SynthSpec spec = small_scene();
    spec.infrared.stops = 1;
    make(spec);
    const PackageReader brighter = prepared();
    EXPECT_FALSE(effect_on(brighter.scene(), Effect::exposure))
        << "one image set is twice as bright as the other";
    EXPECT_TRUE(std::ranges::all_of(brighter.photos(), is_neutral));
    spec.exposure.stops = 0.5;  // for photos in visible light
    make(spec);
    const PackageReader uneven = prepared();
    const std::vector<ImageSet> image_sets = read_image_sets(uneven);
    EXPECT_TRUE(image_sets[visible].effects & effect_bit(Effect::exposure));
    EXPECT_FALSE(image_sets[infrared].effects & effect_bit(Effect::exposure));
    double sum = 0;
    std::size_t corrected = 0;
    for (const package::PhotoRecord& p : uneven.photos())
        if (p.image_set == infrared) {
            EXPECT_TRUE(is_neutral(p)) << p.name;
        } else {
            sum += std::log(p.gain[1]);
            corrected += std::abs(std::log(p.gain[1])) > 0.05;
        }
    EXPECT_GE(corrected, 3u);
    EXPECT_NEAR(sum / 5, 0, 0.01) << "relative to the mean photo of the image set";
    const auto row = effect_in(uneven, "exposure");
    ASSERT_EQ(row.at("image_sets").size(), 2u);
    EXPECT_EQ(row.at("image_sets")[0].at("name"), "visible");
    EXPECT_TRUE(row.at("image_sets")[0].at("on"));
    EXPECT_FALSE(row.at("image_sets")[1].at("on"));
}

TEST_F(ImageSets, PairsAreOfOneImageSet) {
    make(small_scene());
    const PackageReader package = prepared();
    std::size_t pairs = 0;
    for (const auto& p : package.records<package::PairRecord>(package::Type::pairs))
        if (p.a != p.b) {
            EXPECT_EQ(package.photos()[p.a].image_set, package.photos()[p.b].image_set);
            ++pairs;
        }
    EXPECT_GE(pairs, 6u) << "the photos within each image set should overlap";
}

TEST_F(ImageSets, AreAbsentIfThereIsOne) {
    SynthSpec spec = small_scene();
    make(spec);
    PrepareSettings off;
    off.effects[Effect::image_sets] = EffectChoice::off;
    spec.infrared.count = 0;
    make(spec, "plain");
    const auto expect_none = [&](const PackageReader& package) {
        EXPECT_FALSE(effect_on(package.scene(), Effect::image_sets));
        EXPECT_FALSE(effect_in(package, "image-sets").at("on"));
        EXPECT_EQ(package.find(package::Type::image_sets), nullptr);
        for (const package::PhotoRecord& p : package.photos()) EXPECT_EQ(p.image_set, 0u);
        EXPECT_EQ(read_image_sets(package).size(), 1u);
        EXPECT_EQ(std::ranges::count(shader_defines("show", package.scene().effects), "IMAGE_SETS"), 0);
        EXPECT_TRUE(check_package(package.path(), {.deep = true}).empty());
    };
    expect_none(prepared("plain"));
    expect_none(prepared("scene", off));
    expect_none(prepared("scene", {}, "off"));
    const PackageReader on = prepared("scene");
    EXPECT_EQ(effect_in(on, "image-sets").at("evidence"), "visible: 5 photos; infrared: 4 photos");
    EXPECT_EQ(effect_in(on, "image-sets").at("measured"), 2);
    EXPECT_TRUE(check_package(on.path(), {.deep = true}).empty());
}

TEST_F(ImageSets, RefiningKeepsThem) {
    make(small_scene());
    const PackageReader before = prepared();
    refine_package(before.path(), {}, dir / "again.vantage");
    EXPECT_EQ(slurp(before.path()), slurp(dir / "again.vantage"));
}

TEST_F(ImageSets, NumbersOutOfRangeAreRefused) {
    make(small_scene());
    prepared();
    const std::string valid = slurp(dir / "scene.vantage");
    std::uint64_t photos = 0, records = 0;
    {
        const PackageReader package(dir / "scene.vantage");
        photos = package.find(package::Type::photos)->offset;
        records = package.find(package::Type::image_sets)->offset;
    }
    const auto message = [&](std::uint64_t at, const void* value, std::size_t bytes) {
        std::vector<std::uint8_t> b(valid.begin(), valid.end());
        std::memcpy(b.data() + at, value, bytes);
        fuzz::fix_checksums(b);
        std::ofstream(dir / "edited.vantage", std::ios::binary)
            .write(reinterpret_cast<const char*>(b.data()), std::streamsize(b.size()));
        try {
            make_plan_scene(PackageReader(dir / "edited.vantage"));
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::damaged);
            return std::string(e.what()).substr((dir / "edited.vantage").string().size() + 2);
        }
        return std::string();
    };
    const std::uint32_t two = 2, many = 0xffffffff;
    const std::uint64_t second =
        photos + sizeof(package::PhotoRecord) + offsetof(package::PhotoRecord, image_set);
    EXPECT_EQ(message(second, &two, 4), "PHOT 1: image set 2, expected one below 2");
    EXPECT_EQ(message(second, &many, 4), "PHOT 1: image set 4294967295, expected one below 2");
    EXPECT_EQ(message(records, "", 1),
              "BAND: image set 0 has a name that is not unique or cannot name a folder");
    EXPECT_EQ(message(records, "infrared", 9),
              "BAND: image set 1 has a name that is not unique or cannot name a folder");
    EXPECT_EQ(message(records, "../../up", 9),
              "BAND: image set 0 has a name that is not unique or cannot name a folder");
}

TEST_F(ImageSetsAtLength, EvaluatePredictsAPhotoFromItsOwnImageSet) {
    make(small_scene());
    const PackageReader scene = prepared("scene");
    // The background shade is computed from the photos of the first image set.
    const auto copy_shade_to = [&](const fs::path& file) {
        const std::uint64_t at = PackageReader(file).find(package::Type::scene)->offset;
        const std::string whole = slurp(file);
        std::vector<std::uint8_t> b(whole.begin(), whole.end());
        std::memcpy(b.data() + at + offsetof(package::SceneRecord, shade), scene.scene().shade,
                    sizeof scene.scene().shade);
        fuzz::fix_checksums(b);
        std::ofstream(file, std::ios::binary)
            .write(reinterpret_cast<const char*>(b.data()), std::streamsize(b.size()));
    };
    for (const std::string image_set : {"visible", "infrared"}) {
        const std::string other = image_set == "visible" ? "infrared" : "visible",
                          noise = "noise-in-" + other;
        fs::copy(dir / "scene", dir / noise, fs::copy_options::recursive);
        add_noise(noise, other);
        prepared(noise);
        copy_shade_to(dir / (noise + ".vantage"));
        const auto scores = [&](const std::string& name) {
            const std::string out = (dir / (name + "-" + image_set)).string();
            const Ran ran = run(VANTAGE_PLAYER " evaluate " + (dir / (name + ".vantage")).string() +
                                " --photo " + image_set + "_0001," + image_set + "_0002 -o " + out);
            EXPECT_EQ(ran.code, 0) << ran.says;
            return slurp(fs::path(out) / "photos.csv");
        };
        const std::string valid = scores("scene");
        EXPECT_FALSE(valid.empty());
        EXPECT_EQ(valid, scores(noise)) << image_set;
    }
}

TEST_F(ImageSetsAtLength, ProgramsKnowThem) {
    make(small_scene());
    const std::string file = prepared().path().string(), player = VANTAGE_PLAYER " ",
                      vantage = VANTAGE_PROGRAM " ";
    const auto shoot = [&](const std::string& options) {
        const Ran ran =
            run(player + "render " + file + " -q --scale 0.5 -o " + (dir / "p.png").string() + " " + options);
        return ran.code == 0 ? slurp(dir / "p.png") : ran.says;
    };
    const std::string own = shoot("--photo infrared_0001");
    EXPECT_EQ(own, shoot("--photo infrared_0001 --image-set INFRARED"))
        << "a view from a photo's camera should show that photo's image set";
    EXPECT_NE(own, shoot("--photo infrared_0001 --image-set visible"));
    EXPECT_NE(own, shoot("--photo infrared_0001 --image-set visible --second-image-set infrared=0.5"));
    EXPECT_EQ(own, shoot("--photo infrared_0001 --image-set visible --second-image-set infrared=1"));
    EXPECT_EQ(shoot("--photo infrared_0001 --image-set uv"),
              "vantage-player: " + file + ": has no image set 'uv', expected one of visible, infrared\n");
    EXPECT_EQ(shoot("--photo infrared_0001 --second-image-set infrared=2"),
              "vantage-player: --second-image-set infrared=2: expected NAME or NAME=SHARE with a share from "
              "0 to 1\n");
    EXPECT_EQ(shoot("--photo infrared_0001 --second-image-set visible --image-set-view side-by-side"),
              "vantage-player: image set 'visible' is already shown, expected another image set\n");
    EXPECT_NE(run(player + "list " + file).says.find("infrared_0001.jpg  infrared  260x200"),
              std::string::npos);
    EXPECT_NE(run(vantage + "info " + file).says.find("visible: 5 photos; infrared: 4 photos"),
              std::string::npos);
    EXPECT_EQ(run(vantage + "extract " + file + " -o " + (dir / "files").string()).code, 0);
    EXPECT_TRUE(fs::exists(dir / "files" / "photos" / "infrared" / "infrared_0001.jpg"));
    EXPECT_TRUE(fs::exists(dir / "files" / "depth" / "visible" / "visible_0001.exr"));
    const std::string golden = (dir / "golden").string();
    EXPECT_EQ(run(player + "verify " + file + " --size 96x72 --golden " + golden + " --update").code, 0);
    EXPECT_NE(slurp(dir / "golden" / "views.path").find("image-set=infrared"), std::string::npos);
    const Ran verified = run(player + "verify " + file + " --size 96x72 --golden " + golden);
    EXPECT_EQ(verified.code, 0) << verified.says;
}
