#include "core/frame/listing.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace cullscope {
namespace {

void addTo(ListingState& state, const Decision& decision) {
    if (decision.line == 0 || decision.line > state.decisions.size()) return;
    ++state.decisions[decision.line - 1];
    state.current = decision.line;
}

/// Which subjects of a frame's decisions contain one triangle.
class SubjectsAround {
public:
    SubjectsAround(const Scene& scene, const FrameLog& log, uint64_t triangle)
        : m_log(log), m_triangle(triangle), m_instance(uint32_t(scene.instanceOf(triangle))) {
        const uint32_t mesh = scene.instances()[m_instance].mesh;
        const uint64_t own = triangle - scene.firstTriangle(m_instance);
        while (m_place < scene.meshOf(m_instance).triangleCount() && triangleAt(log.order.get(), mesh, m_place) != own) ++m_place;
        m_subjects.push_back(Subject::ofObject(m_instance));
        for (const Decision& decision : log.decisions) follow(decision);
    }

    [[nodiscard]] bool has(const Subject& subject) const { return std::ranges::find(m_subjects, subject) != m_subjects.end(); }

private:
    /// Decisions about nodes are nested: the last nodes of smaller depth contain this subject.
    void follow(const Decision& decision) {
        m_open.resize(decision.nesting);
        if (contains(decision)) {
            for (const std::optional<Subject>& around : m_open)
                if (around && around->kind == Subject::Kind::Node) add(*around);
            add(decision.subject);
        }
        m_open.emplace_back(decision.subject);
    }

    void add(const Subject& subject) {
        if (!has(subject)) m_subjects.push_back(subject);
    }

    [[nodiscard]] bool contains(const Decision& decision) const {
        if (decision.subject.kind == Subject::Kind::Object) return decision.subject.number == m_instance;
        if (decision.subject.kind == Subject::Kind::Node)
            return std::ranges::find(m_log.objectsOf(decision), m_instance) != m_log.objectsOf(decision).end();
        if (decision.subject.kind == Subject::Kind::Fragment) return decision.subject.number == m_triangle;
        return decision.subject.holdsTriangles() && decision.subject.object == m_instance && m_place >= decision.places.first &&
               m_place - decision.places.first < decision.places.count;
    }

    const FrameLog& m_log;
    uint64_t m_triangle;
    uint32_t m_instance;
    uint64_t m_place = 0;                        ///< of the triangle, in the order FrameLog::order
    std::vector<std::optional<Subject>> m_open;  ///< by depth: the last subject; none: no decision was said about it
    std::vector<Subject> m_subjects;             ///< few: a path from a root to the triangle
};

}  // namespace

uint64_t ListingState::total() const { return std::accumulate(decisions.begin(), decisions.end(), uint64_t{0}); }

ListingState listingState(const FrameLog& log, size_t lines) {
    ListingState state{std::vector<uint64_t>(lines, 0), 0};
    for (const Decision& decision : log.decisions) addTo(state, decision);
    return state;
}

ListingState listingState(const Scene& scene, const FrameLog& log, size_t lines, uint64_t triangle) {
    ListingState state{std::vector<uint64_t>(lines, 0), 0};
    const SubjectsAround subjects(scene, log, triangle);
    for (const Decision& decision : log.decisions)
        if (subjects.has(decision.subject)) addTo(state, decision);
    return state;
}

}  // namespace cullscope
