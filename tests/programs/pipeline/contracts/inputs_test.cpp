// Tests the guarantees of docs/contracts.md about inputs and packages, that is, the meaning of "current" and
// "valid".
#include <fstream>

#include "base/text/error.h"
#include "scene/package/package_reader.h"
#include "tests/made_scenes.h"
#include "tests/one_line.h"
#include "tests/programs/patterns.h"
#include "tests/programs/pipeline/contracts/contracts.h"

using namespace vantage;

TEST_F(ContractsAtLength, RepairedPhotosAreTakenUpAgain) {
    const fs::path photo = images / "0002.jpg";
    const std::string valid = slurp(photo), bytes = undisturbed();
    SynthSpec spec = spec_named("tiny");
    spec.photos.count = 1;
    spec.photos.width = 120;
    spec.photos.height = 110;
    copy_scene(spec, dir / "other");
    const std::string broken[] = {"", valid.substr(0, 100), valid.substr(0, valid.size() / 2),
                                  slurp(dir / "other" / "images" / "0000.jpg")};
    for (const std::string& bad : broken) {
        const std::string rehash = bad.empty() ? "--rehash" : "";
        write(photo, bad);
        const Outcome lacking = prepare_program(rehash);
        EXPECT_EQ(lacking.code, int(Exit::incomplete)) << bad.size() << lacking.out;
        write(photo, valid);
        EXPECT_EQ(run("check " + package() + " --against " + scene.string()).code, int(Exit::stale))
            << bad.size();
        const Outcome repaired = prepare_program(rehash);
        EXPECT_EQ(repaired.code, 0) << bad.size() << repaired.out;
        expect_whole(bytes, "a repaired photo");
    }
    write(images / "passer-by.jpg", "no camera");
    EXPECT_EQ(prepare_program().code, int(Exit::incomplete));
    write(images / "passer-by.jpg", "still no camera");
    EXPECT_EQ(run("check " + package() + " --against " + scene.string()).code, int(Exit::incomplete))
        << "a photo without a camera should not be an input";
}

TEST_F(ContractsAtLength, PackagesDoNotDependOnWhereTheInputsAre) {
    write(images / "0001.jpg", "not a picture");
    const fs::path elsewhere = dir / "elsewhere", other = dir / "other.vantage";
    fs::copy(scene, elsewhere, fs::copy_options::recursive);
    EXPECT_EQ(prepare_program().code, int(Exit::incomplete));
    EXPECT_EQ(run("prepare --progress none " + elsewhere.string() + " -o " + other.string()).code,
              int(Exit::incomplete));
    EXPECT_TRUE(slurp(file) == slurp(other));
}

void vantage::Contracts::expect_damage_found(std::initializer_list<package::Type> types) {
    PrepareSettings settings;
    settings.vertex_coordinates = true;
    const std::string bytes = undisturbed(settings);
    const auto prepare_again = [&] { return prepare_program("--vertex-coordinates"); };
    copy_package(scene, settings, file);
    const fs::path valid = dir / "valid.vantage", files = dir / "files";
    fs::copy_file(file, valid);
    for (const package::Type type : types) {
        const bool whole = type == package::Type::positions, weights = type == package::Type::weight_maps;
        const bool extracted = whole || weights || type == package::Type::tiles;
        if (weights) {
            std::uint64_t at;
            {
                const PackageReader reader(file);
                const auto* e = reader.find(type, 1, 1);
                at = e->offset + e->head_length + 40;
            }
            std::fstream out(file, std::ios::in | std::ios::out | std::ios::binary);
            out.seekp(std::streamoff(at));
            out << "rot";
        } else {
            damage(type, whole ? package::scene_wide : 1);
        }
        EXPECT_EQ(run("check --deep " + package()).code, int(Exit::damaged));
        fs::remove_all(files);
        const Outcome x = run("extract " + package() + " -o " + files.string());
        EXPECT_EQ(x.code, extracted ? int(Exit::damaged) : 0) << int(type);
        EXPECT_EQ(one_line(x.err), extracted) << x.err;
        EXPECT_EQ(fs::exists(files / "photos" / "0001.jpg"), type != package::Type::tiles);
        const Outcome d = run("diff " + package() + " " + valid.string());
        EXPECT_EQ(d.code, int(Exit::damaged)) << d.out;
        EXPECT_TRUE(one_line(d.err)) << d.err;
        const Outcome repaired = prepare_again();
        EXPECT_EQ(repaired.code, 0) << repaired.err;
        EXPECT_NE(repaired.out.find("is damaged and will be repaired: "), std::string::npos) << repaired.out;
        expect_whole(bytes, "a repaired package");
    }
    damage(package::Type::tiles, 1);
    const Outcome evaluated =
        player("evaluate " + package() + " --photo 0001 --level 0 -o " + (dir / "e").string());
    EXPECT_EQ(evaluated.code, int(Exit::damaged));
    EXPECT_EQ(prepare_again().code, 0);
    fs::resize_file(file, fs::file_size(file) / 2);
    EXPECT_EQ(prepare_again().code, 0) << "a truncated package should still be replaced";
    expect_whole(bytes, "a truncated package");
}

