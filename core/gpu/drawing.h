#pragma once

#include <epoxy/gl.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/gpu/program.h"
#include "core/gpu/renderer.h"

// Shared by the renderer's source files; not for use outside of this folder.

namespace cullscope {

/// Uniform locations that the shaders of scene triangles declare.
enum Uniform : GLint {
    kClipFromPositions = 0,
    kSightFromPositions = 1,
    kNormalMatrix = 2,
    kSurfaceColour = 3,
    kFirstTriangle = 4,
    kWantedLook = 5,
    kHatch = 6,
    kHatchPlace = 7,
    kFirstPlace = 8,
    kSection = 9,  ///< of scene_cut.vert
    kBackColour = 10
};

inline constexpr GLuint kPosition = 0;
inline constexpr GLuint kNormal = 1;

class AnswerBuffers;
class BoxQueries;
class DepthPyramid;

/// A buffer of OpenGL's for indices that one draw uses. Its memory is kept for the next draw: to begin on fresh memory each time
/// costs more than to copy the indices.
class GatheredIndices {
public:
    GatheredIndices() = default;
    ~GatheredIndices();
    GatheredIndices(const GatheredIndices&) = delete;
    GatheredIndices& operator=(const GatheredIndices&) = delete;

    /// Calls `write(memory)`, which fills the first `bytes` of the buffer. Draws before it keep what they use. False, without the
    /// call, where memory runs out.
    bool fill(size_t bytes, const std::function<void(void* memory)>& write);
    [[nodiscard]] unsigned buffer() const { return m_buffer; }

private:
    unsigned m_buffer = 0;
    size_t m_bytes = 0;
};

/// How scene triangles are passed on.
struct TriangleInput {
    unsigned vertexArray = 0;
    /// By which many small ranges are drawn as one, on a software OpenGL; null: they are not.
    GatheredIndices* gathered = nullptr;
    std::stop_token stop;  ///< ends what is drawn between two objects (Renderer::Stoppable)
};

/// The programs of scene triangles, with one vertex shader.
struct ScenePrograms {
    explicit ScenePrograms(std::string_view vertexShader);

    Program lambert, depth, item, itemOrdered, state;
};

struct Renderer::Programs {
    Programs();
    ~Programs();
    Programs(const Programs&) = delete;
    Programs& operator=(const Programs&) = delete;

    [[nodiscard]] TriangleInput input() { return {vertexArray, software ? &gathered : nullptr, stop}; }
    /// Those for the pictures of a view: they cut where it is a section. Compiled when the first one is drawn.
    [[nodiscard]] ScenePrograms& of(const View& view);

    ScenePrograms scene;
    std::unique_ptr<ScenePrograms> sectionScene;
    Program line, sphericalModel;
    std::map<std::string, Program> choices;  ///< by the source of the shader that chooses
    unsigned vertexArray = 0;                ///< of scene triangles
    bool software = false;                   ///< the context's OpenGL is one (GlInfo::software)
    std::stop_token stop;                    ///< that of the innermost Stoppable
    unsigned lineArray = 0;                  ///< of LineOnGpu, one element per drawn line
    std::shared_ptr<BoxQueries> boxQueries;  ///< of this context; tickets hold it too
    std::shared_ptr<AnswerBuffers> answers;  ///< the same
    GatheredIndices gathered;
    std::unique_ptr<DepthPyramid> pyramid;  ///< null: none was asked about yet
    bool indirect = false;                  ///< what the GPU chooses is drawn indirectly
};

/// Sets OpenGL's state for the renderer: reversed-Z into a framebuffer. Of a section both sides of triangles are drawn, for it
/// shows what is inside of objects. The destructor restores the defaults that Qt expects.
class DrawingState {
public:
    /// For the picture of `view`, or for the part of it that `target` holds.
    DrawingState(const View& view, const Framebuffer& target, Facing facing, DepthRule depth = DepthRule::Nearest);
    ~DrawingState();
    DrawingState(const DrawingState&) = delete;
    DrawingState& operator=(const DrawingState&) = delete;

private:
    GLint m_previousDraw = 0;
    GLint m_previousRead = 0;
};

/// Which faces OpenGL draws of the instance in hand, where that differs from object to object. Within a drawing state.
class FacingState {
public:
    explicit FacingState(Facing rule) : m_rule(rule) {}
    void setFor(const Scene& scene, uint32_t instance);

private:
    Facing m_rule;
    Facing m_current = Facing::ByObject;  ///< not known
};

/// Triangles that a strategy made, as vertex input; the instance's uniforms are set by run.
class OwnInput {
public:
    OwnInput(const OwnTriangles& triangles, unsigned vertexArray);
    ~OwnInput();
    OwnInput(const OwnInput&) = delete;
    OwnInput& operator=(const OwnInput&) = delete;

