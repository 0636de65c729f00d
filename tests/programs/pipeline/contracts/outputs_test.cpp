// Tests the guarantees of docs/contracts.md about output files: which are replaced and which are never
// touched.
#include <sys/stat.h>

#include "base/text/error.h"
#include "scene/package/package_reader.h"
#include "tests/made_scenes.h"
#include "tests/one_line.h"
#include "tests/programs/patterns.h"
#include "tests/programs/pipeline/contracts/contracts.h"

using namespace vantage;

TEST_F(ContractsAtLength, PhotosOfEqualStemKeepTheirOwnFiles) {
    share_a_stem();
    ASSERT_EQ(prepare_program().code, 0);
    const fs::path files = dir / "files", pictures = dir / "pictures", evaluation = dir / "evaluation";
    ASSERT_EQ(run("extract " + package() + " -o " + files.string()).code, 0);
    const Outcome shown =
        player("render " + package() + " --photo 0000.jpg,0000.png --scale 0.1 -o " + pictures.string());
    ASSERT_EQ(shown.code, 0) << shown.err;
    const Outcome evaluated = player("evaluate " + package() + " --level 3 -o " + evaluation.string() +
                                     " --photo 0000.jpg,0000.png");
    ASSERT_EQ(evaluated.code, 0) << evaluated.err;
    for (const std::string photo : {"0000.jpg", "0000.png"})
        for (const fs::path& made : {files / "photos" / (photo + photo.substr(4)),
                                     files / "weights" / (photo + ".png"), files / "depth" / (photo + ".exr"),
                                     pictures / (photo + ".png"), evaluation / (photo + "-photo.png")})
            EXPECT_TRUE(fs::exists(made)) << made;
    EXPECT_NE(slurp(files / "photos" / "0000.jpg.jpg"), slurp(files / "photos" / "0000.png.png"));
    EXPECT_TRUE(fs::exists(files / "photos" / "0002.jpg")) << "names that are unique should stay short";
}

TEST_F(Contracts, AmbiguousPhotoNamesAreRefused) {
    share_a_stem();
    const Outcome held = prepare_program("--hold-out 0000");
    EXPECT_EQ(held.code, int(Exit::usage));
    ASSERT_EQ(prepare_program("--hold-out 0000.png").code, 0);
    const Outcome extracted = run("extract " + package() + " --photo 0000 -o " + (dir / "x").string());
    const Outcome shown = player("render " + package() + " --photo 0000 -o " + (dir / "x.png").string());
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
        EXPECT_EQ(run(prepare_to(pipe) + force).code, int(Exit::usage))
            << "a device would be replaced by a file";
    EXPECT_TRUE(fs::is_fifo(pipe));

    fs::remove(images / "0001.mask.png");
    const std::string trace = "--trace " + (dir / "trace.json").string() + " ";
    EXPECT_EQ(run(prepare_to(text) + trace + "--force").code, 0);
    EXPECT_EQ(run(prepare_to(text) + trace + "--thumbnail-size 128").code, 0)
        << "the package, the report and the trace should be written again";
    const PackageReader replaced(text);
    EXPECT_EQ(replaced.photos()[0].thumbnail_width, 128u);
    write(file, "");
    EXPECT_EQ(run(prepare_to(file) + "--no-report").code, 0) << "an empty file may be replaced";
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
    // The input mesh and a mask are recognized by their content, even with --force.
    for (const std::string force : {"", " --force"})
        expect_refused("extract " + package() + " -o " + scene.string() + force, mesh);
    fs::remove_all(scene / "truth");
    expect_refused("synth " VANTAGE_SOURCE_DIR "/data/tiny.toml -o " + scene.string(), images / "0000.jpg");
    fs::create_directories(page);
    write(page / "index.html", "<html>mine</html>");
    expect_refused("diff " + package() + " " + package() + " -o " + page.string(), page / "index.html");
}

TEST_F(ContractsAtLength, PlayerReplacesPicturesButNoInputs) {
    share_a_stem();  // 0000.png is a photo
    ASSERT_EQ(prepare_program("--hold-out 0002.jpg").code, 0);
    const fs::path text = dir / "notes.png", page = dir / "page", held = dir / "held.png",
                   copies = dir / "copies";
    write(text, "mine");
    fs::create_directories(copies);
    fs::copy_file(images / "0000.png", copies / "0004.png");
    const std::string small = "render " + package() + " --photo 0003 --scale 0.1 -o ";
    for (const std::string force : {"", " --force"}) {
        expect_refused(small + (images / "0000.png").string() + force, images / "0000.png", VANTAGE_PLAYER);
        expect_refused("render " + package() + " --photo 0003,0004 -o " + copies.string() + force,
                       copies / "0004.png", VANTAGE_PLAYER);
        fs::copy_file(images / "0002.jpg", held, fs::copy_options::overwrite_existing);
        expect_refused(small + held.string() + force, held, VANTAGE_PLAYER);
    }
    expect_refused(small + text.string(), text, VANTAGE_PLAYER);
    EXPECT_EQ(player(small + text.string() + " --force").code, 0);
    EXPECT_EQ(player(small + text.string()).code, 0) << "a picture should replace an older one";
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
    EXPECT_EQ(player(again).code, 0) << "an evaluation should replace an older one";
    fs::remove(dir / "e" / "index.html");
    for (const char* last : {"photos.csv", "regions.csv", "regions.ply"}) fs::remove(dir / "e" / last);
    EXPECT_EQ(player(again).code, 0) << "an evaluation should replace an interrupted one";
    fs::copy_file(images / "0000.png", dir / "e" / "0003-photo.png", fs::copy_options::overwrite_existing);
    expect_refused(again, dir / "e" / "0003-photo.png", VANTAGE_PLAYER);
}

TEST_F(ContractsAtLength, MeasurementsReplaceOlderOnes) {
    copy_package(scene, {}, file);
    const std::string bench = "bench " + package() + " --paths still --modes resident --path-frames 2 " +
                              "--repeats 1 --size 64x48 -o " + (dir / "b").string();
    EXPECT_EQ(player(bench).code, 0);
    EXPECT_EQ(player(bench).code, 0) << "measurements should replace older ones";
    const std::string steps =
        "smoothness " + package() + " --step 30 --size 64x48 -o " + (dir / "s").string();
    EXPECT_EQ(player(steps).code, 0);
    EXPECT_EQ(player(steps).code, 0) << "steps should replace older ones";
}
