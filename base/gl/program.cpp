#include "base/gl/program.h"

#include <algorithm>

#include "base/gl/embedded_shaders.h"
#include "base/gl/failure.h"

namespace vantage::gl {

std::string_view shader_source(std::string_view file) {
    for (const EmbeddedShader& s : embedded_shaders())
        if (s.file == file) return s.text;
    throw Failure("no shader file '" + std::string(file) + "'");
}

namespace {

std::string with_includes(std::string_view file, int depth = 0) {
    if (depth > 8) throw Failure("circular shader includes at '" + std::string(file) + "'");
    std::string out;
    std::string_view rest = shader_source(file);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size() - 1) + 1;
        const std::string_view line = rest.substr(0, end);
        rest.remove_prefix(end);
        if (line.starts_with("#include \""))
            out += with_includes(line.substr(10, line.rfind('"') - 10), depth + 1);
        else
            out += line;
    }
    return out;
}

GLuint compile(const Stage& stage, const std::vector<std::string>& defines) {
    std::string text = "#version 450 core\n";
    for (const std::string& d : defines) text += "#define " + d + "\n";
    text += with_includes(stage.file);
    const GLuint shader = glCreateShader(stage.type);
    const char* source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok) return shader;
    std::string log(4096, '\0');
    GLsizei n = 0;
    glGetShaderInfoLog(shader, GLsizei(log.size()), &n, log.data());
    glDeleteShader(shader);
    throw Failure("shader " + stage.file + " does not compile: " + log.substr(0, std::size_t(n)));
}

}  // namespace

Program make_program(const std::string& label, const std::vector<Stage>& stages,
                     const std::vector<std::string>& defines) {
    Program program(glCreateProgram());
    for (const Stage& stage : stages) {
        const GLuint shader = compile(stage, defines);
        glAttachShader(program.id(), shader);
        glDeleteShader(shader);  // deleted with the program
    }
    glLinkProgram(program.id());
    GLint ok = 0;
    glGetProgramiv(program.id(), GL_LINK_STATUS, &ok);
    if (!ok) {
        std::string log(4096, '\0');
        GLsizei n = 0;
        glGetProgramInfoLog(program.id(), GLsizei(log.size()), &n, log.data());
        throw Failure("program " + label + " does not link: " + log.substr(0, std::size_t(n)));
    }
    glObjectLabel(GL_PROGRAM, program.id(), -1, label.c_str());
    return program;
}

}  // namespace vantage::gl
