// Tests that the output of `vantage inspect` is correct, agrees with `vantage prepare`, and is complete even
// if a part of the scan is missing.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <vector>

#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/formats/export_colmap.h"
#include "pipeline/synth/synthesize.h"
#include "tests/datasets.h"
#include "tests/made_scenes.h"
#include "tests/one_line.h"
#include "tests/programs/patterns.h"
#include "tests/programs/run_program.h"
#include "tests/temporary_folder.h"

using namespace vantage;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

constexpr double degrees = std::numbers::pi / 180;

class Inspect : public TemporaryFolder {
  protected:
    const fs::path scan = dir / "scan";

    void SetUp() override {
        TemporaryFolder::SetUp();
        ::setenv("XDG_CACHE_HOME", (dir / "cache").c_str(), 1);
        copy_scene(tiny(), scan);
        fs::remove_all(scan / "truth");
    }
    static SynthSpec tiny() {
        SynthSpec spec = tiny_spec();
        return spec;
    }
    Outcome run(const std::string& words) const { return run_command(VANTAGE_PROGRAM " " + words, dir); }
    Outcome inspect(const std::string& words = "") const {
        return run("inspect " + (words.empty() ? scan.string() : words));
    }
    Outcome prepare() const {
        return run("prepare --progress none --no-report " + scan.string() + " -o " +
                   (dir / "scan.vantage").string());
    }
    /// The JSON output, which must contain the program's exit code.
    json facts(const std::string& words = "") const {
        const Outcome done = inspect((words.empty() ? scan.string() : words) + " --json");
        const json j = json::parse(done.out, nullptr, false);
        EXPECT_FALSE(j.is_discarded()) << done.out << done.err;
        EXPECT_EQ(j.value("exit_code", -1), done.code);
        return j;
    }
    fs::path photo(int i) const {
        std::set<fs::path> all;
        for (const auto& e : fs::directory_iterator(scan / "images")) all.insert(e.path());
        return *std::next(all.begin(), i);
    }
    /// Turns cameras around so that they face away from the mesh.
    void turn_around(std::set<std::string> photos) const {
        std::vector<NamedCamera> cameras;
        for (const CameraSet::Entry& e : read_cameras(scan / "sparse").entries) {
            cameras.push_back({e.photo, e.camera});
            Pose& pose = cameras.back().camera.cam_from_world;
            const Eigen::Matrix3d turn = Eigen::Vector3d(-1, 1, -1).asDiagonal();
            if (photos.contains(e.photo)) pose = {turn * pose.R, turn * pose.t};
        }
        write_colmap_text(scan / "sparse", cameras);
    }
};

/// Every path below a folder, with its size and modification time.
std::map<fs::path, std::pair<std::uintmax_t, fs::file_time_type>> contents_of(const fs::path& folder) {
    std::map<fs::path, std::pair<std::uintmax_t, fs::file_time_type>> all;
    for (const auto& e : fs::recursive_directory_iterator(folder))
        all[e.path()] = {e.is_directory() ? 0 : e.file_size(), e.last_write_time()};
    return all;
}

/// The counts and the extent of a binary PLY written by `vantage synth`, which has three doubles and three
/// floats per vertex.
struct PlyTruth {
    std::size_t vertices = 0, triangles = 0;
    Eigen::AlignedBox3d box;

    explicit PlyTruth(const fs::path& file) {
        std::ifstream in(file, std::ios::binary);
        for (std::string line; std::getline(in, line) && line != "end_header";) {
            std::sscanf(line.c_str(), "element vertex %zu", &vertices);
            std::sscanf(line.c_str(), "element face %zu", &triangles);
        }
        for (std::size_t i = 0; i < vertices; ++i) {
            Eigen::Vector3d p;
            in.read(reinterpret_cast<char*>(p.data()), 24).ignore(12);
            box.extend(p);
        }
    }
};

Eigen::Vector3d point(const json& j) { return {j[0].get<double>(), j[1].get<double>(), j[2].get<double>()}; }

