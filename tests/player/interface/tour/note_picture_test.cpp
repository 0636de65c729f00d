#include "player/interface/tour/note_picture.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/text/error.h"
#include "scene/codec/jpeg_pixels.h"
#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

class NotePictures : public TemporaryFolder {
  protected:
    std::filesystem::path written(const std::string& bytes) const {
        std::ofstream(dir / "picture", std::ios::binary) << bytes;
        return dir / "picture";
    }
    void expect_refused(const std::string& bytes, const char* why) const {
        try {
            read_note_picture(written(bytes));
            ADD_FAILURE() << why << " was accepted";
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::input);
            EXPECT_EQ(std::string(e.what()).rfind((dir / "picture").string(), 0), 0u) << e.what();
        }
    }
};

}  // namespace

TEST_F(NotePictures, AreReadFromPngAndJpeg) {
    Picture p{40, 20, {}, {}};
    for (int i = 0; i < 800; ++i) p.rgba.insert(p.rgba.end(), {200, 100, 50, 255});
    write_png(dir / "a.png", p);
    EXPECT_EQ(read_note_picture(dir / "a.png").rgba, p.rgba);
    const auto jpeg = codec::encode_jpeg(std::as_bytes(std::span(p.rgba)), 40, 20, 95);
    const std::string bytes(reinterpret_cast<const char*>(jpeg.data()), jpeg.size());
    const Picture decoded = read_note_picture(written(bytes));
    ASSERT_EQ(decoded.width, 40);
    ASSERT_EQ(decoded.height, 20);
    EXPECT_NEAR(decoded.rgba[0], 200, 3);
    EXPECT_NEAR(decoded.rgba[2], 50, 3);
    for (std::size_t cut = 0; cut < bytes.size(); cut += 7)
        if (cut < 100) expect_refused(bytes.substr(0, cut), "a JPEG whose header is incomplete");
}

TEST_F(NotePictures, APasserBysFileDoesNoHarm) {
    const std::string png = "\x89PNG\r\n\x1a\n", head("\0\0\0\x0dIHDR", 8);
    expect_refused(png + head + std::string("\0\0\xff\xff\0\0\xff\xff\x08\x06\0\0\0", 13), "4 gigapixels");
    expect_refused(png + head + std::string("\x7f\0\0\0\x7f\0\0\0\x08\x06\0\0\0", 13), "2^62 pixels");
    expect_refused(png + head + std::string("\0\0\0\x10\0\0\0\x10\x08\x06\0\0\0", 13), "a PNG that ends");
    expect_refused(std::string("\xff\xd8\xff\xc0\0\x11\x08\xff\xff\xff\xff\x03", 12), "a large JPEG");
    expect_refused(std::string("\xff\xd8\xff\xe0\0\0\xff\xe0\0\0", 10), "segments without length");
    expect_refused("", "an empty file");
    expect_refused("GIF89a", "a GIF");
    EXPECT_THROW(read_note_picture(dir / "missing.png"), Error);
    EXPECT_THROW(read_note_picture(dir), Error);
}

TEST(ReducedPicture, IsTheMeanOfWholeBlocks) {
    Picture p{4, 2, {}, {}};
    for (int i = 0; i < 8; ++i)
        for (int c = 0; c < 4; ++c) p.rgba.push_back(std::uint8_t(10 * i));
    const Picture half = reduced_picture(p, 2);
    ASSERT_EQ(half.width, 2);
    ASSERT_EQ(half.height, 1);
    EXPECT_EQ(half.rgba[0], (0 + 10 + 40 + 50) / 4);
    EXPECT_EQ(half.rgba[4], (20 + 30 + 60 + 70) / 4);
    EXPECT_EQ(reduced_picture(p, 4).rgba, p.rgba);
}
