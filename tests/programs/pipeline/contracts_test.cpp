// What docs/contracts.md promises: what programs write and replace, what they never touch, and what "current"
// and "valid" mean.
#include <sys/stat.h>

#include <fstream>
#include <functional>

#include "base/text/error.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/photos/photos.h"
#include "scene/package/package_reader.h"
#include "tests/made_scenes.h"
#include "tests/one_line.h"
#include "tests/programs/overnight.h"
#include "tests/programs/patterns.h"

using namespace vantage;

namespace {

void write(const fs::path& to, const std::string& bytes) { std::ofstream(to, std::ios::binary) << bytes; }

class Contracts : public Overnight {
  protected:
    const fs::path images = scene / "images", mesh = scene / "mesh.ply", sparse = scene / "sparse";

    /// Expects a refusal in one line, before any work, that leaves `kept` as it is.
    void expect_refused(const std::string& words, const fs::path& kept,
                        const std::string& program = VANTAGE_PROGRAM) const {
        const std::string before = slurp(kept);
        const Outcome o = run(words, "", program);
        EXPECT_EQ(o.code, int(Exit::usage)) << words << '\n' << o.out << o.err;
        EXPECT_TRUE(one_line(o.err)) << words << '\n' << o.err;
        EXPECT_EQ(o.out, "") << words;
        EXPECT_TRUE(slurp(kept) == before) << words << ": " << kept;
    }
    std::string prepare_to(const fs::path& out) const {
        return "prepare --progress none " + scene.string() + " -o " + out.string() + " ";
    }
    Outcome player(const std::string& words) const { return run(words, "", VANTAGE_PLAYER); }
    std::string package() const { return file.string(); }

    /// Overwrites bytes of a chunk without changing the file's size.
    void damage(package::Type type, std::uint32_t photo = package::scene_wide, std::uint64_t at = 20) const {
        {
            const PackageReader reader(file);
            const auto* e = reader.find(type, photo);
            at += e->offset + (e->block_length || e->coded_blocks ? e->head_length : 0);
        }
        std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
        bytes.seekp(std::streamoff(at));
        bytes << "rot";
    }
    void expect_damage_found(std::initializer_list<package::Type> types);
    /// Makes the second photo a PNG whose name without extension is that of the first.
    void share_a_stem() const {
        const std::string jpeg = slurp(images / "0001.jpg");
        const RgbaImage image = read_photo(images / "0001.jpg", read_photo_header(images / "0001.jpg").size);
        image_files().write(images / "0000.png", image.width, image.height, 4, Sample::u8,
                            std::as_bytes(std::span(image.rgba)));
        fs::remove(images / "0001.jpg");
        write(sparse / "images.txt", replaced(slurp(sparse / "images.txt"), "0001\\.jpg", "0000.png"));
    }
};
class ContractsAtLength : public Contracts {};

}  // namespace

TEST_F(Contracts, PhotosOfEqualStemKeepTheirOwnFiles) {
    share_a_stem();
    ASSERT_EQ(prepare_program().code, 0);
    const fs::path files = dir / "files", pictures = dir / "pictures", evaluation = dir / "evaluation";
    ASSERT_EQ(run("extract " + package() + " -o " + files.string()).code, 0);
    const Outcome shown =
        player(package() + " --offscreen --photo 0000.jpg,0000.png --scale 0.1 -o " + pictures.string());
    ASSERT_EQ(shown.code, 0) << shown.err;
    const Outcome evaluated = player("evaluate " + package() + " --level 3 -o " + evaluation.string() +
                                     " --photo 0000.jpg,0000.png");
    ASSERT_EQ(evaluated.code, 0) << evaluated.err;
    for (const std::string photo : {"0000.jpg", "0000.png"})
        for (const fs::path& made :
             {files / "photos" / (photo + photo.substr(4)), files / "masks" / (photo + ".weights.png"),
              files / "depth" / (photo + ".exr"), pictures / (photo + ".png"),
              evaluation / (photo + "-photo.png")})
            EXPECT_TRUE(fs::exists(made)) << made;
    EXPECT_NE(slurp(files / "photos" / "0000.jpg.jpg"), slurp(files / "photos" / "0000.png.png"));
    EXPECT_TRUE(fs::exists(files / "photos" / "0002.jpg")) << "unique names stay short";
}

