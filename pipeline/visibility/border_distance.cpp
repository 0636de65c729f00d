#include "pipeline/visibility/border_distance.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "base/gl/context.h"
#include "base/gl/object.h"
#include "base/values/grid.h"
#include "shaders/contract.h"

namespace vantage {
namespace {

/// The steps of jump flooding, in pixels, for a map whose longer side is `long_side`.
std::vector<int> strides(int long_side) {
    std::vector<int> s;
    const int first = int(std::bit_ceil(unsigned(std::max(2, long_side)))) / 2;
    for (int round = 0; round < 2; ++round)
        for (int k = first; k >= 1; k /= 2) s.push_back(k);
    return s;
}

/// A texel of the flooded textures: the nearest border pixel known so far.
struct Seed {
    std::int16_t x = -1, y = -1;
};
static_assert(sizeof(Seed) == 4, "GL_RG16I");

}  // namespace

std::vector<float> exact_distance(const std::vector<std::uint8_t>& borders, int width, int height) {
    std::vector<float> distance(borders.size(), std::numeric_limits<float>::infinity());
    if (std::find(borders.begin(), borders.end(), 1) == borders.end()) return distance;
    cv::Mat interior(height, width, CV_8UC1);
    for (std::size_t i = 0; i < borders.size(); ++i) interior.data[i] = borders[i] ? 0 : 255;
    cv::Mat out(height, width, CV_32FC1, distance.data());
    cv::distanceTransform(interior, out, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
    return distance;
}

gl::Program jump_flood_program() {
    return gl::make_program("jump flood", {{GL_COMPUTE_SHADER, "jump_flood.comp"}});
}

std::vector<float> flood_distance(const gl::Program& jump_flood, const std::vector<std::uint8_t>& borders,
                                  int width, int height) {
    std::vector<Seed> seeds(borders.size());
    const Grid<Seed> seed{seeds.data(), width, height};
    const Grid<const std::uint8_t> border{borders.data(), width, height};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (border(x, y)) seed(x, y) = {std::int16_t(x), std::int16_t(y)};
    gl::Texture current = gl::make_texture_2d("jump flood", GL_RG16I, width, height);
    gl::Texture next = gl::make_texture_2d("jump flood, next", GL_RG16I, width, height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTextureSubImage2D(current.id(), 0, 0, 0, width, height, GL_RG_INTEGER, GL_SHORT, seeds.data());
    const auto groups = [](int texels) {
        return GLuint(texels + shader::flood_group_texels - 1) / GLuint(shader::flood_group_texels);
    };
    glUseProgram(jump_flood.id());
    for (const int stride : strides(std::max(width, height))) {
        glBindImageTexture(shader::known_seeds_image, current.id(), 0, GL_FALSE, 0, GL_READ_ONLY, GL_RG16I);
        glBindImageTexture(shader::improved_seeds_image, next.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG16I);
        glUniform1i(shader::stride_uniform, stride);
        glDispatchCompute(groups(width), groups(height), 1);
        glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
        std::swap(current, next);
    }
    glGetTextureImage(current.id(), 0, GL_RG_INTEGER, GL_SHORT, GLsizei(seeds.size() * sizeof(Seed)),
                      seeds.data());
    gl::check("jump flooding");
    std::vector<float> distance(borders.size(), std::numeric_limits<float>::infinity());
    const Grid<float> out{distance.data(), width, height};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (const Seed s = seed(x, y); s.x >= 0) out(x, y) = std::hypot(float(s.x - x), float(s.y - y));
    return distance;
}

}  // namespace vantage
