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

using Indices = std::vector<std::uint32_t>;

TEST_F(UpsideDown, NeighborsTell) {
    VANTAGE_DATASET(scan, "sceaux-small");
    std::vector<PhotoInput> photos = read_scene(discover(scan)).photos;
    const auto expect_found = [&](const Indices& found) {
        const OpenTurns turns = find_open_turns(photos, {});
        EXPECT_EQ(turns.found, found);
        EXPECT_EQ(turns.unknown, Indices());
    };
    expect_found({});  // none is in question
    for (PhotoInput& p : photos) p.open_turn = 3;
    expect_found({});
    turn(photos[2]);
    expect_found({2});
    for (std::size_t i = 0; i < photos.size(); ++i)
        if (i != 2) turn(photos[i]);
    Indices all(photos.size());
    std::iota(all.begin(), all.end(), 0u);
    expect_found(all);
}

TEST_F(UpsideDown, APhotoAloneTellsNothing) {
    VANTAGE_DATASET(scan, "sceaux-small");
    std::vector<PhotoInput> photos = read_scene(discover(scan)).photos;
    photos.resize(1);
    photos[0].open_turn = 6;
    const OpenTurns turns = find_open_turns(photos, {});
    EXPECT_EQ(turns.found, Indices());
    EXPECT_EQ(turns.unknown, Indices{0});
}

TEST_F(UpsideDown, OfManyPhotosTheLastIsFound) {
    VANTAGE_DATASET(scan, "head");
    std::vector<PhotoInput> photos = read_scene(discover(scan)).photos;
    for (std::size_t i = photos.size() - 16; i < photos.size(); ++i) photos[i].open_turn = 3;
    const auto last = std::uint32_t(photos.size() - 1);
    turn(photos[last]);
    EXPECT_EQ(find_open_turns(photos, {}).found, Indices{last});
}

}  // namespace
}  // namespace vantage
