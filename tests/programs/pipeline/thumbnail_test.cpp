// Tests `vantage thumbnail` by calling it as file managers do: it writes a picture of the photo that the
// player shows first, or prints one line and returns an exit code.
#include <cmath>
#include <fstream>

#include "base/text/error.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/photos/photos.h"
#include "scene/package/contents/first_photo.h"
#include "scene/package/package_reader.h"
#include "tests/one_line.h"
#include "tests/programs/overnight.h"

using namespace vantage;

namespace {

class Thumbnail : public Overnight {
  protected:
    const fs::path png = dir / "thumbnail.png";

    Outcome thumbnail(const std::string& options = "", const std::string& of = "") const {
        return run("thumbnail " + (of.empty() ? file.string() : of) + " -o " + png.string() + " " + options);
    }
    void expect_failure(const Outcome& o, Exit code, const std::string& what) const {
        EXPECT_EQ(o.code, int(code)) << what << ": " << o.err;
        EXPECT_TRUE(one_line(o.err)) << what << ": " << o.err;
        EXPECT_EQ(o.out, "") << what;
        EXPECT_FALSE(fs::exists(png)) << what;
    }
};

/// The mean absolute difference in gray levels between two pictures of any size, each of which is averaged
/// over 8x8 cells.
double difference(const RgbaImage& a, const RgbaImage& b) {
    constexpr int cells = 8;
    const auto mean = [&](const RgbaImage& image, int x, int y, int c) {
        double sum = 0;
        int count = 0;
        for (int j = y * image.height / cells; j < (y + 1) * image.height / cells; ++j)
            for (int i = x * image.width / cells; i < (x + 1) * image.width / cells; ++i, ++count)
                sum += image.rgba[4 * std::size_t(j * image.width + i) + std::size_t(c)];
        return sum / count;
    };
    double sum = 0;
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x)
            for (int c = 0; c < 3; ++c) sum += std::abs(mean(a, x, y, c) - mean(b, x, y, c));
    return sum / (3 * cells * cells);
}

}  // namespace

TEST_F(Thumbnail, ShowsThePhotoAtWhichThePlayerOpens) {
    copy_package(scene, {}, file);
    const Outcome o = thumbnail("--size 64");
    ASSERT_EQ(o.code, 0) << o.err;
    EXPECT_EQ(o.err, "");
    const RgbaImage picture = image_files().read(png);
    EXPECT_EQ(std::max(picture.width, picture.height), 64);
    const std::uint32_t first = first_photo(PackageReader(file));
    const std::vector<fs::path> all = photos();
    ASSERT_EQ(all.size(), 6u);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const RgbaImage photo = read_photo(all[i], read_photo_header(all[i]).size);
        EXPECT_EQ(difference(picture, photo) < 2, i == first) << all[i] << ": " << difference(picture, photo);
    }
}

TEST_F(Thumbnail, IsNotOfAPhotoThatIsHeldOut) {
    ASSERT_EQ(prepare_program("--hold-out 0003").code, 0);
    ASSERT_EQ(thumbnail().code, 0);
    const std::uint32_t first = first_photo(PackageReader(file));
    EXPECT_NE(first, 3u);
    const fs::path shown = photos().at(first);
    EXPECT_LT(difference(image_files().read(png), read_photo(shown, read_photo_header(shown).size)), 2);
}

TEST_F(Thumbnail, OfADamagedFileIsOneLineAndAnExitCode) {
    copy_package(scene, {}, file);
    const std::string valid = slurp(file);
    std::uint64_t at = 0;
    {
        const PackageReader package(file);
        const auto* chunk = package.find(package::Type::thumbnail, 3);
        at = chunk->offset + chunk->head_length + 50;
    }
    const auto write = [&](const std::string& bytes) { std::ofstream(file, std::ios::binary) << bytes; };
    std::string rotten = valid;
    rotten[at] = char(~rotten[at]);
    write(rotten);
    expect_failure(thumbnail(), Exit::damaged, "a thumbnail with a wrong byte");
    write(valid.substr(0, valid.size() / 2));
    expect_failure(thumbnail(), Exit::damaged, "half of a package");
    write("VANTAGE\n");
    expect_failure(thumbnail(), Exit::damaged, "eight bytes");
    write("");
    expect_failure(thumbnail(), Exit::damaged, "an empty file");
    write(valid);
    expect_failure(thumbnail("", (dir / "none.vantage").string()), Exit::input, "no file");
    EXPECT_EQ(thumbnail("--size 0").code, int(Exit::usage));
    EXPECT_EQ(thumbnail().code, 0);
}

TEST_F(Thumbnail, ReplacesPicturesOnly) {
    copy_package(scene, {}, file);
    std::ofstream(png) << "mine";
    EXPECT_EQ(thumbnail().code, int(Exit::usage));
    EXPECT_EQ(slurp(png), "mine");
    EXPECT_EQ(run("thumbnail " + file.string() + " -o " + file.string() + " --force").code, int(Exit::usage));
    EXPECT_EQ(thumbnail("--force").code, 0);
    EXPECT_EQ(thumbnail().code, 0);  // a PNG
}
