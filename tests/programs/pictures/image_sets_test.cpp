// Photo sets of one object that are shown one at a time: a synthetic building in visible light, and in
// infrared, which shows an underdrawing.
#include "scene/package/contents/image_sets.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "base/gl/context.h"
#include "base/text/error.h"
#include "base/values/srgb.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/output/meta.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/prepare/refine_package.h"
#include "pipeline/reports/check.h"
#include "pipeline/run/until_stopped.h"
#include "player/render/picture.h"
#include "tests/fuzz/support/valid_package.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

constexpr std::uint32_t visible = 0, infrared = 1;

SynthSpec small_scene() {
    SynthSpec spec = spec_named("image_sets");
    spec.photos.samples = 1;
    spec.infrared.stops = 0;
    return spec;
}

class ImageSets : public TemporaryFolder {
  protected:
    void make(const SynthSpec& spec, const std::string& name = "scene") const {
        copy_scene(spec, dir / name);
    }
    PackageReader prepared(const std::string& scene = "scene", const PrepareSettings& settings = {},
                           const std::string& how = "auto") const {
        InputFiles given;
        given.image_sets = how;
        if (how == "auto")
            copy_package(dir / scene, settings, dir / (scene + ".vantage"));
        else
            prepare(read_scene(discover(dir / scene, given)), settings, dir / (scene + ".vantage"),
                    [](const Progress&) {});
        return PackageReader(dir / (scene + ".vantage"));
    }
    /// Every pixel of an image set's photos, at random.
    void add_noise(const std::string& scene, const std::string& image_set = "infrared") const {
        const int width = image_set == "infrared" ? 260 : 331, height = image_set == "infrared" ? 200 : 250;
        std::mt19937 random(7);
        for (const auto& entry : fs::directory_iterator(dir / scene / "images" / image_set)) {
            std::vector<std::byte> pixels(std::size_t(width * height * 3));
            for (std::byte& b : pixels) b = std::byte(random() & 255);
            image_files().write(entry.path(), width, height, 3, Sample::u8, pixels);
        }
    }
    struct Ran {
        int code;
        std::string says;
    };
    Ran run(const std::string& command) const {
        const int status = std::system((command + " >" + (dir / "says").string() + " 2>&1").c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, slurp(dir / "says")};
    }
};
class ImageSetsAtLength : public ImageSets {};

std::vector<std::uint32_t> all(const PackageReader& package) {
    std::vector<std::uint32_t> photos(package.photos().size());
    std::iota(photos.begin(), photos.end(), 0u);
    return photos;
}

/// From the front, between the cameras of both image sets.
View front() { return view_towards({1, -9, 0}, {0, 0, 0}, {0, 0, 1}, 45, 200, 150); }

Picture taken(Renderer& renderer, const RenderSettings& settings) {
    return take_picture(renderer, front(), settings, all(renderer.package()), 1);
}

RenderSettings of(const ImageSetSettings& image_sets) {
    RenderSettings s;
    s.image_sets = image_sets;
    return s;
}

double mean_difference(const Picture& a, const Picture& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(int(a.rgba[i]) - int(b.rgba[i]));
    return sum / double(a.rgba.size());
}

/// The mean of two sRGB codes in square roots of light.
double mixed(int a, int b, double share) {
    const double root =
        (1 - share) * std::sqrt(linear_from_srgb(a / 255.0)) + share * std::sqrt(linear_from_srgb(b / 255.0));
    return 255 * srgb_from_linear(root * root);
}

/// How far a mix is from the mean of two pictures, in codes, at most.
double largest_error(const Picture& a, const Picture& b, const Picture& mix, double share) {
    double worst = 0;
    for (std::size_t i = 0; i < mix.rgba.size(); i += 4) {
        worst = std::max(
            worst, std::abs((1 - share) * a.rgba[i + 3] + share * b.rgba[i + 3] - double(mix.rgba[i + 3])));
        if (a.rgba[i + 3] < 255 || b.rgba[i + 3] < 255) continue;
        for (std::size_t c = i; c < i + 3; ++c)
            worst = std::max(worst, std::abs(mixed(a.rgba[c], b.rgba[c], share) - double(mix.rgba[c])));
    }
    return worst;
}

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

TEST_F(ImageSets, CrossFadeIsTheMeanOfBothPictures) {
    make(small_scene());
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    for (const bool fills : {false, true}) {
        const auto picture = [&](const ImageSetSettings& image_sets) {
            RenderSettings s = of(image_sets);
            s.fill_holes = fills;
            return taken(renderer, s);
        };
        const Picture a = picture({.shown = visible}), b = picture({.shown = infrared});
        EXPECT_GT(mean_difference(a, b), 10);
        const auto mix = [&](double share) {
            return picture({.shown = visible, .other = infrared, .share = share});
        };
        EXPECT_EQ(mix(0).rgba, a.rgba);
        EXPECT_EQ(mix(1).rgba, b.rgba);
        for (const double share : {0.25, 0.5})
            EXPECT_LE(largest_error(a, b, mix(share), share), 1.1) << share << " " << fills;
    }
}