TEST_F(Contracts, DamagedPackagesAreFoundByAllThatReadThem) {
    expect_damage_found({package::Type::tiles, package::Type::weight_maps});
}

TEST_F(ContractsAtLength, DamagedPackagesAreFoundByAllThatReadThem) {
    expect_damage_found({package::Type::tiles, package::Type::weight_maps, package::Type::thumbnail,
                         package::Type::coordinates, package::Type::positions});
}

TEST_F(ContractsAtLength, EveryCameraFileIsAnInput) {
    const std::string explicit_text = "prepare --progress none --mesh " + mesh.string() + " --photos " +
                                      images.string() + " -o " + package() + " --cameras ";
    const auto expect_stale = [&](const std::string& words, const std::string& changed) {
        const Outcome o = run(words + " --explain");
        EXPECT_EQ(o.out.find("nothing to do"), std::string::npos) << changed << '\n' << o.out;
    };
    const std::string by_file = explicit_text + (sparse / "cameras.txt").string();
    ASSERT_EQ(run(by_file).code, 0);
    write(sparse / "images.txt", slurp(sparse / "images.txt") + "# a comment\n");
    expect_stale(by_file, "images.txt next to the given cameras.txt has changed");

    // The same cameras in a Bundler file, with the principal point at the image center.
    std::string bundle = "# Bundle file v0.3\n6 0\n", list;
    for (const PhotoInput& photo : read_scene(discover(scene)).photos) {
        const Camera& c = photo.camera;
        const Eigen::Vector3d flip(1, -1, -1);
        const Eigen::Matrix3d R = flip.asDiagonal() * c.cam_from_world.R;
        const Eigen::Vector3d t = flip.asDiagonal() * c.cam_from_world.t;
        std::ostringstream out;
        out << c.intrinsics.fx << " 0 0\n" << R << '\n' << t.transpose() << '\n';
        bundle += out.str();
        list += photo.name + "\n";
    }
    write(dir / "bundle.out", bundle);
    write(dir / "list.txt", list);
    const std::string by_bundle = explicit_text + (dir / "bundle.out").string();
    ASSERT_EQ(run(by_bundle).code, 0);
    EXPECT_NE(run(by_bundle).out.find("nothing to do"), std::string::npos);
    write(dir / "list.txt", replaced(list, "0000.jpg\n0001.jpg", "0001.jpg\n0000.jpg"));
    expect_stale(by_bundle, "list.txt");

    ASSERT_EQ(prepare_program().code, 0);
    fs::rename(scene / "truth", dir / "truth");  // contains cameras, too
    for (const char* name : {"cameras.bin", "images.bin"})
        write(sparse / name, std::string(8, '\0'));  // no cameras, but binary files are preferred
    const Outcome checked = run("check " + package() + " --against " + scene.string());
    EXPECT_EQ(checked.code, int(Exit::stale));
    EXPECT_NE(checked.out.find("cameras.bin: was added"), std::string::npos) << checked.out;
    EXPECT_EQ(prepare_program().code, int(Exit::input)) << "prepare should read the binary files";
    fs::rename(dir / "truth", scene / "truth");
    write(sparse / "cameras.bin", "cut off");
    EXPECT_EQ(run("check " + package() + " --against " + scene.string()).code, int(Exit::input));
}

TEST_F(Contracts, InputsThatChangeDuringARunStopIt) {
    write(images / "0001.mask.png", slurp(images / "0001.jpg"));
    for (const fs::path& input :
         {mesh, sparse / "images.txt", images / "0002.jpg", images / "0001.mask.png"}) {
        const SceneInput read = read_scene(discover(scene));
        const std::string before = slurp(input);
        write(input, before + "\n");
        try {
            prepare(read, {}, file, [](const Progress&) {});
            ADD_FAILURE() << input << ": the package would hold the old content and the new checksum";
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::input);
            EXPECT_NE(std::string(e.what()).find(input.string() + ": changed while it was being prepared"),
                      std::string::npos)
                << e.what();
        }
        EXPECT_FALSE(fs::exists(file));
        write(input, before);
    }
}