json effect(const json& facts, const std::string& name) {
    for (const json& e : facts["effects"])
        if (e["name"] == name) return e;
    ADD_FAILURE() << "no effect " << name;
    return {};
}

}  // namespace

TEST_F(Inspect, StatesTheTruthOfASyntheticScan) {
    const SynthSpec truth = tiny();
    const json j = facts();
    EXPECT_EQ(j["exit_code"], 0);
    EXPECT_TRUE(j["error"].is_null());

    const PlyTruth mesh(scan / "mesh.ply");
    EXPECT_EQ(j["mesh"]["vertices"], mesh.vertices);
    EXPECT_EQ(j["mesh"]["triangles"], mesh.triangles);
    EXPECT_EQ(j["mesh"]["format"], "PLY");
    EXPECT_EQ(j["mesh"]["bytes"], fs::file_size(scan / "mesh.ply"));
    EXPECT_LT((point(j["mesh"]["low"]) - mesh.box.min()).norm(), 1e-9);
    EXPECT_LT((point(j["mesh"]["high"]) - mesh.box.max()).norm(), 1e-9);

    std::uintmax_t bytes = 0;
    for (const auto& e : fs::directory_iterator(scan / "images")) bytes += e.file_size();
    EXPECT_EQ(j["photos"]["count"], truth.photos.count);
    EXPECT_EQ(j["photos"]["bytes"], bytes);
    EXPECT_NEAR(j["photos"]["megapixels"],
                truth.photos.count * truth.photos.width * truth.photos.height / 1e6, 1e-9);
    ASSERT_EQ(j["photos"]["groups"].size(), 1u);
    EXPECT_EQ(j["photos"]["groups"][0]["format"], "JPEG");
    EXPECT_EQ(j["photos"]["groups"][0]["width"], truth.photos.width);
    EXPECT_EQ(j["photos"]["groups"][0]["height"], truth.photos.height);

    EXPECT_EQ(j["cameras"]["count"], truth.photos.count);
    ASSERT_EQ(j["cameras"]["lenses"].size(), 1u);
    const json& lens = j["cameras"]["lenses"][0];
    const double focal = truth.photos.width / 2.0 / std::tan(truth.photos.fov / 2 * degrees);
    EXPECT_NEAR(lens["focal_x"][0], focal, 1e-9);
    EXPECT_NEAR(lens["focal_x"][1], focal, 1e-9);
    EXPECT_EQ(lens["calibrations"], 1);
    EXPECT_TRUE(lens["coefficients"].empty());
    // The principal point is slightly off-center.
    EXPECT_NEAR(lens["field_of_view_x"][0], truth.photos.fov, 0.1);
    EXPECT_EQ(j["usable_photos"], truth.photos.count);
    EXPECT_TRUE(j["not_seeing"].empty());
    EXPECT_EQ(effect(j, "undistortion")["on"], false);
    EXPECT_TRUE(effect(j, "pose-refinement")["on"].is_null())
        << "this should be undecided, because the decision depends on the photos' pixels";

    // The cameras are on an arc of known radius around the building.
    const Eigen::Vector3d low = point(j["cameras"]["low"]), high = point(j["cameras"]["high"]);
    EXPECT_NEAR(high.x() - low.x(), 2 * truth.photos.radius * std::sin(truth.photos.arc / 2 * degrees), 0.01);
    EXPECT_EQ(j["scale"]["guessed_units"], json{"m"});
    EXPECT_LT(j["scale"]["distance"][0], truth.photos.radius);
    EXPECT_GT(j["scale"]["distance"][1], truth.photos.radius / 2);
    EXPECT_NEAR(double(j["scale"]["typical_pixel"]) * focal, j["scale"]["typical_distance"], 0.01);
    EXPECT_NEAR(double(j["scale"]["typical_distance_in_diagonals"]) * mesh.box.diagonal().norm(),
                j["scale"]["typical_distance"], 1e-9);
}