TEST_F(ImageSets, DividedPicturesShowEachImageSetOnItsSide) {
    make(small_scene());
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    const Picture a = taken(renderer, of({.shown = visible})), b = taken(renderer, of({.shown = infrared}));
    const auto expect_from = [&](const Picture& whole, int x, const Picture& got, int at) {
        for (int y = 0; y < got.height; ++y)
            for (int c = 0; c < 4; ++c)
                ASSERT_EQ(got.rgba[std::size_t(4 * (y * got.width + at) + c)],
                          whole.rgba[std::size_t(4 * (y * got.width + x) + c)])
                    << at << "," << y;
    };
    const Picture swipe =
        taken(renderer, of({.shown = visible, .other = infrared, .how = ImageSetView::swipe, .swipe = 0.3}));
    const Picture beside =
        taken(renderer, of({.shown = visible, .other = infrared, .how = ImageSetView::side_by_side}));
    for (int x = 0; x < a.width; ++x) {
        if (std::abs(x - 60) > 2) expect_from(x < 60 ? a : b, x, swipe, x);
        if (std::abs(x - 100) > 2) expect_from(x < 100 ? a : b, x % 100 + 50, beside, x);
    }
}

TEST_F(ImageSets, PhotosOfOneImageSetAreNeverBlendedIntoTheOther) {
    SynthSpec spec = small_scene();
    spec.exposure.stops = 0.5;
    spec.garden = {.radius = 30, .hill = 8};
    make(spec);
    fs::copy(dir / "scene", dir / "noise", fs::copy_options::recursive);
    add_noise("noise");
    for (const bool background : {false, true}) {
        PrepareSettings settings;
        if (background) settings.effects[Effect::background] = EffectChoice::on;
        const PackageReader one = prepared("scene", settings), other = prepared("noise", settings);
        ASSERT_EQ(effect_on(one.scene(), Effect::background), effect_on(other.scene(), Effect::background));
        EXPECT_TRUE(!background || effect_on(one.scene(), Effect::background));
        EXPECT_TRUE(read_image_sets(one)[visible].effects & effect_bit(Effect::exposure));
        const gl::HeadlessContext context;
        Renderer a(one, MemoryBudget{}), b(other, MemoryBudget{});
        EXPECT_GT(mean_difference(taken(a, of({.shown = infrared})), taken(b, of({.shown = infrared}))), 10);
        for (int blend = 0; blend < int(Blend::count); ++blend)
            for (const bool second_round : {false, true})
                for (const int photos : {0, 2}) {
                    RenderSettings s;
                    s.blend = Blend(blend);
                    s.transients = second_round;
                    s.photos = photos;
                    s.fill_holes = background;
                    EXPECT_EQ(taken(a, s).rgba, taken(b, s).rgba)
                        << blend << " " << second_round << " " << photos << " " << background;
                }
    }
}

TEST_F(ImageSets, LookAsIfTheyWereAlone) {
    SynthSpec spec = small_scene();
    spec.exposure.stops = 0.5;
    make(spec);
    spec.infrared.count = 0;
    make(spec, "alone");
    const PackageReader both = prepared(), alone = prepared("alone");
    const gl::HeadlessContext context;
    Renderer a(both, MemoryBudget{}), b(alone, MemoryBudget{});
    RenderSettings s;
    s.blend = Blend::average;  // in which distances to cameras count most
    for (const int photos : {0, 2}) {
        s.photos = photos;
        const Picture in_both = taken(a, s), by_itself = taken(b, s);
        int worst = 0;
        for (std::size_t i = 0; i < in_both.rgba.size(); ++i)
            worst = std::max(worst, std::abs(int(in_both.rgba[i]) - int(by_itself.rgba[i])));
        EXPECT_LE(worst, 1) << photos;
    }
}

TEST_F(ImageSets, AImageSetThatTakesAnothersPlaceLeavesNoHole) {
    make(small_scene());
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    RenderSettings s;
    s.complete = false;
    s.photos = 2;
    s.fill_holes = true;
    s.upload_bytes = std::size_t(1) << 20;
    double now = 0;
    const auto frame = [&] {
        now += 1.0 / 30;
        const FrameReport report = renderer.draw(front(), s, all(package), {}, now);
        EXPECT_LE(report.uploaded, s.upload_bytes);
        return report.settled;
    };
    const auto settle = [&](const auto& look) {
        for (int i = 0; i < 600; ++i) {
            const bool settled = frame();
            look(shown_picture(renderer, front(), s));
            if (settled) return true;
        }
        return false;
    };
    ASSERT_TRUE(settle([](const Picture&) {}));
    const Picture before = shown_picture(renderer, front(), s);
    std::vector<Picture> shown;
    s.image_sets.shown = infrared;
    ASSERT_TRUE(settle([&](const Picture& p) { shown.push_back(p); }));
    EXPECT_GT(mean_difference(before, shown.back()), 10);
    EXPECT_LT(mean_difference(before, shown.front()), 0.1) << "its photos are not there yet";
    const auto settled_at =
        std::ranges::find_if(shown, [&](const Picture& p) { return mean_difference(before, p) > 0.1; });
    EXPECT_GE(shown.end() - settled_at, 5) << "it fades in";
    for (std::size_t f = 0; f < shown.size(); ++f) {
        std::size_t of_neither = 0;  // beside edges, until the finest tiles are there
        for (std::size_t i = 0; i < before.rgba.size(); ++i) {
            const int low = std::min(before.rgba[i], shown.back().rgba[i]),
                      high = std::max(before.rgba[i], shown.back().rgba[i]), is = shown[f].rgba[i];
            of_neither += is < low - 24 || is > high + 24;
        }
        EXPECT_LT(double(of_neither) / double(before.rgba.size()), 0.02) << "frame " << f;
    }
    s.image_sets = {.shown = infrared, .other = visible, .share = 0.5};
    ASSERT_TRUE(settle([](const Picture&) {}));
    EXPECT_LE(largest_error(before, shown.back(), shown_picture(renderer, front(), s), 0.5), 2);
}

