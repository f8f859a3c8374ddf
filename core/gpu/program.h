#pragma once

#include <string_view>
#include <utility>
#include <vector>

namespace cullscope {

/// An owned, linked OpenGL program.
class Program {
public:
    /// Compiles and links. Throws Error(OpenGl) with the driver's log where that fails.
    Program(std::string_view vertexSource, std::string_view fragmentSource) : Program(vertexSource, {}, fragmentSource) {}
    /// The same with a geometry shader; none where its source is empty.
    Program(std::string_view vertexSource, std::string_view geometrySource, std::string_view fragmentSource);
    /// A program of one compute shader; `defines`: lines that come after the first one, which has the version. Throws
    /// Error(OpenGl) as above.
    [[nodiscard]] static Program compute(std::string_view source, std::string_view defines = {});
    ~Program();
    Program(Program&& other) noexcept : m_program(std::exchange(other.m_program, 0)) {}
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    [[nodiscard]] unsigned id() const { return m_program; }

private:
    explicit Program(const std::vector<unsigned>& shaders);

    unsigned m_program = 0;
};

}  // namespace cullscope
