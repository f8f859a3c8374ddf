#include "core/base/error.h"
#include "core/gpu/submission.h"

namespace cullscope {
namespace {

constexpr GLuint kNothing = UINT32_MAX;
constexpr GLuint kOrderBinding = 2;

/// Depth and triangle numbers as textures, empty until something is drawn.
class ItemTarget {
public:
    explicit ItemTarget(const PictureTile& tile) : m_depth(tile) {
        glCreateTextures(GL_TEXTURE_2D, 1, &m_items);
        glTextureStorage2D(m_items, 1, GL_R32UI, tile.size.width, tile.size.height);
        glClearTexImage(m_items, 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &kNothing);
    }
    ~ItemTarget() { glDeleteTextures(1, &m_items); }
    ItemTarget(const ItemTarget&) = delete;
    ItemTarget& operator=(const ItemTarget&) = delete;

    /// Makes the numbers the colour of the framebuffer, so that what is drawn last stays.
    void drawInOrder() const {
        glNamedFramebufferTexture(m_depth.id(), GL_COLOR_ATTACHMENT0, m_items, 0);
        glClearNamedFramebufferuiv(m_depth.id(), GL_COLOR, 0, &kNothing);
        constexpr GLfloat kFar = 0.0f;
        glClearNamedFramebufferfv(m_depth.id(), GL_DEPTH, 0, &kFar);
    }

    [[nodiscard]] const Framebuffer& depth() const { return m_depth; }
    [[nodiscard]] unsigned items() const { return m_items; }

private:
    Framebuffer m_depth;
    unsigned m_items = 0;
};

void requireNumbers(const Scene& scene) {
    if (scene.triangleCount() >= kNothing)
        throwUsage(CULLSCOPE_TR("The scene has %1 triangles; the item buffer numbers at most 4294967294. Measure a part of it."),
                   {std::to_string(scene.triangleCount())});
}

/// The numbers of triangles in an order of their own are bound while it lives, also where a stop request ends what is drawn.
struct OrderNumbers {
    OrderNumbers() = default;
    ~OrderNumbers() {
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kOrderBinding, 0);
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
    }
    OrderNumbers(const OrderNumbers&) = delete;
    OrderNumbers& operator=(const OrderNumbers&) = delete;
};

/// So is the image into which the shader writes items.
struct ItemImage {
    explicit ItemImage(const ItemTarget& target) {
        glBindImageTexture(0, target.items(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
    }
    ~ItemImage() {
        glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
        glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R32UI);
    }
    ItemImage(const ItemImage&) = delete;
    ItemImage& operator=(const ItemImage&) = delete;
};

/// Submits one draw call for each range, with the triangles' numbers as the item shader needs them.
void submitItems(const SceneBuffers& buffers, const View& view, const DrawList& list, const TriangleInput& input) {
    const Scene& scene = buffers.scene();
    const OrderNumbers numbers;
    submit(buffers, view, list, input, true, [&](const SubmittedRun& run) {
        const uint32_t mesh = scene.instances()[run.ranges.front().instance].mesh;
        const bool ordered = !list.orderOf(mesh).triangles.empty();
        if (ordered) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kOrderBinding, buffers.orderNumbers(list.order, mesh));
        for (size_t i = 0; i < run.ranges.size(); ++i) {
            const GLuint place = run.ranges[i].firstIndex / 3;
            const auto first = static_cast<GLuint>(scene.firstTriangle(run.ranges[i].instance));
            glUniform1ui(kFirstTriangle, ordered ? first : first + place);
            glUniform1i(kFirstPlace, ordered ? static_cast<GLint>(place) : -1);
            glDrawElements(GL_TRIANGLES, run.counts[i], run.indexType, run.addresses[i]);
        }
    });
}

/// A depth pass, then the lowest number at each depth, within the current drawing state.
void drawItems(unsigned depthProgram, unsigned itemProgram, const TriangleInput& input, const SceneBuffers& buffers,
               const View& view, const DrawList& list, const ItemTarget& target) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glUseProgram(depthProgram);
    submitAll(buffers, view, list, input);

    glDepthFunc(GL_EQUAL);
    glDepthMask(GL_FALSE);
    glUseProgram(itemProgram);
    {
        const ItemImage image(target);
        submitItems(buffers, view, list, input);
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

/// The part of a finished picture that a target holds.
void writeItems(const FinishedPicture& picture, const ItemTarget& target) {
    const PictureTile& tile = target.depth().tile();
    std::vector<uint32_t> items;
    std::vector<float> depth;
    for (int y = tile.y; y < tile.y + tile.size.height; ++y)
        for (int x = tile.x; x < tile.x + tile.size.width; ++x) {
            const size_t pixel = size_t(y) * size_t(picture.size.width) + size_t(x);
            items.push_back(picture.triangle[pixel] - 1);  // 0 becomes kNothing
            depth.push_back(picture.depth[pixel]);
        }
    glTextureSubImage2D(target.items(), 0, 0, 0, tile.size.width, tile.size.height, GL_RED_INTEGER, GL_UNSIGNED_INT,
                        items.data());
    glTextureSubImage2D(target.depth().depthTexture(), 0, 0, 0, tile.size.width, tile.size.height, GL_DEPTH_COMPONENT, GL_FLOAT,
                        depth.data());
}

/// Replays a frame's commands into a target, each with its own depth rule.
void replayItems(unsigned program, const TriangleInput& by, const SceneBuffers& buffers, const View& view, const FrameLog& log,
                 const ItemTarget& target, const std::optional<PictureTile>& scissor) {
    target.drawInOrder();
    const auto limit = [&] {
        if (!scissor) return;
        glScissor(scissor->x, scissor->y, scissor->size.width, scissor->size.height);
        glEnable(GL_SCISSOR_TEST);
    };
    for (const Command& command : log.commands) {
        if (const auto* picture = std::get_if<FinishedPicturePointer>(&command)) writeItems(**picture, target);
        if (const auto* list = std::get_if<DrawList>(&command)) {
            const DrawingState state(view, target.depth(), list->facing, list->depth);
            limit();
            glUseProgram(program);
            submitItems(buffers, view, *list, by);
        }
        if (const auto* own = std::get_if<OwnTrianglesPointer>(&command)) {
            const DrawingState state(view, target.depth(), (*own)->facing, (*own)->depth);
            limit();
            glUseProgram(program);
            const OwnInput input(**own, by.vertexArray);
            glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kOrderBinding, input.numbers());
            glUniform1ui(kFirstTriangle, 0);
            input.draw(buffers.scene(), view,
                       [](const OwnTriangles::Run& run) { glUniform1i(kFirstPlace, static_cast<GLint>(run.first)); });
            glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kOrderBinding, 0);
        }
    }
}

