// The uniform block of photos has the same layout in C++ and in the shaders.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "base/gl/context.h"
#include "player/render/passes/blend_program.h"
#include "player/stream/photo_block.h"

using namespace vantage;

namespace {

GLint property_of(const gl::Program& program, const std::string& member, GLenum property) {
    const GLuint index = glGetProgramResourceIndex(program.id(), GL_UNIFORM, member.c_str());
    EXPECT_NE(index, GL_INVALID_INDEX) << member;
    if (index == GL_INVALID_INDEX) return -1;
    GLint value = -1;
    glGetProgramResourceiv(program.id(), GL_UNIFORM, index, 1, &property, 1, nullptr, &value);
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
    for (const Member& m :
         {Member{"cam_from_origin", offsetof(PhotoBlock, cam_from_origin)},
          Member{"focal_center", offsetof(PhotoBlock, focal_center)},
          Member{"size_weight", offsetof(PhotoBlock, size_weight)},
          Member{"center_hull", offsetof(PhotoBlock, center_hull)},
          Member{"direction", offsetof(PhotoBlock, direction)},
          Member{"false_color", offsetof(PhotoBlock, false_color)},
          Member{"gain", offsetof(PhotoBlock, gain)}, Member{"vignetting", offsetof(PhotoBlock, vignetting)},
          Member{"color_base[0]", offsetof(PhotoBlock, color_base)},
          Member{"weight_base[0]", offsetof(PhotoBlock, weight_base)}}) {
        const std::string first = std::string("photos[0].") + m.name,
                          second = std::string("photos[1].") + m.name;
        EXPECT_EQ(property_of(program, first, GL_OFFSET), GLint(m.offset)) << m.name;
        EXPECT_EQ(property_of(program, second, GL_OFFSET), GLint(m.offset + sizeof(PhotoBlock))) << m.name;
    }
    EXPECT_EQ(property_of(program, "photos[0].color_base[0]", GL_ARRAY_STRIDE), 16);
}
