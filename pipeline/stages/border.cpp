#include "pipeline/stages/border.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "gl/context.h"
#include "gl/object.h"
#include "gl/program.h"
#include "pipeline/stages/wide.h"
#include "scene/error.h"

namespace vantage {
namespace {

struct Named {
    DistanceMethod method;
    const char* name;
};
constexpr Named methods[] = {{DistanceMethod::automatic, "auto"},
                             {DistanceMethod::exact, "exact"},
                             {DistanceMethod::jfa, "jfa"},
                             {DistanceMethod::jfa_plus_1, "jfa+1"},
                             {DistanceMethod::one_plus_jfa, "1+jfa"},
                             {DistanceMethod::jfa_squared, "jfa^2"}};

/// Which pixels of a row, but for its ends, lie on a depth discontinuity, by their 3x3 neighbourhoods.
/// Without branches: what is no number compares false, and a neighbour that is not seen decides alone.
VANTAGE_WIDE void find_in_row(const float* above, const float* here, const float* below, int width,
                              float threshold, std::uint8_t* out) {
    constexpr float unseen = std::numeric_limits<float>::infinity();
    for (int x = 1; x + 1 < width; ++x) {
        const float a = above[x - 1], b = above[x], c = above[x + 1], d = here[x - 1], z = here[x],
                    e = here[x + 1], f = below[x - 1], g = below[x], h = below[x + 1];
        const int seen = (a < unseen) + (b < unseen) + (c < unseen) + (d < unseen) + (e < unseen) +
                         (f < unseen) + (g < unseen) + (h < unseen);
        const int outline = z < unseen ? seen != 8 : seen != 0;
        const float gx = (c + 2 * e + h) - (a + 2 * d + f), gy = (f + 2 * g + h) - (a + 2 * b + c);
        const float least = threshold * 8 * z;
        // A plane is linear in 1/z however steep; a step is not.
        const float inverse = 1 / z,
                    bend_x = std::abs(1 / d + 1 / e - 2 * inverse) * std::max(std::max(d, e), z),
                    bend_y = std::abs(1 / b + 1 / g - 2 * inverse) * std::max(std::max(b, g), z);
        const int step =
            int(gx * gx + gy * gy > least * least) & int(std::max(bend_x, bend_y) > threshold / 4);
        out[x] = std::uint8_t(outline | (step & (z < unseen)));
    }
}

VANTAGE_WIDE void border_row(const float* distance, int width, int edge, float scale, std::uint8_t* out) {
    constexpr float mixed = 1;  // pixels next to a border hold the colours of both sides
    for (int x = 0; x < width; ++x) {
        const float outline = float(std::min(edge, std::min(x, width - 1 - x))) + 0.5f;
        const float code = std::min(distance[x] - mixed, outline) * scale;
        out[x] = std::uint8_t(int(std::min(std::max(code, 0.0f), 255.0f) + 0.5f));
    }
}

std::vector<int> strides(int longest, DistanceMethod variant) {
    std::vector<int> s;
    if (variant == DistanceMethod::one_plus_jfa) s.push_back(1);
    const int top = int(std::bit_ceil(unsigned(std::max(2, longest)))) / 2;
    const int rounds = variant == DistanceMethod::jfa_squared ? 2 : 1;
    for (int r = 0; r < rounds; ++r)
        for (int k = top; k >= 1; k /= 2) s.push_back(k);
    if (variant == DistanceMethod::jfa_plus_1) s.push_back(1);
    return s;
}

}  // namespace

DistanceMethod distance_method(const std::string& wanted) {
    std::string known;
    for (const Named& m : methods) {
        if (wanted == m.name) return m.method;
        known += (known.empty() ? "" : ", ") + std::string(m.name);
    }
    throw Error(Exit::usage, "unknown distance method '" + wanted + "', expected one of " + known);
}

const char* name(DistanceMethod method) { return methods[int(method)].name; }

std::vector<std::uint8_t> find_borders(const DepthMap& d, float threshold) {
    std::vector<std::uint8_t> borders(d.z.size(), 0);
    for (int y = 1; y + 1 < d.height; ++y) {
        const float* here = d.z.data() + std::size_t(y) * std::size_t(d.width);
        find_in_row(here - d.width, here, here + d.width, d.width, threshold,
                    borders.data() + std::size_t(y) * std::size_t(d.width));
    }
    for (std::size_t i = 0; i < d.valid.size(); ++i)
        if (d.valid[i] == 0) borders[i] = 1;
    return borders;
}

std::vector<float> exact_distance(const std::vector<std::uint8_t>& borders, int width, int height) {
    std::vector<float> distance(borders.size(), std::numeric_limits<float>::infinity());
    if (std::find(borders.begin(), borders.end(), 1) == borders.end()) return distance;
    cv::Mat away(height, width, CV_8UC1);
    for (std::size_t i = 0; i < borders.size(); ++i) away.data[i] = borders[i] ? 0 : 255;
    cv::Mat out(height, width, CV_32FC1, distance.data());
    cv::distanceTransform(away, out, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
    return distance;
}

gl::Program jump_flood_program() {
    return gl::make_program("jump flood", {{GL_COMPUTE_SHADER, "jump_flood.comp"}});
}

std::vector<float> flood_distance(const gl::Program& jump_flood, const std::vector<std::uint8_t>& borders,
                                  int width, int height, DistanceMethod variant) {
    std::vector<std::int16_t> seeds(borders.size() * 2, -1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x); borders[i]) {
                seeds[2 * i] = std::int16_t(x);
                seeds[2 * i + 1] = std::int16_t(y);
            }
    gl::Texture known = gl::make_texture_2d("jump flood", GL_RG16I, width, height);
    gl::Texture improved = gl::make_texture_2d("jump flood, next", GL_RG16I, width, height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTextureSubImage2D(known.id(), 0, 0, 0, width, height, GL_RG_INTEGER, GL_SHORT, seeds.data());
    glUseProgram(jump_flood.id());
    for (const int stride : strides(std::max(width, height), variant)) {
        glBindImageTexture(0, known.id(), 0, GL_FALSE, 0, GL_READ_ONLY, GL_RG16I);
        glBindImageTexture(1, improved.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG16I);
        glUniform1i(0, stride);
        glDispatchCompute(GLuint(width + 15) / 16, GLuint(height + 15) / 16, 1);
        glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
        std::swap(known, improved);
    }
    glGetTextureImage(known.id(), 0, GL_RG_INTEGER, GL_SHORT, GLsizei(seeds.size() * 2), seeds.data());
    gl::check("jump flooding");
    std::vector<float> distance(borders.size(), std::numeric_limits<float>::infinity());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
            if (seeds[2 * i] >= 0)
                distance[i] = std::hypot(float(seeds[2 * i] - x), float(seeds[2 * i + 1] - y));
        }
    return distance;
}

std::vector<std::uint8_t> border_mask(const std::vector<float>& distance, int width, int height,
                                      float full_width) {
    std::vector<std::uint8_t> mask(distance.size());
    const float scale = 255 / std::max(full_width, 1e-3f);
    for (int y = 0; y < height; ++y) {
        const std::size_t row = std::size_t(y) * std::size_t(width);
        border_row(&distance[row], width, std::min(y, height - 1 - y), scale, &mask[row]);
    }
    return mask;
}

}  // namespace vantage
