#pragma once

#include <epoxy/gl.h>

#include <vector>

#include "core/gpu/program.h"
#include "core/gpu/renderer.h"

// What the renderer's source files share; nothing of it is for other folders.

namespace cullscope {

/// Uniform locations that the shaders of scene triangles declare.
enum Uniform : GLint {
    kClipFromPositions = 0,
    kEyeRelativeFromPositions = 1,
    kNormalMatrix = 2,
    kSurfaceColour = 3,
    kFirstTriangle = 4,
    kWantedLook = 5,
    kHatch = 6,
    kHatchPlace = 7,
    kFirstPlace = 8
};

inline constexpr GLuint kPosition = 0;
inline constexpr GLuint kNormal = 1;

struct Renderer::Programs {
    Programs();
    ~Programs();
    Programs(const Programs&) = delete;
    Programs& operator=(const Programs&) = delete;

    Program lambert, depth, item, state, line, sphericalModel;
    unsigned vertexArray = 0;  ///< of scene triangles
    unsigned lineArray = 0;    ///< of LineOnGpu, one an instance
};

/// OpenGL's state while the renderer works: reversed-Z into a framebuffer; back to the defaults that Qt expects afterwards.
class DrawingState {
public:
    /// For what `view` sees, or for the part of it that `target` holds.
    DrawingState(const View& view, const Framebuffer& target, Facing facing);
    ~DrawingState();
    DrawingState(const DrawingState&) = delete;
    DrawingState& operator=(const DrawingState&) = delete;

private:
    GLint m_previousDraw = 0;
    GLint m_previousRead = 0;
};

/// Clears the bound framebuffer's colour to the style's background, and its depth.
void clearTo(const DrawStyle& style);

/// Binds one mesh after the other as vertex input and hands out index addresses.
class VertexInput {
public:
    /// Which of a mesh's index buffers is drawn from.
    enum class Indices {
        Whole,   ///< all triangles, in whichever order is fastest
        InOrder  ///< ranges of them, in the list's order
    };

    /// For ranges in `order`; null: in the meshes' own.
    VertexInput(const SceneBuffers& buffers, unsigned vertexArray, TriangleOrderPointer order);
    ~VertexInput();
    VertexInput(const VertexInput&) = delete;
    VertexInput& operator=(const VertexInput&) = delete;

    /// Makes an instance's mesh the vertex input and sets its uniforms and its winding.
    void bind(const View& view, uint32_t instance, Indices indices);
    [[nodiscard]] const void* indexAddress(uint32_t firstIndex) const {
        return m_indices.client + size_t{firstIndex} * m_indices.bytes;
    }
    [[nodiscard]] GLenum indexType() const { return m_indices.bytes == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT; }

    /// Makes a mesh the vertex input and sets nothing else.
    void bindMesh(uint32_t mesh, Indices indices);

private:
    [[nodiscard]] bool client() const { return m_buffers.upload() == Upload::VertexArray; }
    void bindVertices(uint32_t mesh);
    void bindIndices(uint32_t mesh, Indices indices);

    const SceneBuffers& m_buffers;
    unsigned m_vertexArray;
    TriangleOrderPointer m_order;
    uint32_t m_bound = UINT32_MAX;
    Indices m_boundIndices = Indices::Whole;
    GpuIndices m_indices;
};

/// A line as OpenGL takes it, relative to the eye.
struct LineOnGpu {
    Vec3f from, to, colour;
};

/// Draws lines with square ends within the current drawing state; leaves no depth. Restores nothing but what it binds.
void drawLinesOnGpu(const Program& program, unsigned lineArray, const View& view, std::span<const LineOnGpu> lines, float width);

}  // namespace cullscope
