#include "ui/jobs/tiled_picture.h"

#include "core/image/picture_file.h"
#include "core/measure/accuracy.h"

namespace cullscope::ui {

TiledPicture::TiledPicture(ViewRequest request, const Wanted& wanted)
    : m_request(std::move(request)), m_wanted(wanted), m_tiles(tilesOf(m_request.size)) {
    if (!wanted.truth) return;
    m_cullingTiles = tilesOf(m_request.cullingSize);
    m_visible.resize(m_request.buffers->scene().triangleCount());
}

size_t TiledPicture::steps() const { return m_cullingTiles.size() + m_tiles.size() * (m_wanted.items ? 2 : 1); }

bool TiledPicture::drawNext(FramesBeside& frames, Renderer& renderer) {
    size_t step = m_step++;
    if (!m_frame) m_frame = frames.of(m_request.frame(), renderer);
    if (step < m_cullingTiles.size()) {
        findVisible(renderer, m_cullingTiles[step]);
        if (step + 1 == m_cullingTiles.size()) finishTruth();
        return true;
    }
    step -= m_cullingTiles.size();
    if (!m_drawing) {
        const ViewFramePointer other = m_request.other ? frames.of(m_request.otherFrame(), renderer) : nullptr;
        m_drawing.emplace(m_request, m_frame, other);
    }
    if (step < m_tiles.size()) {
        Framebuffer target(m_tiles[step]);
        m_drawing->draw(renderer, target);
        if (step + 1 == m_tiles.size()) m_result.picture = m_drawing->finish(m_wanted.reach);
    } else {
        drawItems(renderer, m_tiles[step - m_tiles.size()]);
    }
    return m_step < steps();
}

void TiledPicture::findVisible(Renderer& renderer, const PictureTile& tile) {
    const View culling(m_request.culling, m_request.cullingSize);
    const Scene& scene = m_request.buffers->scene();
    const Facing facing = m_request.strategy->referenceFacing();
    Renderer::ItemBuffer truth = renderer.drawItemBuffer(*m_request.buffers, culling, everything(scene, facing), tile);
    for (const uint32_t item : truth.triangle)
        if (item != 0) m_visible[item - 1] = true;
    if (!snappingMayExplain(m_frame->log, facing)) return;
    Framebuffer target(tile);
    Reference part;
    part.depth = std::move(truth.depth);
    part.triangle = std::move(truth.triangle);
    const ShownPixels shown = shownPixels(renderer, *m_request.buffers, m_frame->log, target);
    const std::vector<uint32_t> lost = pixelsMissedBeyondSnapping(renderer, *m_request.buffers, m_frame->log, part, shown, tile);
    for (const uint32_t triangle : trianglesAt(part, lost)) m_lost.insert(triangle);
}

void TiledPicture::finishTruth() {
    Reference truth;
    truth.size = m_request.cullingSize;
    truth.facing = m_request.strategy->referenceFacing();
    for (size_t triangle = 0; triangle < m_visible.size(); ++triangle)
        if (m_visible[triangle]) truth.visibleTriangles.push_back(uint32_t(triangle));
    std::optional<std::vector<uint32_t>> lost;
    if (snappingMayExplain(m_frame->log, truth.facing)) lost.emplace(m_lost.begin(), m_lost.end());
    m_request.states =
        std::make_shared<const TriangleStates>(triangleStates(m_request.buffers->scene(), m_frame->log, truth.visible(), lost));
}

void TiledPicture::drawItems(Renderer& renderer, const PictureTile& tile) {
    const size_t pixels = size_t(m_request.size.width) * size_t(m_request.size.height);
    m_result.depth.resize(pixels);
    m_result.triangle.resize(pixels);
    const View viewing(m_request.viewing, m_request.size);
    const Renderer::ItemBuffer items = renderer.drawItemBuffer(*m_request.buffers, viewing, m_drawing->log(), tile);
    copyTile(forwardDistances(items.depth, viewing), tile, m_result.depth, m_request.size.width);
    copyTile(items.triangle, tile, m_result.triangle, m_request.size.width);
}

TiledPicture::Result TiledPicture::take() {
    m_result.states = m_drawing->states();
    m_drawing.reset();
    return std::move(m_result);
}

}  // namespace cullscope::ui
