#include "core/spatial/bsp_tree.h"

#include <algorithm>
#include <deque>
#include <numeric>

#include "core/base/error.h"
#include "core/base/work_check.h"

namespace cullscope {
namespace {

constexpr uint32_t kGivenPlane = 0x80000000;  ///< numbers of planes that no triangle has

}  // namespace

/// Divides the polygons of one node after the other; a node's polygons are freed when it is divided.
class BspTree::Builder {
public:
    Builder(BspTree& tree, const Scene& scene, const BspOptions& options, const Progress& progress)
        : m_tree(tree), m_scene(scene), m_options(options), m_progress(progress), m_work(progress), m_cut(scene, progress) {
        requireRoom(0);
        if (options.plane != BspPlane::Given) return;
        if (scene.planes().empty())
            throwUsage(CULLSCOPE_TR("plane=given takes the planes that a scene has. \"%1\" has none: name them in a .polygons "
                                    "file, or take another choice of plane."),
                       {scene.name()});
        for (uint32_t i = 0; i < scene.planes().size(); ++i)
            m_given.push_back(givenPlane(scene.planes()[i].normal, scene.planes()[i].offset, kGivenPlane + i));
        // Empty cells are divided, too, so that the leaves have their places: 2ⁿ leaves and 2ⁿ − 1 nodes above them.
        if (m_given.size() >= 63 || (uint64_t{2} << m_given.size()) - 1 > options.limit) tooManyNodes();
    }

    void build() {
        std::vector<uint32_t> all(m_cut.polygons().size());
        std::iota(all.begin(), all.end(), 0u);
        if (!all.empty() || !m_given.empty()) append({BspTree::kNone, false, std::move(all)});
        while (!m_open.empty()) {
            m_work.step();
            Open open = std::move(m_open.front());
            m_open.pop_front();
            divide(std::move(open));
            if (m_tree.m_nodes.size() % 1024 == 0)
                m_progress.tell(double(m_settled) / double(m_settled + m_waiting + 1), CULLSCOPE_TR("Building the BSP tree"));
        }
        finish();
    }

private:
    struct Open {
        int32_t node;
        bool front;  ///< before it is numbered: the side of its parent
        std::vector<uint32_t> polygons;
    };

    /// Adds a node below another one.
    void append(Open child) {
        if (m_tree.m_nodes.size() >= m_options.limit) tooManyNodes();
        const auto number = int32_t(m_tree.m_nodes.size());
        Node node;
        node.parent = child.node;
        if (node.parent != BspTree::kNone) {
            Node& parent = m_tree.m_nodes[size_t(node.parent)];
            (child.front ? parent.front : parent.back) = number;
            node.depth = parent.depth + 1;
        }
        m_tree.m_depth = std::max(m_tree.m_depth, node.depth);
        m_tree.m_nodes.push_back(node);
        m_own.emplace_back();
        m_waiting += child.polygons.size();
        child.node = number;
        m_open.push_back(std::move(child));
    }

    void divide(Open open) {
        const size_t number = size_t(open.node);
        m_waiting -= open.polygons.size();
        const uint32_t level = m_tree.m_nodes[number].depth;
        const bool given = level < m_given.size();
        if (!m_given.empty() && !given && liesInOnePlane(open.polygons)) {
            m_tree.m_nodes[number].leaf = true;
            m_settled += open.polygons.size();
            m_own[number] = std::move(open.polygons);
            return;
        }
        const CuttingPlane plane = given ? m_given[level] : chosen(open.polygons);
        m_tree.m_nodes[number].plane = plane;
        std::vector<uint32_t> front, back, own;
        for (const uint32_t polygon : open.polygons) {
            m_work.step();
            // The polygon that the plane is of lies in it, whatever its parts' rounded corners say.
            if (m_cut.polygons()[polygon].triangle == plane.id) {
                own.push_back(polygon);
                continue;
            }
            switch (m_cut.place(polygon, plane)) {
                case CutTriangles::Place::On:
                    own.push_back(polygon);
                    break;
                case CutTriangles::Place::Front:
                    front.push_back(polygon);
                    break;
                case CutTriangles::Place::Back:
                    back.push_back(polygon);
                    break;
                case CutTriangles::Place::Across: {
                    requireRoom(1);
                    const auto [before, behind] = m_cut.cut(polygon, plane);
                    front.push_back(before);
                    back.push_back(behind);
                }
            }
        }
        m_settled += own.size();
        m_own[number] = std::move(own);
        if (given || !back.empty()) append({open.node, false, std::move(back)});
        if (given || !front.empty()) append({open.node, true, std::move(front)});
    }

