// Photos whose EXIF orientation leaves open which way up they are.
#include "pipeline/align/upside_down.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>

#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/photos/photos.h"
#include "tests/datasets.h"
#include "tests/temporary_folder.h"

namespace vantage {
namespace {

class UpsideDown : public TemporaryFolder {
  protected:
    /// A photo whose pixels are turned by 180 degrees.
    void turn(PhotoInput& photo) const {
        RgbaImage image = read_photo(photo.file, photo.decoded);
        std::vector<std::uint32_t> texels(image.rgba.size() / 4);
        std::memcpy(texels.data(), image.rgba.data(), image.rgba.size());
        std::ranges::reverse(texels);
        photo.file = dir / (photo.name + ".png");
        image_files().write(photo.file, image.width, image.height, 4, Sample::u8,
                            std::as_bytes(std::span(texels)));
    }
};

TEST_F(UpsideDown, NeighborsTell) {
    VANTAGE_DATASET(scan, "sceaux-small");
    const std::vector<PhotoInput> right = read_scene(discover(scan)).photos;
    EXPECT_TRUE(upside_down_photos(right, {}).empty()) << "none is in question";
    std::vector<PhotoInput> photos = right;
    for (PhotoInput& p : photos) p.open_turn = 3;
    EXPECT_TRUE(upside_down_photos(photos, {}).empty()) << "all are in question, and right";
    turn(photos[2]);
    EXPECT_EQ(upside_down_photos(photos, {}), std::vector<std::uint32_t>{2});
    for (std::size_t i = 0; i < photos.size(); ++i)
        if (i != 2) turn(photos[i]);
    std::vector<std::uint32_t> all(photos.size());
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_EQ(upside_down_photos(photos, {}), all);
}

}  // namespace
}  // namespace vantage