Renderer::ItemBuffer read(const ItemTarget& target) {
    const Viewport& size = target.depth().size();
    Renderer::ItemBuffer result{target.depth().readDepth(),
                                std::vector<uint32_t>(static_cast<size_t>(size.width) * static_cast<size_t>(size.height))};
    glGetTextureImage(target.items(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                      static_cast<GLsizei>(result.triangle.size() * sizeof(uint32_t)), result.triangle.data());
    // The image holds triangle numbers, with the largest number for an empty pixel; the result holds numbers + 1, with 0 for an
    // empty pixel. The addition wraps the largest number to 0.
    for (uint32_t& triangle : result.triangle) ++triangle;
    // llvmpipe may cover a pixel with a needle in the order of the depth pass and not in that of the numbers: no triangle is
    // known to be seen there.
    for (size_t pixel = 0; pixel < result.depth.size(); ++pixel)
        if (result.triangle[pixel] == 0) result.depth[pixel] = 0.0F;
    return result;
}

std::optional<PickedTriangle> readPixel(const ItemTarget& target, int x, int y) {
    GLuint triangle = kNothing;
    GLfloat depth = 0.0f;
    glGetTextureSubImage(target.items(), 0, x, y, 0, 1, 1, 1, GL_RED_INTEGER, GL_UNSIGNED_INT, sizeof triangle, &triangle);
    glGetTextureSubImage(target.depth().depthTexture(), 0, x, y, 0, 1, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, sizeof depth, &depth);
    if (triangle == kNothing) return std::nullopt;
    return PickedTriangle{triangle, depth};
}

}  // namespace

Renderer::ItemBuffer Renderer::drawItemBuffer(const SceneBuffers& buffers, const View& view, const DrawList& list,
                                              const PictureTile& tile) {
    requireNumbers(buffers.scene());
    const ItemTarget target(tile);
    {
        const DrawingState state(view, target.depth(), list.facing);
        drawItems(m_programs->of(view).depth.id(), m_programs->of(view).item.id(), m_programs->input(), buffers, view, list,
                  target);
    }
    return read(target);
}

Renderer::ItemBuffer Renderer::drawItemBuffer(const SceneBuffers& buffers, const View& view, const FrameLog& log,
                                              const PictureTile& tile) {
    if (log.drawsScene() || !replaysFrom(view, log))
        return drawItemBuffer(buffers, view, drawnTriangles(buffers.scene(), log), tile);
    requireNumbers(buffers.scene());
    const ItemTarget target(tile);
    replayItems(m_programs->of(view).itemOrdered.id(), m_programs->input(), buffers, view, log, target, std::nullopt);
    return read(target);
}

std::optional<PickedTriangle> Renderer::pick(const SceneBuffers& buffers, const View& view, const DrawList& list, int x, int y) {
    const Viewport size = view.viewport();
    if (x < 0 || y < 0 || x >= size.width || y >= size.height) return std::nullopt;
    requireNumbers(buffers.scene());
    const ItemTarget target({0, 0, size});
    {
        const DrawingState state(view, target.depth(), list.facing);
        glScissor(x, y, 1, 1);
        glEnable(GL_SCISSOR_TEST);
        drawItems(m_programs->of(view).depth.id(), m_programs->of(view).item.id(), m_programs->input(), buffers, view, list,
                  target);
    }
    return readPixel(target, x, y);
}

std::optional<PickedTriangle> Renderer::pick(const SceneBuffers& buffers, const View& view, const FrameLog& log, int x, int y) {
    if (log.drawsScene() || !replaysFrom(view, log)) return pick(buffers, view, drawnTriangles(buffers.scene(), log), x, y);
    const Viewport size = view.viewport();
    if (x < 0 || y < 0 || x >= size.width || y >= size.height) return std::nullopt;
    requireNumbers(buffers.scene());
    const ItemTarget target({0, 0, size});
    replayItems(m_programs->of(view).itemOrdered.id(), m_programs->input(), buffers, view, log, target,
                PictureTile{x, y, {1, 1}});
    return readPixel(target, x, y);
}

}  // namespace cullscope
