#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/gl/object.h"

namespace vantage::gl {

/// A stage of a program: its type and the name of its file in shaders/.
struct Stage {
    GLenum type;
    std::string file;
};

/// Compiles and links. Shader text is embedded at build time; `#include "file"` is resolved. Each of
/// `defines`, "NAME" or "NAME value", becomes a #define after #version. Throws Failure with the file's name
/// and the driver's log.
Program make_program(const std::string& label, const std::vector<Stage>& stages,
                     const std::vector<std::string>& defines = {});

/// The text of an embedded shader file. Throws Failure if there is no such file.
std::string_view shader_source(std::string_view file);

}  // namespace vantage::gl
