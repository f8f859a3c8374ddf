#include "core/gpu/program.h"

#include <epoxy/gl.h>

#include <string>
#include <vector>

#include "core/base/error.h"

namespace cullscope {
namespace {

unsigned compiled(GLenum stage, std::string_view source) {
    const unsigned shader = glCreateShader(stage);
    const char* text = source.data();
    const auto length = static_cast<GLint>(source.size());
    glShaderSource(shader, 1, &text, &length);
    glCompileShader(shader);
    return shader;
}

}  // namespace

Program::Program(std::string_view vertexSource, std::string_view geometrySource, std::string_view fragmentSource)
    : Program([&] {
          std::vector<unsigned> shaders{compiled(GL_VERTEX_SHADER, vertexSource), compiled(GL_FRAGMENT_SHADER, fragmentSource)};
          if (!geometrySource.empty()) shaders.push_back(compiled(GL_GEOMETRY_SHADER, geometrySource));
          return shaders;
      }()) {}

Program Program::compute(std::string_view source, std::string_view defines) {
    std::string text(source);
    text.insert(text.find('\n') + 1, defines);
    return Program(std::vector{compiled(GL_COMPUTE_SHADER, text)});
}

Program::Program(const std::vector<unsigned>& shaders) : m_program(glCreateProgram()) {
    for (const unsigned shader : shaders) glAttachShader(m_program, shader);
    glLinkProgram(m_program);
    GLint linked = GL_FALSE;
    glGetProgramiv(m_program, GL_LINK_STATUS, &linked);
    std::string log(4096, '\0');
    GLsizei length = 0;
    if (linked == GL_FALSE)
        for (const unsigned shader : shaders) {
            glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
            if (length > 0) break;
        }
    for (const unsigned shader : shaders) glDeleteShader(shader);
    if (linked == GL_TRUE) return;
    if (length == 0) glGetProgramInfoLog(m_program, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<size_t>(length));
    glDeleteProgram(m_program);
    throwOpenGl(CULLSCOPE_TR("The graphics driver refuses a shader: %1"), {log});
}

Program::~Program() { glDeleteProgram(m_program); }

}  // namespace cullscope
