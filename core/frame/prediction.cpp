#include "core/frame/prediction.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include "core/scene/eye_triangle.h"

namespace cullscope {
namespace {

/// Numbers items by when the frame first drew one of their triangles.
class FirstDrawn {
public:
    FirstDrawn(const Scene& scene, const Prediction& prediction, const Camera& camera)
        : m_scene(scene), m_prediction(prediction), m_camera(camera), m_named(prediction.items.begin(), prediction.items.end()) {}

    void operator()(const DrawList& list) {
        for (const DrawRange& range : list.ranges) {
            if (range.indexCount == 0) continue;
            if (m_prediction.of != Prediction::Items::Triangles) {
                add(range.instance);
                continue;
            }
            const uint32_t mesh = m_scene.instances()[range.instance].mesh;
            for (uint64_t place = range.firstIndex / 3; place < (range.firstIndex + range.indexCount) / 3; ++place)
                addTriangle(m_scene.firstTriangle(range.instance) + list.triangleAt(mesh, place), list.facing);
        }
    }
    void operator()(const OwnTrianglesPointer& own) {
        for (const uint32_t triangle : own->triangles) {
            if (m_prediction.of == Prediction::Items::Triangles)
                addTriangle(triangle, own->facing);
            else
                add(itemOf(triangle));
        }
    }
    void operator()(const FinishedPicturePointer& picture) {
        if (m_prediction.question == Prediction::Question::Order) return;
        for (const uint32_t item : picture->triangle)
            if (item != 0) addShown(item - 1);
    }
    void operator()(const AskedBoxes&) {}

    /// From 1; none: it was not drawn.
    [[nodiscard]] std::optional<size_t> placeOf(uint64_t item) const {
        const auto found = m_places.find(item);
        return found == m_places.end() ? std::nullopt : std::optional(found->second);
    }

private:
    [[nodiscard]] uint64_t itemOf(uint64_t triangle) const {
        return m_prediction.of == Prediction::Items::Triangles ? triangle : m_scene.instanceOf(triangle);
    }

    void addShown(uint64_t triangle) {
        if (m_prediction.of != Prediction::Items::Triangles || m_named.contains(triangle)) add(itemOf(triangle));
    }

    /// Of triangles, only the named ones are asked about. Of front sides alone, OpenGL drops a triangle whose back the eye sees.
    void addTriangle(uint64_t triangle, Facing facing) {
        if (!m_named.contains(triangle)) return;
        const size_t instance = m_scene.instanceOf(triangle);
        if (dropsBacks(m_scene, instance, facing) &&
            InstanceFromEye(m_scene, instance, m_camera).facesAway(triangle - m_scene.firstTriangle(instance)))
            return;
        add(triangle);
    }

    void add(uint64_t item) { m_places.try_emplace(item, m_places.size() + 1); }

    const Scene& m_scene;
    const Prediction& m_prediction;
    Camera m_camera;
    std::unordered_set<uint64_t> m_named;
    std::unordered_map<uint64_t, size_t> m_places;
};

/// The same of parts: each part's place in the order, from 1.
std::vector<size_t> orderOf(const NamedParts& parts) {
    std::vector<size_t> drawn(parts.parts.size()), order(parts.parts.size());
    std::iota(drawn.begin(), drawn.end(), size_t{0});
    std::ranges::sort(drawn, {}, [&](size_t part) { return parts.parts[part].drawn.front().first; });
    for (size_t i = 0; i < drawn.size(); ++i) order[drawn[i]] = i + 1;
    return order;
}

/// A part is a piece of what the frame drew: none of them vanishes.
std::vector<PredictionRow> answerOfParts(const Prediction& prediction, const NamedParts& parts) {
    const bool placed = prediction.question == Prediction::Question::Place;
    const std::vector<size_t> order = prediction.question == Prediction::Question::Order ? orderOf(parts) : std::vector<size_t>();
    std::vector<PredictionRow> rows;
    for (uint64_t part = 0; part < parts.parts.size(); ++part) {
        const auto found = std::ranges::find(prediction.items, part);
        const auto named = size_t(found - prediction.items.begin());
        const bool isNamed = found != prediction.items.end();
        if (placed && !isNamed) continue;
        PredictionRow row{part, isNamed ? 1 : 0, 0};
        if (placed) {
            row.expected = named < prediction.places.size() ? prediction.places[named] : std::nullopt;
            row.actual = parts.parts[part].place;
        } else if (prediction.question == Prediction::Question::Order) {
            row.expected = isNamed ? std::optional(named + 1) : std::nullopt;
            row.actual = order[part];
        }
        rows.push_back(row);
    }
    return rows;
}

}  // namespace

void Prediction::toggle(uint64_t item) {
    const auto found = std::ranges::find(items, item);
    places.resize(items.size());
    if (found != items.end()) {
        places.erase(places.begin() + (found - items.begin()));
        items.erase(found);
    } else {
        items.push_back(item);
        places.emplace_back();
    }
    if (question != Question::Place) places.clear();
}

void Prediction::toggle(std::span<const uint64_t> some) {
    const std::unordered_set<uint64_t> asked(some.begin(), some.end());
    std::unordered_set<uint64_t> named(items.begin(), items.end());
    const bool all = std::ranges::all_of(asked, [&](uint64_t item) { return named.contains(item); });
    if (!all) {
        for (const uint64_t item : some)
            if (named.insert(item).second) items.push_back(item);
        places.resize(question == Question::Place ? items.size() : 0);
        return;
    }
    places.resize(items.size());
    size_t kept = 0;
    for (size_t i = 0; i < items.size(); ++i) {
        if (asked.contains(items[i])) continue;
        items[kept] = items[i];
        places[kept++] = places[i];
    }
    items.resize(kept);
    places.resize(question == Question::Place ? kept : 0);
}

void Prediction::place(size_t place) {
    places.resize(items.size());
    if (!places.empty()) places.back() = place;
}

std::vector<PredictionRow> answerTo(const Prediction& prediction, const Scene& scene, const FrameLog& log,
                                    const NamedParts& parts) {
    if (prediction.of == Prediction::Items::Parts) return answerOfParts(prediction, parts);
    FirstDrawn drawn(scene, prediction, log.camera);
    for (const Command& command : log.commands) std::visit(drawn, command);
    std::vector<uint64_t> asked = prediction.items;
    if (prediction.of == Prediction::Items::Objects) {
        asked.clear();
        for (uint64_t instance = 0; instance < scene.instances().size(); ++instance)
            if (scene.meshOf(instance).triangleCount() > 0) asked.push_back(instance);
    }
    std::unordered_map<uint64_t, size_t> named;  // by item: its place among the named ones
    for (size_t i = 0; i < prediction.items.size(); ++i) named.try_emplace(prediction.items[i], i);
    std::vector<PredictionRow> rows;
    for (const uint64_t item : asked) {
        const auto found = named.find(item);
        const bool isNamed = found != named.end();
        const std::optional<size_t> place = drawn.placeOf(item);
        PredictionRow row{item, isNamed ? 1 : 0, place ? 0 : 1};
        if (prediction.question == Prediction::Question::Order) {
            row.actual = place;
            row.expected = isNamed ? std::optional(found->second + 1) : std::nullopt;
        }
        rows.push_back(row);
    }
    return rows;
}

size_t rightRows(const std::vector<PredictionRow>& rows) { return size_t(std::ranges::count_if(rows, &PredictionRow::right)); }

}  // namespace cullscope