TEST_F(Inspect, TextAndJsonAgree) {
    fs::remove(photo(4));
    const json j = facts();
    const std::string text = inspect().out;
    ASSERT_EQ(j["skipped"].size(), 1u);
    const auto expect = [&](const std::string& part) {
        EXPECT_NE(text.find(part), text.npos) << part << " is not in\n" << text;
    };
    const auto number = [](const json& n) { return std::to_string(n.get<std::size_t>()); };
    expect(number(j["mesh"]["vertices"]) + " vertices, " + number(j["mesh"]["triangles"]) + " triangles");
    expect(number(j["cameras"]["count"]) + " cameras\n");
    expect(number(j["photos"]["count"]) + " photos, ");
    expect("4 JPEG of 331x250");
    expect("skipped  " + j["skipped"][0]["photo"].get<std::string>() + ": " +
           j["skipped"][0]["why"].get<std::string>());
    expect("prepare would use 4 photos and skip 1");
    for (const json& e : j["effects"])
        if (!e["on"].is_null()) expect(e["evidence"]);
    expect(
        "exposure, vignetting, pose-refinement, transients, background are decided from the photos' "
        "pixels");
}

TEST_F(Inspect, CoefficientsOfTheLensAreNamed) {
    SynthSpec spec = tiny();
    spec.lens = {.k1 = -0.08, .k2 = 0.015};
    copy_scene(spec, dir / "lens");
    const json j = facts((dir / "lens").string());
    const json& lens = j["cameras"]["lenses"][0];
    EXPECT_EQ(lens["coefficients"], (json{{"k1", {-0.08, -0.08}}, {"k2", {0.015, 0.015}}}));
    EXPECT_EQ(effect(j, "undistortion")["on"], true);
    // The tangent of the angle at which the lens sees the frame's edge, computed by fixed-point iteration.
    const double half = std::tan(spec.photos.fov / 2 * degrees);
    double x = half;
    for (int i = 0; i < 100; ++i) x = half / (1 + x * x * (spec.lens.k1 + x * x * spec.lens.k2));
    EXPECT_NEAR(lens["field_of_view_x"][0], 2 * std::atan(x) / degrees, 0.1);
    EXPECT_GT(lens["field_of_view_x"][0], spec.photos.fov + 1);
    EXPECT_NE(inspect((dir / "lens").string()).out.find("radial and tangential: k1 -0.08, k2 0.015\n"),
              std::string::npos);
}

TEST_F(Inspect, PhotosSkippedAreThoseOfPrepareForTheSameReasons) {
    const std::string gone = photo(0).filename().string(), broken = photo(1).filename().string();
    fs::copy_file(photo(2), scan / "images" / "extra.jpg");
    fs::remove(photo(0));
    std::ofstream(scan / "images" / broken, std::ios::trunc) << "no photo";
    const json j = facts();
    EXPECT_EQ(j["exit_code"], 9);
    EXPECT_EQ(j["usable_photos"], 3);
    std::map<std::string, std::string> why;
    for (const json& l : j["skipped"]) why[l["photo"]] = l["why"];
    ASSERT_EQ(why.size(), 3u);
    EXPECT_EQ(why.at(gone), "has a camera but no photo");
    EXPECT_EQ(why.at("extra.jpg"), "has no camera");
    EXPECT_NE(why.at(broken).find("not a readable photo"), std::string::npos);
    EXPECT_EQ(j["photos"]["count"], 5);
    EXPECT_EQ(j["cameras"]["count"], 5);

    const Outcome prepared = prepare();
    EXPECT_EQ(prepared.code, 9);
    for (const auto& [name, reason] : why)
        EXPECT_NE(prepared.out.find("skipped " + name + ": " + reason + "\n"), std::string::npos) << name;
}

TEST_F(Inspect, NeedsAreThoseThatPreparePrints) {
    constexpr const char* line =
        R"(needs    about (\d+) s, at most (\d+) MB of memory \((\d+) photos at a time\), (\d+) MB of disk)";
    const std::string before = inspect().out, then = prepare().out;
    const auto befores = matches(before, line), thens = matches(then, line);
    ASSERT_FALSE(befores.empty()) << before;
    ASSERT_FALSE(thens.empty()) << then;
    const auto &looked = befores[0], &prepared = thens[0];
    EXPECT_NEAR(std::stod(looked[1]), std::stod(prepared[1]), 1);
    EXPECT_NEAR(std::stod(looked[2]), std::stod(prepared[2]), 0.1 * std::stod(prepared[2]));
    EXPECT_EQ(looked[3], prepared[3]);
    EXPECT_EQ(looked[4], prepared[4]);
}