    /// For the polygons that there are and some more.
    void requireRoom(uint64_t more) const {
        if (m_scene.triangleCount() + m_cut.cuts() + more <= m_options.limit) return;
        const std::string limit = std::to_string(m_options.limit), triangles = std::to_string(m_scene.triangleCount());
        if (more == 0)
            throwUsage(
                CULLSCOPE_TR("The BSP tree of \"%1\" needs more than %2 polygons: it has %3 triangles. Take fewer triangles, "
                             "or a higher limit."),
                {m_scene.name(), limit, triangles});
        const std::vector<std::string> found{m_scene.name(), limit, triangles, std::to_string(m_cut.cuts()),
                                             std::to_string(m_waiting)};
        // Below given planes the fewest cuts are chosen already.
        if (m_options.plane == BspPlane::Fewest || m_options.plane == BspPlane::Given)
            throwUsage(
                CULLSCOPE_TR("The BSP tree of \"%1\" needs more than %2 polygons: its %3 triangles were cut %4 times, and %5 "
                             "polygons are not divided yet. Take fewer triangles, or a higher limit."),
                found);
        throwUsage(CULLSCOPE_TR("The BSP tree of \"%1\" needs more than %2 polygons: its %3 triangles were cut %4 times, and %5 "
                                "polygons are not divided yet. Take fewer triangles, another choice of plane (plane=fewest), or "
                                "a higher limit."),
                   found);
    }

    [[noreturn]] void tooManyNodes() const {
        throwUsage(
            CULLSCOPE_TR("The BSP tree of \"%1\" needs more than %2 nodes: each of its %3 planes divides every cell of the "
                         "one before. Name fewer planes, or take a higher limit."),
            {m_scene.name(), std::to_string(m_options.limit), std::to_string(m_given.size())});
    }

    bool liesInOnePlane(const std::vector<uint32_t>& polygons) {
        if (polygons.size() < 2) return true;
        const CuttingPlane plane = m_cut.planeOf(m_cut.polygons()[polygons.front()].triangle);
        return std::all_of(polygons.begin() + 1, polygons.end(), [&](uint32_t polygon) {
            m_work.step();
            return m_cut.place(polygon, plane) == CutTriangles::Place::On;
        });
    }

    /// What a plane would do to a node's polygons, by a sample of them.
    struct Judgement {
        size_t front = 0, back = 0, across = 0;

        [[nodiscard]] std::pair<size_t, size_t> score(BspPlane by) const {
            const size_t larger = std::max(front, back) + across;
            return by == BspPlane::Balance ? std::pair(larger, across) : std::pair(across, larger);
        }
    };

    Judgement judge(const std::vector<uint32_t>& polygons, const CuttingPlane& plane) {
        Judgement result;
        const size_t step = (polygons.size() + BspTree::kJudged - 1) / BspTree::kJudged;
        for (size_t i = 0; i < polygons.size(); i += step) {
            m_work.step();
            if (m_cut.polygons()[polygons[i]].triangle == plane.id) continue;
            const CutTriangles::Place place = m_cut.place(polygons[i], plane);
            if (place == CutTriangles::Place::Front) ++result.front;
            if (place == CutTriangles::Place::Back) ++result.back;
            if (place == CutTriangles::Place::Across) ++result.across;
        }
        return result;
    }

