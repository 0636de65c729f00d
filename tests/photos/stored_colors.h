#pragma once
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <random>

#include "pipeline/photos/color_profile.h"
#include "pipeline/photos/photos.h"
#include "tests/image_file.h"
#include "tests/temporary_folder.h"

namespace vantage::stored_colors {

namespace fs = std::filesystem;

constexpr int side = 64;
constexpr PhotoSize size{side, side};

template <class T>
constexpr double top = double(std::numeric_limits<T>::max());

/// The values of side * side colors that cover the whole color cube with `channels` dimensions, including its
/// corners.
template <class T>
std::vector<T> colors(int channels) {
    std::vector<T> out;
    std::mt19937 random(3);
    for (int i = 0; i < side * side; ++i)
        for (int c = 0; c < channels; ++c)
            out.push_back(i < 2048 ? T(random()) : T((i >> (4 * c) & 15) * top<T> / 15));
    return out;
}

class ColorProfiles : public TemporaryFolder {
  protected:
    /// Writes a picture with rows of `side` pixels.
    template <class T>
    fs::path write(const char* name, int channels, const std::vector<T>& pixels, const std::string& icc = {},
                   int orientation = 1) {
        OIIO::ImageSpec spec(side, int(pixels.size()) / side / channels, channels,
                             OIIO::BaseTypeFromC<T>::value);
        spec.attribute("oiio:UnassociatedAlpha", 1);
        spec.attribute("Orientation", orientation);
        spec.attribute("Compression", std::string(name).ends_with(".jpg") ? "jpeg:100" : "zip");
        if (!icc.empty())
            spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, int(icc.size())), icc.data());
        const fs::path file = dir / name;
        EXPECT_TRUE(write_image_file(file, spec, OIIO::BaseTypeFromC<T>::value, pixels.data())) << file;
        return file;
    }
    fs::path put(const char* name, const std::string& bytes) {
        std::ofstream(dir / name, std::ios::binary) << bytes;
        return dir / name;
    }
};

inline ProfileUse use_of(const fs::path& file) { return read_photo_header(file).profile; }

}  // namespace vantage::stored_colors
