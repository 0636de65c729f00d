// Photos with an ambiguous EXIF orientation.
#include "pipeline/align/open_turns.h"

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
    /// Rotates a photo's pixels by 180 degrees.
    void turn(PhotoInput& photo) const { store(photo, 3); }

    /// Stores a photo's pixels for this EXIF orientation, so that it is displayed as before. The camera's
    /// principal point keeps its offset from the center of the photo.
    void store(PhotoInput& photo, int orientation) const {
        const RgbaImage from = read_photo(photo.file, photo.decoded);
        const bool swaps = orientation >= 5;
        const int w = swaps ? from.height : from.width, h = swaps ? from.width : from.height;
        std::vector<std::uint32_t> texels(from.rgba.size() / 4), to(texels.size());
        std::memcpy(texels.data(), from.rgba.data(), from.rgba.size());
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                const auto [column, row] = displayed(x, y, w, h, orientation);
                to[std::size_t(y * w + x)] = texels[std::size_t(row * from.width + column)];
            }
        photo.file = dir / (photo.name + ".png");
        image_files().write(photo.file, w, h, 4, Sample::u8, std::as_bytes(std::span(to)));
        if (swaps) take_as_displayed(photo);
    }

  private:
    /// The position at which a stored pixel is displayed (Exif 2.3, 4.6.4).
    static std::pair<int, int> displayed(int x, int y, int w, int h, int orientation) {
        const int right = w - 1 - x, below = h - 1 - y;
        const std::pair<int, int> at[] = {{x, y}, {right, y}, {right, below}, {x, below},
                                          {y, x}, {below, x}, {below, right}, {y, right}};
        return at[orientation - 1];
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
    expect_found({});  // no photo is ambiguous
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

/// A photo with EXIF orientation 2 or 4. Other programs have fitted its camera to the photo as displayed.
TEST_F(UpsideDown, AMirroredPhotoIsFound) {
    VANTAGE_DATASET(scan, "sceaux-small");
    for (const int orientation : {2, 4}) {
        std::vector<PhotoInput> photos = read_scene(discover(scan)).photos;
        photos[2].open_turn = orientation;
        store(photos[2], orientation);
        EXPECT_EQ(find_open_turns(photos, {}).found, Indices{2}) << orientation;
    }
}

/// The camera does not state a size, so it may belong to the photo as stored or as displayed.
TEST_F(UpsideDown, APhotoTurnedBy90DegreesIsFoundAndTurned) {
    VANTAGE_DATASET(scan, "sceaux-small");
    for (const int orientation : {5, 6, 7, 8}) {
        std::vector<PhotoInput> photos = read_scene(discover(scan)).photos;
        PhotoInput& p = photos[2];
        const Intrinsics right = p.camera.intrinsics;
        store(p, orientation);
        p.open_turn = orientation;
        EXPECT_EQ(find_open_turns(photos, {}).found, Indices{2}) << orientation;
        take_as_displayed(p);
        const Intrinsics& k = p.camera.intrinsics;
        EXPECT_EQ(p.decoded.width, right.width);
        EXPECT_EQ(Eigen::Vector4d(k.width, k.height, k.cx, k.cy),
                  Eigen::Vector4d(right.width, right.height, right.cx, right.cy));
    }
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
