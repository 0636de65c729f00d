// The photo buffer has the same layout in C++ and in the shaders.
#include <gtest/gtest.h>

#include <cstddef>

#include "base/gl/context.h"
#include "player/render/passes/blend_program.h"
#include "player/stream/photo_block.h"

using namespace vantage;

namespace {

GLint property_of(const gl::Program& program, const char* member, GLenum property) {
    const GLuint index = glGetProgramResourceIndex(program.id(), GL_BUFFER_VARIABLE, member);
    EXPECT_NE(index, GL_INVALID_INDEX) << member;
    if (index == GL_INVALID_INDEX) return -1;
    GLint value = -1;
    glGetProgramResourceiv(program.id(), GL_BUFFER_VARIABLE, index, 1, &property, 1, nullptr, &value);
    return value;
}

}  // namespace

TEST(ShaderContract, PhotosHaveTheSameLayoutInCppAndGlsl) {
    const gl::HeadlessContext context;
    const gl::Program program = make_blend_program({.photos = max_photos_per_pass,
                                                    .per_fragment = true,
                                                    .blend = Blend::lumigraph,
                                                    .transients = false,
                                                    .traces_texels = false,
                                                    .trilinear = true,
                                                    .anisotropy = 1,
                                                    .refined_colors = true},
                                                   package::SceneRecord{});
    struct Member {
        const char* name;
        std::size_t offset;
    };
    for (const Member& m : {Member{"photos[0].cam_from_origin", offsetof(PhotoBlock, cam_from_origin)},
                            Member{"photos[0].focal_center", offsetof(PhotoBlock, focal_center)},
                            Member{"photos[0].size_weight", offsetof(PhotoBlock, size_weight)},
                            Member{"photos[0].center_hull", offsetof(PhotoBlock, center_hull)},
                            Member{"photos[0].direction", offsetof(PhotoBlock, direction)},
                            Member{"photos[0].false_color", offsetof(PhotoBlock, false_color)},
                            Member{"photos[0].gain", offsetof(PhotoBlock, gain)},
                            Member{"photos[0].vignetting", offsetof(PhotoBlock, vignetting)},
                            Member{"photos[0].color_base[0]", offsetof(PhotoBlock, color_base)},
                            Member{"photos[0].weight_base[0]", offsetof(PhotoBlock, weight_base)}}) {
        EXPECT_EQ(property_of(program, m.name, GL_OFFSET), GLint(m.offset)) << m.name;
        EXPECT_EQ(property_of(program, m.name, GL_TOP_LEVEL_ARRAY_STRIDE), GLint(sizeof(PhotoBlock)));
    }
    EXPECT_EQ(property_of(program, "photos[0].color_base[0]", GL_ARRAY_STRIDE), 4);
}