    CuttingPlane chosen(const std::vector<uint32_t>& polygons) {
        const auto planeAt = [&](size_t place) { return m_cut.planeOf(m_cut.polygons()[polygons[place]].triangle); };
        if (m_options.plane == BspPlane::First || polygons.size() == 1) return planeAt(0);
        const BspPlane by = m_options.plane == BspPlane::Balance ? BspPlane::Balance : BspPlane::Fewest;
        const size_t candidates = std::min(polygons.size(), size_t(m_options.candidates));
        CuttingPlane best = planeAt(0);
        std::optional<std::pair<size_t, size_t>> bestScore;
        for (size_t i = 0; i < candidates; ++i) {
            const CuttingPlane plane = planeAt(i * polygons.size() / candidates);
            const auto score = judge(polygons, plane).score(by);
            if (bestScore && *bestScore <= score) continue;
            best = plane;
            bestScore = score;
        }
        return best;
    }

    void finish() {
        m_cut.finish(m_progress);
        m_tree.m_cuts = m_cut.cuts();
        const auto add = [&](uint32_t triangle, double share, const auto& draw) {
            const auto first = uint32_t(m_tree.m_drawn.triangles.size());
            draw();
            m_tree.m_parts.push_back({triangle, first, uint32_t(m_tree.m_drawn.triangles.size()) - first, share});
        };
        for (size_t number = 0; number < m_tree.m_nodes.size(); ++number) {
            m_work.step();
            Node& node = m_tree.m_nodes[number];
            // Mostly they come in ascending order.
            const auto triangleOf = [&](uint32_t polygon) { return m_cut.polygons()[polygon].triangle; };
            std::ranges::reverse(m_own[number]);
            if (!std::ranges::is_sorted(m_own[number], std::greater<>(), triangleOf))
                std::ranges::sort(m_own[number], m_work.counting(std::greater<>()), triangleOf);
            node.firstPart = uint32_t(m_tree.m_parts.size());
            node.partCount = node.polygons = uint32_t(m_own[number].size());
            for (const uint32_t polygon : m_own[number]) {
                m_work.step();
                add(m_cut.polygons()[polygon].triangle, m_cut.share(polygon), [&] { m_cut.draw(polygon, m_tree.m_drawn); });
                for (const CutTriangles::Corner& corner : m_cut.cornersOf(polygon)) node.box.add(m_cut.position(corner.vertex));
            }
        }
        m_tree.m_firstFlat = m_tree.m_parts.size();
        for (const uint32_t triangle : m_cut.flat()) {
            m_work.step();
            add(triangle, 1.0, [&] { m_cut.drawWhole(triangle, m_tree.m_drawn); });
        }
        for (size_t number = m_tree.m_nodes.size(); number-- > 1;) {
            const Node& node = m_tree.m_nodes[number];
            Node& parent = m_tree.m_nodes[size_t(node.parent)];
            parent.polygons += node.polygons;
            parent.box.add(node.box);
        }
    }

    BspTree& m_tree;
    const Scene& m_scene;
    const BspOptions& m_options;
    const Progress& m_progress;
    WorkCheck m_work;
    CutTriangles m_cut;
    std::vector<CuttingPlane> m_given;
    std::deque<Open> m_open;                   ///< nodes to be divided, level by level
    std::vector<std::vector<uint32_t>> m_own;  ///< by node: the polygons that it keeps
    size_t m_waiting = 0, m_settled = 0;       ///< polygons
};

BspTree::BspTree(const Scene& scene, const BspOptions& options, const Progress& progress) {
    Builder(*this, scene, options, progress).build();
}

int BspTree::sideOf(const Node& node, const Vec3& point) { return cullscope::sideOf(node.plane, point); }

uint64_t BspTree::bytes() const {
    return m_nodes.size() * sizeof(Node) + m_parts.size() * sizeof(Part) +
           m_drawn.triangles.size() * (6 * sizeof(Vec3f) + sizeof(uint32_t));
}

}  // namespace cullscope