TEST_F(ImageSets, BothEyesSeeThem) {
    make(small_scene());
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    std::array<View, 2> eyes{front(), front()};
    eyes[1].cam_from_origin.t.x() -= 0.3;
    RenderSettings s;
    s.complete = false;
    s.fill_holes = true;
    double now = 0;
    const auto settle = [&] {
        for (int i = 0; i < 600; ++i) {
            now += 1.0 / 30;
            FrameReport report = renderer.prepare(eyes, s, all(package), {}, now);
            for (const std::size_t eye : {0, 1}) renderer.paint(eye, report);
            if (report.settled) return true;
        }
        return false;
    };
    ASSERT_TRUE(settle());
    s.image_sets = {.shown = infrared, .other = visible, .share = 0.5};
    ASSERT_TRUE(settle());
    Renderer alone(package, MemoryBudget{});
    for (const std::size_t eye : {0, 1}) {
        const Picture of_pair = picture_of(
            frame_size(eyes[eye]), [&](GLuint target) { renderer.show(eyes[eye], s, target, false, eye); });
        RenderSettings single = s;
        single.complete = true;
        EXPECT_LT(mean_difference(of_pair, take_picture(alone, eyes[eye], single, all(package), 1)), 1);
    }
}

TEST_F(ImageSets, ExposureIsDecidedPerImageSet) {
    SynthSpec spec = small_scene();
    spec.infrared.stops = 1;
    make(spec);
    const PackageReader brighter = prepared();
    EXPECT_FALSE(effect_on(brighter.scene(), Effect::exposure))
        << "one image set is twice as bright as the other";
    EXPECT_TRUE(std::ranges::all_of(brighter.photos(), is_neutral));
    spec.exposure.stops = 0.5;  // of photos in visible light
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
    EXPECT_GE(pairs, 6u) << "photos of each image set share surface";
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
    EXPECT_EQ(message(records, "", 1), "BAND: image set 0 has no name of its own that a folder may have");
    EXPECT_EQ(message(records, "infrared", 9),
              "BAND: image set 1 has no name of its own that a folder may have");
    EXPECT_EQ(message(records, "../../up", 9),
              "BAND: image set 0 has no name of its own that a folder may have");
}

TEST_F(ImageSetsAtLength, EvaluatePredictsAPhotoFromItsOwnImageSet) {
    make(small_scene());
    prepared("scene");
    for (const std::string image_set : {"visible", "infrared"}) {
        const std::string other = image_set == "visible" ? "infrared" : "visible",
                          noise = "noise-in-" + other;
        fs::copy(dir / "scene", dir / noise, fs::copy_options::recursive);
        add_noise(noise, other);
        prepared(noise);
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
            run(player + file + " --offscreen -q --scale 0.5 -o " + (dir / "p.png").string() + " " + options);
        return ran.code == 0 ? slurp(dir / "p.png") : ran.says;
    };
    const std::string own = shoot("--photo infrared_0001");
    EXPECT_EQ(own, shoot("--photo infrared_0001 --image-set INFRARED"))
        << "a photo's camera shows its own image set";
    EXPECT_NE(own, shoot("--photo infrared_0001 --image-set visible"));
    EXPECT_NE(own, shoot("--photo infrared_0001 --image-set visible --second-image-set infrared=0.5"));
    EXPECT_EQ(own, shoot("--photo infrared_0001 --image-set visible --second-image-set infrared=1"));
    EXPECT_EQ(shoot("--photo infrared_0001 --image-set uv"),
              "vantage-player: " + file + ": has no image set 'uv', expected one of visible, infrared\n");
    EXPECT_EQ(shoot("--photo infrared_0001 --second-image-set infrared=2"),
              "vantage-player: --second-image-set infrared=2: expected NAME or NAME=SHARE with a share from "
              "0 to 1\n");
    EXPECT_EQ(shoot("--photo infrared_0001 --second-image-set visible --image-set-view side-by-side"),
              "vantage-player: image set 'visible' is shown already, expected another one\n");
    EXPECT_NE(run(player + file + " --list").says.find("infrared_0001.jpg  infrared  260x200"),
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
