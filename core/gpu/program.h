#pragma once

#include <string_view>

namespace cullscope {

/// An owned, linked OpenGL program.
class Program {
public:
    /// Compiles and links. Throws Error(OpenGl) with the driver's log where that fails.
    Program(std::string_view vertexSource, std::string_view fragmentSource) : Program(vertexSource, {}, fragmentSource) {}
    /// The same with a geometry shader; none where its source is empty.
    Program(std::string_view vertexSource, std::string_view geometrySource, std::string_view fragmentSource);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    [[nodiscard]] unsigned id() const { return m_program; }

private:
    unsigned m_program = 0;
};

}  // namespace cullscope
