#include <gtest/gtest.h>

#include <array>

#include "base/gl/context.h"
#include "base/gl/failure.h"
#include "base/gl/object.h"
#include "base/gl/program.h"

using namespace vantage;

TEST(Gl, HeadlessContextClearsATexture) {
    const gl::HeadlessContext context(gl::Debug::on);
    const gl::Texture color = gl::make_texture_2d("color", GL_RGBA8, 4, 4);
    const std::array ids{color.id()};
    const gl::Framebuffer target = gl::make_framebuffer("target", ids, 0);
    const std::array value{1.0f, 0.0f, 0.5f, 1.0f};
    glClearNamedFramebufferfv(target.id(), GL_COLOR, 0, value.data());
    std::array<std::uint8_t, 64> pixels{};
    glGetTextureImage(color.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, 64, pixels.data());
    EXPECT_EQ(pixels[0], 255);
    EXPECT_EQ(pixels[1], 0);
    EXPECT_NEAR(pixels[2], 128, 1);
    EXPECT_NO_THROW(gl::check("test"));
}

TEST(Gl, ErrorsAreReported) {
    const gl::HeadlessContext context(gl::Debug::on);
    glBindFramebuffer(GL_FRAMEBUFFER, 12345);
    EXPECT_THROW(gl::check("test"), gl::Failure);
    EXPECT_NO_THROW(gl::check("after"));
}

TEST(Gl, ErrorsAreReportedWithoutDebugging) {
    const gl::HeadlessContext context(gl::Debug::off);
    EXPECT_FALSE(glIsEnabled(GL_DEBUG_OUTPUT));
    glBindFramebuffer(GL_FRAMEBUFFER, 12345);
    EXPECT_THROW(gl::check("test"), gl::Failure);
}

TEST(Gl, HighSeverityMessagesFailWhenDebugging) {
    const gl::HeadlessContext context(gl::Debug::on);
    const auto insert = [](GLenum severity) {
        glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_OTHER, 1, severity, -1, "on fire");
    };
    insert(GL_DEBUG_SEVERITY_NOTIFICATION);
    EXPECT_NO_THROW(gl::check("notification"));
    insert(GL_DEBUG_SEVERITY_HIGH);
    try {
        gl::check("high");
        FAIL();
    } catch (const gl::Failure& e) {
        EXPECT_NE(std::string(e.what()).find("on fire"), std::string::npos);
    }
}

TEST(Gl, UnknownShaderIsNamed) {
    const gl::HeadlessContext context(gl::Debug::on);
    try {
        gl::make_program("none", {{GL_VERTEX_SHADER, "no_such.vert"}});
        FAIL();
    } catch (const gl::Failure& e) {
        EXPECT_NE(std::string(e.what()).find("no_such.vert"), std::string::npos);
    }
}