TEST_F(Contracts, AmbiguousPhotoNamesAreRefused) {
    share_a_stem();
    const Outcome held = prepare_program("--hold-out 0000");
    EXPECT_EQ(held.code, int(Exit::usage));
    ASSERT_EQ(prepare_program("--hold-out 0000.png").code, 0);
    const Outcome extracted = run("extract " + package() + " --photo 0000 -o " + (dir / "x").string());
    const Outcome shown = player(package() + " --offscreen --photo 0000 -o " + (dir / "x.png").string());
    for (const Outcome& o : {held, extracted, shown}) {
        EXPECT_EQ(o.code, int(Exit::usage)) << o.out;
        EXPECT_TRUE(one_line(o.err)) << o.err;
        EXPECT_NE(o.err.find("0000.jpg and 0000.png"), std::string::npos) << o.err;
    }
    EXPECT_FALSE(fs::exists(dir / "x.png"));
}

TEST_F(Contracts, PrepareReplacesOnlyPackagesReportsAndTracesOfItsOwn) {
    const fs::path text = dir / "notes.txt", page = dir / "chapel.html", other = dir / "other";
    write(text, "mine");
    write(page, "<html>mine</html>");
    write(images / "0001.mask.png", slurp(images / "0001.jpg"));
    for (const std::string force : {"", "--force"}) {
        for (const fs::path& input :
             {mesh, images / "0000.jpg", images / "0001.mask.png", sparse / "images.txt"}) {
            expect_refused(prepare_to(input) + force, input);
            expect_refused(prepare_to(file) + "--trace " + input.string() + " " + force, input);
        }
        expect_refused(prepare_to(images) + force, mesh);
        expect_refused(prepare_to(dir / "x.html") + force, mesh);
        expect_refused(prepare_to(file) + "--trace " + package() + " " + force, mesh);
        for (const char* own : {".part", ".former"}) {
            write(other.string() + own, "of another program");
            expect_refused(prepare_to(other) + force, other.string() + own);
            fs::remove(other.string() + own);
        }
    }
    expect_refused(prepare_to(text), text);
    expect_refused(prepare_to(dir / "chapel.vantage"), page);
    expect_refused(prepare_to(file) + "--trace " + text.string(), text);
    EXPECT_FALSE(fs::exists(file));

    const fs::path pipe = dir / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    for (const std::string force : {"", "--force"})
        EXPECT_EQ(run(prepare_to(pipe) + force).code, int(Exit::usage)) << "a device would become a file";
    EXPECT_TRUE(fs::is_fifo(pipe));

    fs::remove(images / "0001.mask.png");
    const std::string trace = "--trace " + (dir / "trace.json").string() + " ";
    EXPECT_EQ(run(prepare_to(text) + trace + "--force").code, 0);
    EXPECT_EQ(run(prepare_to(text) + trace + "--thumbnail-size 128").code, 0)
        << "package, report and trace again";
    const PackageReader replaced(text);
    EXPECT_EQ(replaced.photos()[0].thumbnail_width, 128u);
    write(file, "");
    EXPECT_EQ(run(prepare_to(file) + "--no-report").code, 0) << "an empty file holds nothing";
}

TEST_F(ContractsAtLength, LinksAreFollowed) {
    const fs::path store = dir / "store", link = dir / "link.vantage", dangling = dir / "new.vantage";
    fs::create_directory(store);
    fs::create_symlink("store/a.vantage", link);
    fs::create_symlink(store / "b.vantage", dangling);
    for (const fs::path& out : {link, dangling, link}) {
        const Outcome o = run(prepare_to(out) + "--thumbnail-size " + (fs::exists(link) ? "128" : "256"));
        EXPECT_EQ(o.code, 0) << o.err;
        EXPECT_TRUE(fs::is_symlink(out)) << out;
        EXPECT_TRUE(fs::is_regular_file(fs::read_symlink(out).is_absolute() ? fs::read_symlink(out)
                                                                            : dir / fs::read_symlink(out)));
    }
    EXPECT_EQ(run("refine " + link.string() + " --effect exposure=off").code, 0);
    EXPECT_TRUE(fs::is_symlink(link));
    fs::remove(link);
    fs::create_symlink(mesh, link);
    expect_refused(prepare_to(link) + "--force", mesh);
}

