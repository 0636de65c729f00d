#pragma once
#include <span>
#include <string_view>

namespace vantage::gl {

/// A file from shaders/, compiled into the program.
struct EmbeddedShader {
    std::string_view file, text;
};
/// All shader files. The build generates the source (embed_shaders.cmake).
std::span<const EmbeddedShader> embedded_shaders();

}  // namespace vantage::gl