    /// Draws all runs; `perRun(run)` is called before each.
    void draw(const Scene& scene, const View& view, const std::function<void(const OwnTriangles::Run&)>& perRun) const;
    /// The scene triangle numbers, as a shader storage buffer.
    [[nodiscard]] unsigned numbers() const { return m_numbers; }

private:
    const OwnTriangles& m_triangles;
    unsigned m_vertices = 0, m_numbers = 0;
};

/// Clears the bound framebuffer's colour to the style's background, and its depth.
void clearTo(const DrawStyle& style);

/// The colours of the Lambert shader in use.
void setSurfaceColours(const DrawStyle& style);

/// Writes the part of a finished picture that a framebuffer holds: its depth, and its colour, shaded as the Lambert shader does.
void writePicture(const Scene& scene, const View& view, const FinishedPicturePointer& picture, const DrawStyle& style,
                  Framebuffer& target);

/// Binds meshes as vertex input, one at a time, and returns addresses into their index buffers.
class VertexInput {
public:
    /// Which of a mesh's index buffers is used.
    enum class Indices {
        Whole,   ///< all triangles, in the order that is fastest to draw
        InOrder  ///< ranges of triangles, in the draw list's order
    };

    /// For ranges in `order` (null: in every mesh's own order) under the drawing state's facing rule.
    VertexInput(const SceneBuffers& buffers, unsigned vertexArray, TriangleOrderPointer order, Facing facing);
    ~VertexInput();
    VertexInput(const VertexInput&) = delete;
    VertexInput& operator=(const VertexInput&) = delete;

    /// Binds an instance's mesh as vertex input and sets the instance's uniforms, its winding, and which of its faces are drawn.
    void bind(const View& view, uint32_t instance, Indices indices);
    [[nodiscard]] const void* indexAddress(uint32_t firstIndex) const {
        // In a buffer the address is an offset from its start, and no pointer to add to.
        const size_t offset = size_t{firstIndex} * m_indices.bytes;
        return m_indices.client != nullptr ? m_indices.client + offset : reinterpret_cast<const void*>(offset);
    }
    [[nodiscard]] unsigned indexBuffer() const { return m_indices.buffer; }
    [[nodiscard]] GLenum indexType() const { return m_indices.bytes == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT; }

    /// Binds a mesh as vertex input and sets nothing else.
    void bindMesh(uint32_t mesh, Indices indices);

private:
    [[nodiscard]] bool client() const { return m_buffers.upload() == Upload::VertexArray; }
    void bindVertices(uint32_t mesh);
    void bindIndices(uint32_t mesh, Indices indices);

    const SceneBuffers& m_buffers;
    unsigned m_vertexArray;
    TriangleOrderPointer m_order;
    FacingState m_facing;
    uint32_t m_bound = UINT32_MAX;
    Indices m_boundIndices = Indices::Whole;
    GpuIndices m_indices;
};

/// A line in OpenGL's format, relative to the eye.
struct LineOnGpu {
    Vec3f from, to, colour;
};

/// Draws lines with square ends within the current drawing state; writes no depth. Restores only the bindings that it changes.
void drawLinesOnGpu(const Program& program, unsigned lineArray, const View& view, std::span<const LineOnGpu> lines, float width);

}  // namespace cullscope
