// Measures a lower bound on the time of a frame with several photos: draws a package's model once per photo,
// each time with one blended texture. Prints the median frame time over 30 frames, in milliseconds.
#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "base/gl/context.h"
#include "base/gl/object.h"
#include "player/view/navigation.h"
#include "scene/package/package_reader.h"

using namespace vantage;

namespace {

constexpr int width = 1280, height = 720, texels = 2048, frames = 30;

GLuint compiled(GLenum kind, const char* source) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    return shader;
}

GLuint linked() {
    const GLuint program = glCreateProgram();
    glAttachShader(program, compiled(GL_VERTEX_SHADER, R"(#version 450
layout(location = 0) in vec3 position;
layout(location = 0) uniform mat4 clip;
out vec4 at;
void main() { gl_Position = at = clip * vec4(position, 1); })"));
    glAttachShader(program, compiled(GL_FRAGMENT_SHADER, R"(#version 450
in vec4 at;
layout(binding = 0) uniform sampler2D photo;
out vec4 color;
void main() { color = vec4(texture(photo, at.xy / at.w * 0.5 + 0.5).rgb, 0.5); })"));
    glLinkProgram(program);
    return program;
}

double median_ms(const PackageReader& package, int draws) {
    const auto positions = package.records<Eigen::Vector3f>(package::Type::positions);
    const auto indices = package.records<std::uint32_t>(package::Type::indices);
    const gl::Buffer vertices = gl::make_buffer("positions", positions.size_bytes(), positions.data());
    const gl::Buffer triangles = gl::make_buffer("indices", indices.size_bytes(), indices.data());
    const gl::Texture photo = gl::make_texture_2d("photo", GL_SRGB8_ALPHA8, texels, texels);
    const gl::Texture color = gl::make_texture_2d("color", GL_RGBA8, width, height),
                      depth = gl::make_texture_2d("depth", GL_DEPTH_COMPONENT32F, width, height);
    const auto target = gl::make_framebuffer("frame", std::array{color.id()}, depth.id());
    GLuint array = 0;
    glCreateVertexArrays(1, &array);
    glVertexArrayVertexBuffer(array, 0, vertices.id(), 0, 12);
    glVertexArrayElementBuffer(array, triangles.id());
    glEnableVertexArrayAttrib(array, 0);
    glVertexArrayAttribFormat(array, 0, 3, GL_FLOAT, GL_FALSE, 0);
    glBindVertexArray(array);
    const View view = view_of(first_view(package, 0), width, height, {0, 0, width, height});
    const double far =
        (Eigen::Vector3d(package.scene().bounds_max) - Eigen::Vector3d(package.scene().bounds_min)).norm();
    const double away = (view.cam_from_origin.center()).norm();
    const Eigen::Matrix4f clip =
        clip_from_origin(view, {std::max(away - far, 1e-3 * far), away + far}).cast<float>();
    glUseProgram(linked());
    glUniformMatrix4fv(0, 1, GL_FALSE, clip.data());
    glBindTextureUnit(0, photo.id());
    glBindFramebuffer(GL_FRAMEBUFFER, target.id());
    glViewport(0, 0, width, height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE);
    std::vector<double> ms;
    for (int f = 0; f < frames; ++f) {
        const auto start = std::chrono::steady_clock::now();
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        for (int d = 0; d < draws; ++d)
            glDrawElements(GL_TRIANGLES, GLsizei(indices.size()), GL_UNSIGNED_INT, nullptr);
        glFinish();
        ms.push_back(1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    std::ranges::sort(ms);
    return ms[ms.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return std::fprintf(stderr, "usage: ledger-draws PACKAGE DRAWS\n"), 2;
    const gl::HeadlessContext context;
    std::printf("%.3f\n", median_ms(PackageReader(argv[1]), std::atoi(argv[2])));
}