TEST_F(Inspect, NothingIsWritten) {
    fs::create_directories(dir / "cache");
    fs::create_directories(dir / "here");
    for (const char* file : {"out.txt", "err.txt"}) std::ofstream(dir / file) << "";
    const auto before = contents_of(dir);
    const std::string command =
        "cd " + (dir / "here").string() + " && " VANTAGE_PROGRAM " inspect " + scan.string() + " >/dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(contents_of(dir), before);
}

/// Identities would be cached only for files that are older than a few seconds, such as those of a dataset.
TEST_F(Inspect, IdentitiesOfFilesAreNotCached) {
    VANTAGE_DATASET(real, "sceaux-small");
    EXPECT_EQ(inspect(fs::absolute(real).string()).code, 0);
    EXPECT_FALSE(fs::exists(dir / "cache"));
}

TEST_F(Inspect, WhatIsThereIsShownIfAPartIsMissing) {
    struct Case {
        const char* without;  ///< path of the missing part, relative to the scan
        std::map<std::string, bool> known;
        const char* text;
    };
    const Case cases[] = {
        {"sparse", {{"mesh", true}, {"cameras", false}, {"photos", true}}, "5 JPEG of 331x250"},
        {"images", {{"mesh", true}, {"cameras", true}, {"photos", false}}, "5 cameras of 331x250"},
        {"mesh.ply", {{"mesh", false}, {"cameras", true}, {"photos", true}}, "COLMAP text, 5 cameras"}};
    for (const Case& c : cases) {
        fs::rename(scan / c.without, dir / "away");
        const Outcome looked = inspect(), prepared = prepare();
        EXPECT_EQ(looked.code, 3) << c.without;
        EXPECT_EQ(looked.err, prepared.err);
        EXPECT_TRUE(one_line(looked.err)) << looked.err;
        EXPECT_NE(looked.out.find(c.text), std::string::npos) << looked.out;
        const json j = facts();
        for (const auto& [key, known] : c.known)
            EXPECT_EQ(!j[key].is_null(), known) << c.without << ": " << key;
        EXPECT_EQ("vantage: " + j["error"]["message"].get<std::string>() + "\n", prepared.err);
        EXPECT_EQ(j["error"]["exit_code"], 3);
        EXPECT_TRUE(j["needs"].is_null());
        fs::rename(dir / "away", scan / c.without);
    }
}

TEST_F(Inspect, WhatIsThereIsShownIfAPartCannotBeRead) {
    fs::resize_file(scan / "mesh.ply", fs::file_size(scan / "mesh.ply") / 2);
    const Outcome looked = inspect(), prepared = prepare();
    EXPECT_EQ(looked.code, 3);
    EXPECT_EQ(looked.err, prepared.err);
    EXPECT_NE(looked.out.find("mesh.ply: cannot be used"), std::string::npos) << looked.out;
    EXPECT_NE(looked.out.find("COLMAP text, 5 cameras"), std::string::npos) << looked.out;
    // If two parts are invalid, one is reported as an error and the other as a warning.
    std::ofstream(scan / "sparse" / "images.txt", std::ios::trunc) << "1 2 3\n";
    const json j = facts();
    EXPECT_TRUE(j["mesh"].is_null());
    EXPECT_TRUE(j["cameras"].is_null());
    EXPECT_EQ(j["photos"]["count"], 5);
    EXPECT_NE(j["error"]["message"].get<std::string>().find("images.txt"), std::string::npos);
    ASSERT_EQ(j["warnings"].size(), 1u);
    EXPECT_NE(j["warnings"][0].get<std::string>().find("mesh.ply"), std::string::npos);
}