TEST_F(Contracts, OtherCommandsReplaceOnlyTheirOwnFiles) {
    copy_package(scene, {}, file);
    const fs::path text = dir / "notes.txt", files = dir / "files", share = dir / "1.share",
                   page = dir / "page";
    write(text, "mine");
    ASSERT_EQ(run(prepare_to(share) + "--shard 1/1").code, 0);
    expect_refused("merge " + share.string() + " -o " + share.string(), share);
    expect_refused("merge " + share.string() + " -o " + text.string(), text);
    expect_refused("refine " + package() + " -o " + text.string(), text);
    expect_refused("refine " + package() + " -o " + mesh.string() + " --force", mesh);
    expect_refused("merge " + share.string() + " -o " + mesh.string() + " --force", mesh);
    expect_refused("check " + package() + " --junit " + text.string(), text);
    expect_refused("check " + package() + " --junit " + package(), file);
    const fs::path spec = dir / "one.toml";
    write(spec, replaced(slurp(VANTAGE_SOURCE_DIR "/data/tiny.toml"), "count = 5", "count = 1"));
    for (int twice = 0; twice < 2; ++twice) {
        EXPECT_EQ(run("extract " + package() + " -o " + files.string()).code, 0);
        EXPECT_EQ(run("check " + package() + " --junit " + (dir / "checks.xml").string()).code, 0);
        EXPECT_EQ(run("synth " + spec.string() + " -o " + (dir / "synthetic").string()).code, 0);
        EXPECT_EQ(run("merge " + share.string() + " -o " + package()).code, 0);
    }
    write(files / "sparse" / "images.txt", "mine");
    expect_refused("extract " + package() + " -o " + files.string(), files / "sparse" / "images.txt");
    // The input mesh and a stencil, by content; --force does not help.
    for (const std::string force : {"", " --force"})
        expect_refused("extract " + package() + " -o " + scene.string() + force, mesh);
    fs::remove_all(scene / "truth");
    expect_refused("synth " VANTAGE_SOURCE_DIR "/data/tiny.toml -o " + scene.string(), images / "0000.jpg");
    fs::create_directories(page);
    write(page / "index.html", "<html>mine</html>");
    expect_refused("diff " + package() + " " + package() + " -o " + page.string(), page / "index.html");
}

TEST_F(Contracts, PlayerReplacesPicturesButNoInputs) {
    share_a_stem();  // 0000.png is a photo
    ASSERT_EQ(prepare_program("--hold-out 0002.jpg").code, 0);
    const fs::path text = dir / "notes.png", page = dir / "page", held = dir / "held.png",
                   copies = dir / "copies";
    write(text, "mine");
    fs::create_directories(copies);
    fs::copy_file(images / "0000.png", copies / "0004.png");
    const std::string small = package() + " --offscreen --photo 0003 --scale 0.1 -o ";
    for (const std::string force : {"", " --force"}) {
        expect_refused(small + (images / "0000.png").string() + force, images / "0000.png", VANTAGE_PLAYER);
        expect_refused(package() + " --offscreen --photo 0003,0004 -o " + copies.string() + force,
                       copies / "0004.png", VANTAGE_PLAYER);
        fs::copy_file(images / "0002.jpg", held, fs::copy_options::overwrite_existing);
        expect_refused(small + held.string() + force, held, VANTAGE_PLAYER);
    }
    expect_refused(small + text.string(), text, VANTAGE_PLAYER);
    EXPECT_EQ(player(small + text.string() + " --force").code, 0);
    EXPECT_EQ(player(small + text.string()).code, 0) << "a picture over an older one";
    fs::create_directories(page);
    write(page / "index.html", "<html>mine</html>");
    write(page / "frames.csv", "mine");
    write(page / "steps.csv", "mine");
    expect_refused("evaluate " + package() + " -o " + page.string(), page / "index.html", VANTAGE_PLAYER);
    expect_refused("bench " + package() + " -o " + page.string(), page / "frames.csv", VANTAGE_PLAYER);
    expect_refused("smoothness " + package() + " -o " + page.string(), page / "steps.csv", VANTAGE_PLAYER);
    expect_refused("verify " + package() + " --golden " + page.string() + " --junit " + text.string(), text,
                   VANTAGE_PLAYER);
    const std::string again = "evaluate " + package() + " --photo 0003 --level 3 -o " + (dir / "e").string();
    EXPECT_EQ(player(again).code, 0);
    EXPECT_EQ(player(again).code, 0) << "an evaluation over an older one";
    fs::remove(dir / "e" / "index.html");
    for (const char* last : {"photos.csv", "regions.csv", "regions.ply"}) fs::remove(dir / "e" / last);
    EXPECT_EQ(player(again).code, 0) << "an evaluation over one that was interrupted";
    fs::copy_file(images / "0000.png", dir / "e" / "0003-photo.png", fs::copy_options::overwrite_existing);
    expect_refused(again, dir / "e" / "0003-photo.png", VANTAGE_PLAYER);
}

