// Photos of every supported kind are decoded to RGBA.
#include "pipeline/formats/images/photos.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <fstream>

#include "pipeline/formats/images/image_files.h"
#include "pipeline/input/file_identity.h"
#include "scene/error.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

class Photos : public TemporaryFolder {
  protected:
    /// Writes `width` x `height` copies of `pixel`, except that the first pixel is zero.
    template <class T>
    fs::path write(const char* name, int width, int height, std::initializer_list<T> pixel,
                   int orientation = 1) {
        OIIO::ImageSpec spec(width, height, int(pixel.size()), OIIO::BaseTypeFromC<T>::value);
        spec.attribute("Orientation", orientation);
        spec.attribute("oiio:UnassociatedAlpha", 1);
        std::vector<T> pixels;
        for (int i = 0; i < width * height; ++i) pixels.insert(pixels.end(), pixel.begin(), pixel.end());
        std::fill_n(pixels.begin(), pixel.size(), T(0));
        const fs::path file = dir / name;
        const auto out = OIIO::ImageOutput::create(file.string());
        EXPECT_TRUE(out && out->open(file.string(), spec) &&
                    out->write_image(OIIO::BaseTypeFromC<T>::value, pixels.data()) && out->close());
        return file;
    }
};

using Pixel = std::array<int, 4>;

Pixel pixel(const RgbaImage& p, int x, int y) {
    const std::uint8_t* at = p.rgba.data() + (std::size_t(y) * std::size_t(p.width) + std::size_t(x)) * 4;
    return {at[0], at[1], at[2], at[3]};
}

}  // namespace

TEST_F(Photos, GraySixteenBitsAndAlpha) {
    using u8 = std::uint8_t;
    using u16 = std::uint16_t;
    const PhotoSize size{3, 2};
    EXPECT_EQ(pixel(read_photo(write<u8>("g.png", 3, 2, {100}), size), 2, 1), (Pixel{100, 100, 100, 255}));
    EXPECT_EQ(pixel(read_photo(write<u16>("s.png", 3, 2, {51400, 25700, 257}), size), 2, 1),
              (Pixel{200, 100, 1, 255}));
    EXPECT_EQ(pixel(read_photo(write<u8>("a.png", 3, 2, {200, 100, 50, 128}), size), 2, 1),
              (Pixel{200, 100, 50, 128}));
    EXPECT_EQ(pixel(read_photo(write<u8>("ga.png", 3, 2, {90, 60}), size), 2, 1), (Pixel{90, 90, 90, 60}));
    EXPECT_EQ(pixel(read_photo(write<u8>("t.tif", 3, 2, {9, 8, 7}), size), 2, 1), (Pixel{9, 8, 7, 255}));
}

TEST_F(Photos, AdobeCmykIsInverted) {
    // Adobe stores it inverted: 255 is no ink.
    const std::vector<unsigned char> cmyk{255, 128, 0, 255, 255, 128, 0, 255};
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    const tjhandle encoder = tjInitCompress();
    ASSERT_EQ(tjCompress2(encoder, cmyk.data(), 2, 0, 1, TJPF_CMYK, &bytes, &size, TJSAMP_444, 100, 0), 0);
    std::ofstream(dir / "c.jpg", std::ios::binary)
        .write(reinterpret_cast<char*>(bytes), std::streamsize(size));
    tjFree(bytes);
    tjDestroy(encoder);
    const Pixel p = pixel(read_photo(dir / "c.jpg", {2, 1}), 1, 0);
    EXPECT_NEAR(p[0], 255, 2);
    EXPECT_NEAR(p[1], 128, 2);
    EXPECT_NEAR(p[2], 0, 2);
    EXPECT_EQ(p[3], 255);
}

TEST_F(Photos, AreRotatedOnlyIfTheCameraExpectsIt) {
    // Where EXIF orientations 5 to 8 put the first stored pixel.
    const std::pair<int, std::array<int, 2>> where[] = {{5, {0, 0}}, {6, {1, 0}}, {7, {1, 2}}, {8, {0, 2}}};
    for (const auto& [orientation, at] : where) {
        const fs::path file = write<std::uint8_t>("o.tif", 3, 2, {200, 200, 200}, orientation);
        EXPECT_EQ(pixel(read_photo(file, {3, 2}), 0, 0)[0], 0) << "as stored";
        const RgbaImage turned = read_photo(file, {2, 3});
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 2; ++x)
                EXPECT_EQ(pixel(turned, x, y)[0], x == at[0] && y == at[1] ? 0 : 200)
                    << orientation << " " << x << y;
    }
}

TEST_F(Photos, WrongSizeTruncatedOrBrokenAreRejected) {
    const fs::path png = write<std::uint8_t>("p.png", 40, 30, {1, 2, 3});
    EXPECT_THROW(read_photo(png, {41, 30}), Error);
    const fs::path jpeg = write<std::uint8_t>("j.jpg", 40, 30, {100, 150, 200});
    EXPECT_NO_THROW(read_photo(jpeg, {40, 30}));
    for (const fs::path& file : {png, jpeg}) {
        fs::resize_file(file, fs::file_size(file) / 2);
        EXPECT_THROW(read_photo(file, {40, 30}), Error) << file;
    }
    std::ofstream(dir / "x.jpg") << "no photo";
    EXPECT_THROW(read_photo(dir / "x.jpg", {1, 1}), Error);
    EXPECT_THROW(read_photo_header(dir / "x.jpg"), Error);
    EXPECT_THROW(read_photo(dir / "none.jpg", {1, 1}), Error);
}