TEST_F(Inspect, AnEmptyFolderHasNothing) {
    fs::create_directories(dir / "empty");
    const Outcome looked = inspect((dir / "empty").string());
    EXPECT_EQ(looked.code, 3);
    for (const char* part : {"mesh     none", "cameras  none", "photos   none"})
        EXPECT_NE(looked.out.find(part), std::string::npos) << looked.out;
    const Outcome nowhere = inspect((dir / "nowhere").string());
    EXPECT_EQ(nowhere.code, 3);
    EXPECT_EQ(nowhere.out, "");
    EXPECT_TRUE(one_line(nowhere.err)) << nowhere.err;
    EXPECT_EQ(run("inspect").code, 2);
}

TEST_F(Inspect, CamerasThatDoNotSeeTheMeshAreNamed) {
    const std::string away = photo(2).filename().string();
    turn_around({away});
    const json one = facts();
    EXPECT_EQ(one["not_seeing"], json{away});
    EXPECT_EQ(one["exit_code"], 0);
    std::set<std::string> others;
    for (int i : {0, 1, 3, 4}) others.insert(photo(i).filename().string());
    turn_around(others);
    const json all = facts();
    EXPECT_EQ(all["not_seeing"].size(), 5u);
    EXPECT_EQ(all["exit_code"], 13);
    EXPECT_EQ(prepare().code, 13);
}

TEST_F(Inspect, EachObjectOfASceneFileIsShown) {
    fs::create_directories(dir / "empty");
    std::ofstream(dir / "two.toml") << "[[object]]\ninput = \"scan\"\n[[object]]\ninput = \"empty\"\n";
    const json j = facts((dir / "two.toml").string());
    EXPECT_EQ(j["exit_code"], 3);
    ASSERT_EQ(j["objects"].size(), 2u);
    EXPECT_EQ(j["objects"][0]["name"], "scan");
    EXPECT_EQ(j["objects"][0]["usable_photos"], 5);
    EXPECT_EQ(j["objects"][1]["name"], "empty");
    EXPECT_EQ(j["objects"][1]["error"]["exit_code"], 3);
    const std::string text = inspect((dir / "two.toml").string()).out;
    EXPECT_LT(text.find("object   scan\n"), text.find("object   empty\n"));
}

TEST_F(Inspect, PartsAreTakenFromTheCommandLine) {
    const json parts = facts("--mesh " + (scan / "mesh.ply").string() + " --cameras " +
                             (scan / "sparse").string() + " --photos " + (scan / "images").string());
    json folder = facts();
    for (const char* key : {"needs", "notes"}) folder[key] = parts[key];
    EXPECT_EQ(parts, folder);
    // A camera file alone is not a valid input, but it is described.
    const json cameras = facts("--cameras " + (scan / "sparse").string());
    EXPECT_EQ(cameras["exit_code"], 2);
    EXPECT_EQ(cameras["cameras"]["count"], 5);
    const json points = facts("--points " + (scan / "mesh.ply").string());
    EXPECT_EQ(points["exit_code"], 0);
    EXPECT_EQ(points["points"]["vertices"], PlyTruth(scan / "mesh.ply").vertices);
    EXPECT_TRUE(points["mesh"].is_null());
}

TEST_F(Inspect, EveryKeyOfTheJsonIsDocumented) {
    const std::string document = slurp(fs::path(VANTAGE_SOURCE_DIR) / "docs" / "inspect.md");
    fs::remove(photo(0));
    const json j = facts();
    std::vector<const json*> open{&j};
    std::set<std::string> keys;
    while (!open.empty()) {
        const json& here = *open.back();
        open.pop_back();
        for (const auto& [key, value] : here.items()) {
            if (here.is_object()) keys.insert(key);
            if (value.is_structured()) open.push_back(&value);
        }
    }
    EXPECT_GT(keys.size(), 50u);
    for (const std::string& key : keys)
        EXPECT_NE(document.find("`" + key + "`"), document.npos) << key << " is not in docs/inspect.md";
}
