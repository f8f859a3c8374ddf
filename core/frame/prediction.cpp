#include "core/frame/prediction.h"

#include <algorithm>
#include <map>

namespace cullscope {
namespace {

/// Numbers items by when the frame first drew one of their triangles.
class FirstDrawn {
public:
    FirstDrawn(const Scene& scene, const Prediction& prediction) : m_scene(scene), m_prediction(prediction) {}

    void operator()(const DrawList& list) {
        for (const DrawRange& range : list.ranges) {
            if (range.indexCount == 0) continue;
            if (!m_prediction.ofTriangles) {
                add(range.instance);
                continue;
            }
            const uint32_t mesh = m_scene.instances()[range.instance].mesh;
            for (uint64_t place = range.firstIndex / 3; place < (range.firstIndex + range.indexCount) / 3; ++place)
                add(m_scene.firstTriangle(range.instance) + list.triangleAt(mesh, place));
        }
    }
    void operator()(const OwnTrianglesPointer& own) {
        for (const uint32_t triangle : own->triangles) add(m_prediction.ofTriangles ? triangle : m_scene.instanceOf(triangle));
    }
    void operator()(const FinishedPicturePointer& picture) {
        if (m_prediction.question == Prediction::Question::Order) return;
        for (const uint32_t item : picture->triangle)
            if (item != 0) add(m_prediction.ofTriangles ? item - 1 : m_scene.instanceOf(item - 1));
    }
    void operator()(const AskedBoxes&) {}

    /// From 1; none: it was not drawn.
    [[nodiscard]] std::optional<size_t> placeOf(uint64_t item) const {
        const auto found = m_places.find(item);
        return found == m_places.end() ? std::nullopt : std::optional(found->second);
    }

private:
    void add(uint64_t item) {
        // Of triangles, only the named ones are asked about.
        if (m_prediction.ofTriangles && std::ranges::find(m_prediction.items, item) == m_prediction.items.end()) return;
        m_places.try_emplace(item, m_places.size() + 1);
    }

    const Scene& m_scene;
    const Prediction& m_prediction;
    std::map<uint64_t, size_t> m_places;
};

}  // namespace

void Prediction::toggle(uint64_t item) {
    if (std::erase(items, item) == 0) items.push_back(item);
}

std::vector<PredictionRow> answerTo(const Prediction& prediction, const Scene& scene, const FrameLog& log) {
    FirstDrawn drawn(scene, prediction);
    for (const Command& command : log.commands) std::visit(drawn, command);
    std::vector<uint64_t> asked = prediction.items;
    if (!prediction.ofTriangles) {
        asked.clear();
        for (uint64_t instance = 0; instance < scene.instances().size(); ++instance)
            if (scene.meshOf(instance).triangleCount() > 0) asked.push_back(instance);
    }
    std::vector<PredictionRow> rows;
    for (const uint64_t item : asked) {
        const auto named = std::ranges::find(prediction.items, item);
        const bool isNamed = named != prediction.items.end();
        const std::optional<size_t> place = drawn.placeOf(item);
        PredictionRow row{item, isNamed ? 1 : 0, place ? 0 : 1};
        if (prediction.question == Prediction::Question::Order) {
            row.actual = place;
            row.expected = isNamed ? std::optional(size_t(named - prediction.items.begin()) + 1) : std::nullopt;
        }
        rows.push_back(row);
    }
    return rows;
}

size_t rightRows(const std::vector<PredictionRow>& rows) { return size_t(std::ranges::count_if(rows, &PredictionRow::right)); }

}  // namespace cullscope