TEST_F(ContractsAtLength, MeasurementsReplaceOlderOnes) {
    copy_package(scene, {}, file);
    const std::string bench = "bench " + package() + " --paths still --modes resident --path-frames 2 " +
                              "--repeats 1 --size 64x48 -o " + (dir / "b").string();
    EXPECT_EQ(player(bench).code, 0);
    EXPECT_EQ(player(bench).code, 0) << "measurements over older ones";
    const std::string steps =
        "smoothness " + package() + " --step 30 --size 64x48 -o " + (dir / "s").string();
    EXPECT_EQ(player(steps).code, 0);
    EXPECT_EQ(player(steps).code, 0) << "steps over older ones";
}

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
        << "a photo without a camera is not an input";
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

void Contracts::expect_damage_found(std::initializer_list<package::Type> types) {
    PrepareSettings settings;
    settings.vertex_coordinates = true;
    const std::string bytes = undisturbed(settings);
    const auto prepare_again = [&] { return prepare_program("--vertex-coordinates"); };
    copy_package(scene, settings, file);
    const fs::path valid = dir / "valid.vantage", files = dir / "files";
    fs::copy_file(file, valid);
    for (const package::Type type : types) {
        const bool whole = type == package::Type::positions, mask = type == package::Type::masks;
        const bool extracted = whole || mask || type == package::Type::tiles;
        if (mask) {
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
        EXPECT_NE(repaired.out.find("is damaged and is repaired: "), std::string::npos) << repaired.out;
        expect_whole(bytes, "a repaired package");
    }
    damage(package::Type::tiles, 1);
    const Outcome evaluated =
        player("evaluate " + package() + " --photo 0001 --level 0 -o " + (dir / "e").string());
    EXPECT_EQ(evaluated.code, int(Exit::damaged));
    EXPECT_EQ(prepare_again().code, 0);
    fs::resize_file(file, fs::file_size(file) / 2);
    EXPECT_EQ(prepare_again().code, 0) << "a truncated package is still one";
    expect_whole(bytes, "a truncated package");
}

TEST_F(Contracts, DamagedPackagesAreFoundByAllThatReadThem) {
    expect_damage_found({package::Type::tiles, package::Type::masks});
}

TEST_F(ContractsAtLength, DamagedPackagesAreFoundByAllThatReadThem) {
    expect_damage_found({package::Type::tiles, package::Type::masks, package::Type::thumbnail,
                         package::Type::coordinates, package::Type::positions});
}

TEST_F(Contracts, EveryCameraFileIsAnInput) {
    const std::string explicit_text = "prepare --progress none --mesh " + mesh.string() + " --photos " +
                                      images.string() + " -o " + package() + " --cameras ";
    const auto expect_stale = [&](const std::string& words, const std::string& changed) {
        const Outcome o = run(words + " --explain");
        EXPECT_EQ(o.out.find("nothing to do"), std::string::npos) << changed << '\n' << o.out;
    };
    const std::string by_file = explicit_text + (sparse / "cameras.txt").string();
    ASSERT_EQ(run(by_file).code, 0);
    write(sparse / "images.txt", slurp(sparse / "images.txt") + "# a comment\n");
    expect_stale(by_file, "images.txt beside the cameras.txt that was given");

    // Bundler: the same cameras, with the principal point in the middle.
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
    fs::rename(scene / "truth", dir / "truth");  // has cameras too
    for (const char* name : {"cameras.bin", "images.bin"})
        write(sparse / name, std::string(8, '\0'));  // none, but binary cameras are preferred
    const Outcome checked = run("check " + package() + " --against " + scene.string());
    EXPECT_EQ(checked.code, int(Exit::stale));
    EXPECT_NE(checked.out.find("cameras.bin: was added"), std::string::npos) << checked.out;
    EXPECT_EQ(prepare_program().code, int(Exit::input)) << "it reads them";
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
