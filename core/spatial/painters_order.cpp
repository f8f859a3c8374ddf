#include "core/spatial/painters_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>

#include "core/base/error.h"
#include "core/base/work_check.h"
#include "core/geometry/predicates.h"
#include "core/spatial/plane_extent.h"
#include "core/spatial/screen_polygon.h"

namespace cullscope {
namespace {

using Place = CutTriangles::Place;

class Painter {
public:
    Painter(CutTriangles& triangles, const Scene& scene, const View& view, const PaintersOptions& options,
            const Progress& progress)
        : m_triangles(triangles), m_scene(scene), m_view(view), m_options(options), m_work(progress), m_projection(view) {}

    PaintersOrder order() {
        requireRoom(0);
        const auto count = uint32_t(m_triangles.polygons().size());
        m_pieces.reserve(count);  // growing, a million pieces would be moved between two looks
        for (uint32_t polygon = 0; polygon < count; ++polygon) addPiece(polygon);
        m_result.polygons.reserve(count);
        if (m_options.byCentroid) {
            sortByCentroid();
        } else {
            m_grid.emplace(m_view.viewport(), m_pieces);
            std::vector<uint32_t> farFirst(m_pieces.size());
            std::iota(farFirst.begin(), farFirst.end(), 0u);
            std::ranges::stable_sort(farFirst, m_work.counting(std::greater<>()),
                                     [&](uint32_t i) { return m_pieces[i].screen.far; });
            for (const uint32_t piece : farFirst) {
                m_grid->add(piece, true, m_work);
                m_heap.push({m_pieces[piece].screen.far, m_pieces[piece].polygon, piece});
            }
            drawAll();
        }
        return std::move(m_result);
    }

private:
    /// A cut of a polygon: the plane, by its id, and the cut that the polygon was made by.
    struct Cut {
        uint32_t plane = 0, before = Piece::kUncut;
    };
    /// A piece that waits for others, and where the search for those goes on.
    struct Waiting {
        uint32_t piece = 0;
        uint64_t cuts = 0;  ///< at the begin of the search: after a cut it begins again
        int x = 0, y = 0;
        size_t place = 0;
    };
    struct FarFirst {
        double far;
        uint32_t polygon;
        uint32_t piece;
        /// Of equally far ones the highest number comes first, so that the lowest one is on top, as in the item buffer.
        bool operator<(const FarFirst& other) const { return far != other.far ? far < other.far : polygon < other.polygon; }
    };

    /// Adds a polygon to what is ordered, or draws it at once where it covers no sample.
    void addPiece(uint32_t polygon, uint32_t lastCut = Piece::kUncut) {
        m_work.step();
        const uint32_t triangle = m_triangles.polygons()[polygon].triangle;
        Piece piece;
        piece.polygon = polygon;
        piece.lastCut = lastCut;
        piece.plane = m_triangles.planeOf(triangle);
        piece.eyeSide = int8_t(sideOfPlane(piece.plane.a, piece.plane.b, piece.plane.c, m_view.eye()));
        const bool dropped = seesBack(triangle, piece.eyeSide);
        if (!dropped && piece.eyeSide != 0) {
            m_corners.clear();
            for (const CutTriangles::Corner& corner : m_triangles.cornersOf(polygon))
                m_corners.push_back(m_triangles.position(corner.vertex) - m_view.eye());
            piece.screen = m_projection.project(m_corners, piece.plane.normal);
        }
        if (piece.screen.points.empty()) {
            ++m_result.unordered;
            return drawNow(polygon, NewellStep::Cause::NoSamples);
        }
        m_pieces.push_back(std::move(piece));
    }

    /// Whether the eye sees a side that is not drawn.
    bool seesBack(uint32_t triangle, int eyeSide) {
        if (triangle < m_firstTriangle || triangle >= m_endTriangle) {
            const size_t instance = m_scene.instanceOf(triangle);
            m_firstTriangle = m_scene.firstTriangle(instance);
            m_endTriangle = m_firstTriangle + m_scene.meshOf(instance).triangleCount();
            m_mirrored = glm::determinant(Mat3(m_scene.instances()[instance].worldFromMesh)) < 0.0;
            m_dropsBacks = dropsBacks(m_scene, instance, m_options.facing);
        }
        return m_dropsBacks && eyeSide * (m_mirrored ? -1 : 1) < 0;
    }

    void sortByCentroid() {
        std::vector<std::pair<double, uint32_t>> order;
        for (uint32_t i = 0; i < m_pieces.size(); ++i) {
            m_work.step();
            Vec3 middle(0.0);
            const auto corners = m_triangles.cornersOf(m_pieces[i].polygon);
            for (const CutTriangles::Corner& corner : corners) middle += m_triangles.position(corner.vertex) - m_view.eye();
            order.emplace_back(glm::length(middle) / double(corners.size()), i);
        }
        std::ranges::sort(order, m_work.counting(std::greater<>()));
        for (const auto& [distance, piece] : order) drawNow(m_pieces[piece].polygon, NewellStep::Cause::ByCentroid, distance);
    }

    void drawAll() {
        while (!m_heap.empty()) {
            m_work.step();
            const uint32_t farthest = m_heap.top().piece;
            m_heap.pop();
            if (m_pieces[farthest].state != PieceState::Waiting) continue;
            tellTaken(NewellStep::Kind::Taken, farthest);
            mark(farthest);
            while (!m_waiting.empty()) advance();
        }
    }

    /// The next polygon of the order.
    void drawNow(uint32_t polygon, NewellStep::Cause cause, double distance = 0.0) {
        m_result.polygons.push_back(polygon);
        if (m_options.watch) m_options.watch({NewellStep::Kind::Drawn, {}, polygon, polygon, distance, 0.0, false, cause});
    }

    void tellTaken(NewellStep::Kind kind, uint32_t piece) {
        const uint32_t polygon = m_pieces[piece].polygon;
        if (watchesAll()) m_options.watch({kind, {}, polygon, polygon, m_pieces[piece].screen.far});
    }

    void mark(uint32_t piece) {
        m_inHand = piece;
        m_pieces[piece].state = PieceState::Marked;
        m_waiting.push_back(begun(piece));
    }

    [[nodiscard]] Waiting begun(uint32_t piece) const {
        const PieceGrid::Range range = m_grid->rangeOf(m_pieces[piece].screen);
        return {piece, m_triangles.cuts(), range.x0, range.y0, 0};
    }

    /// The search of the last piece on the stack: draws it, or goes on with one that has to be drawn before.
    void advance() {
        const uint32_t p = m_waiting.back().piece;
        if (p != std::exchange(m_inHand, p)) tellTaken(NewellStep::Kind::Again, p);
        const std::optional<uint32_t> before = nextBefore(m_waiting.back());
        if (!before) return drawLast();
        if (m_lastTest == NewellTest::Pierce) {
            if (!cutPiece(p, *before) && !cutPiece(*before, p)) giveUp();
        } else if (m_pieces[*before].state == PieceState::Marked) {
            breakCycle(*before);
        } else {
            mark(*before);
        }
    }

    /// The next piece that has to be drawn before one; none: it can be drawn.
    std::optional<uint32_t> nextBefore(Waiting& search) {
        if (search.cuts != m_triangles.cuts()) search = begun(search.piece);
        const PieceGrid::Range range = m_grid->rangeOf(m_pieces[search.piece].screen);
        for (; search.y <= range.y1; ++search.y, search.x = range.x0)
            for (; search.x <= range.x1; ++search.x, search.place = 0) {
                m_work.step();
                PieceGrid::Cell& cell = m_grid->cell(search.x, search.y);
                while (cell.begin < cell.pieces.size() && m_pieces[cell.pieces[cell.begin]].state == PieceState::Done) {
                    m_work.step();
                    ++cell.begin;
                }
                for (search.place = std::max(search.place, cell.begin); search.place < cell.pieces.size(); ++search.place) {
                    m_work.step();
                    const uint32_t q = cell.pieces[search.place];
                    if (q == search.piece || m_pieces[q].state == PieceState::Done) continue;
                    if (m_pieces[q].screen.far <= m_pieces[search.piece].screen.near) {
                        found(NewellTest::Depth, m_pieces[search.piece], m_pieces[q], m_pieces[search.piece].screen.near,
                              m_pieces[q].screen.far);
                        break;  // so are all after it
                    }
                    if (!m_grid->isFor(search.x, search.y, m_pieces[search.piece].screen, m_pieces[q].screen)) continue;
                    if (mayComeFirst(search.piece, q)) continue;
                    return q;
                }
            }
        return std::nullopt;
    }

    /// Whether P may be drawn before Q, by Newell's tests.
    bool mayComeFirst(uint32_t numberP, uint32_t numberQ) {
        const Piece &p = m_pieces[numberP], &q = m_pieces[numberQ];
        const auto passes = [&](bool passed, NewellTest test, double first, double second, bool byDepth = false) {
            if (passed)
                found(test, p, q, first, second, byDepth);
            else if (watchesAll())
                m_options.watch({NewellStep::Kind::Failed, test, p.polygon, q.polygon, first, second, byDepth});
            return passed;
        };
        (void)passes(false, NewellTest::Depth, p.screen.near, q.screen.far);
        const auto apart = [&](NewellTest test, double p0, double p1, double q0, double q1) {
            if (q0 >= p1) return passes(true, test, p1, q0);
            if (p0 >= q1) return passes(true, test, p0, q1);
            return passes(false, test, std::max(p0, q0), std::min(p1, q1));
        };
        if (apart(NewellTest::ExtentX, p.screen.x0, p.screen.x1, q.screen.x0, q.screen.x1)) return true;
        if (apart(NewellTest::ExtentY, p.screen.y0, p.screen.y1, q.screen.y0, q.screen.y1)) return true;
        const PlaneExtent pByQ = extentOf(p.polygon, m_triangles, q.plane), qByP = extentOf(q.polygon, m_triangles, p.plane);
        if (passes(!pByQ.on(q.eyeSide), NewellTest::BehindQ, pByQ.reach(q.eyeSide), pByQ.reach(-q.eyeSide))) return true;
        if (passes(!qByP.on(-p.eyeSide), NewellTest::BeforeP, qByP.reach(p.eyeSide), qByP.reach(-p.eyeSide))) return true;
        const Overlap overlap = overlapOf(p.screen, q.screen);
        if (passes(overlap.empty(), NewellTest::Projections, overlap.thickness, Overlap::kApart)) return true;
        const bool qFarther = !qByP.on(p.eyeSide) || !pByQ.on(-q.eyeSide);
        // Both planes cut the other polygon: what the overlap of the projections shows decides.
        const double least = overlap.leastBefore, most = overlap.mostBefore;
        if (!qFarther && passes(most <= 0.0, NewellTest::Projections, least, most, true)) return true;
        if (!qFarther && least < 0.0)
            found(NewellTest::Pierce, p, q, least, most, true);
        else
            found(q.state == PieceState::Marked ? NewellTest::Cycle : NewellTest::Swap, p, q, p.screen.far, q.screen.far);
        return false;
    }

    [[nodiscard]] bool watchesAll() const { return m_options.watch && !m_options.watchDrawnOnly; }

    void found(NewellTest test, const Piece& p, const Piece& q, double first, double second, bool byDepth = false) {
        m_lastTest = test;
        ++m_result.tests[size_t(test)];
        if (watchesAll()) m_options.watch({NewellStep::Kind::Compared, test, p.polygon, q.polygon, first, second, byDepth});
    }

    /// Cuts one of the pieces from the marked one to the end of the stack by the plane of another of them.
    void breakCycle(uint32_t marked) {
        size_t first = m_waiting.size();
        while (m_waiting[--first].piece != marked) {
        }
        // Neighbours on the stack come first.
        const size_t count = m_waiting.size() - first;
        for (size_t apart = 1; apart < count; ++apart)
            for (size_t i = count; i-- > 0;) {
                m_work.step();
                const uint32_t p = m_waiting[first + i].piece, q = m_waiting[first + (i + apart) % count].piece;
                if (cutPiece(p, q)) return;
            }
        giveUp();
    }

    /// Draws the last piece on the stack where rounding alone lets it wait.
    void giveUp() {
        ++m_result.unresolved;
        drawLast(NewellStep::Cause::GivenUp);
    }

    void drawLast(NewellStep::Cause cause = NewellStep::Cause::Free) {
        const uint32_t last = m_waiting.back().piece;
        m_pieces[last].state = PieceState::Done;
        drawNow(m_pieces[last].polygon, cause);
        m_waiting.pop_back();
    }

    /// Whether P is a part of what a plane has cut. Of a sliver whose corners are rounded it may lie across that plane again.
    bool isCutBy(uint32_t p, uint32_t plane) {
        for (uint32_t cut = m_pieces[p].lastCut; cut != Piece::kUncut; cut = m_cuts[cut].before) {
            m_work.step();
            if (m_cuts[cut].plane == plane) return true;
        }
        return false;
    }

    /// Cuts P by the plane of Q; false where that plane does not cut it, or has cut it. What waited for P begins again.
    bool cutPiece(uint32_t p, uint32_t q) {
        const CuttingPlane plane = m_pieces[q].plane;
        if (m_triangles.place(m_pieces[p].polygon, plane) != Place::Across || isCutBy(p, plane.id)) return false;
        requireRoom(1);
        const auto ownCut = uint32_t(m_cuts.size());
        m_cuts.push_back({plane.id, m_pieces[p].lastCut});
        const auto [front, back] = m_triangles.cut(m_pieces[p].polygon, plane);
        m_pieces[p].state = PieceState::Done;
        while (!m_waiting.empty()) {
            const uint32_t last = m_waiting.back().piece;
            m_waiting.pop_back();
            if (last == p) break;
            m_pieces[last].state = PieceState::Waiting;
            m_heap.push({m_pieces[last].screen.far, m_pieces[last].polygon, last});
        }
        for (const uint32_t part : {front, back}) {
            const auto number = uint32_t(m_pieces.size());
            addPiece(part, ownCut);
            if (m_pieces.size() == number) continue;
            m_grid->add(number, false, m_work);
            m_heap.push({m_pieces[number].screen.far, part, number});
        }
        return true;
    }

    /// For the polygons that there are and some more.
    void requireRoom(uint64_t more) const {
        if (m_triangles.polygons().size() - m_triangles.cuts() + more <= m_options.limit) return;
        // Before the first cut every way of sorting has too many polygons.
        if (m_triangles.cuts() == 0 && more == 0)
            throwUsage(CULLSCOPE_TR("The painter's order of \"%1\" needs more than %2 polygons: it has %3 triangles. Take fewer "
                                    "triangles, or a higher limit."),
                       {m_scene.name(), std::to_string(m_options.limit), std::to_string(m_scene.triangleCount())});
        throwUsage(CULLSCOPE_TR("The painter's order of \"%1\" needs more than %2 polygons: its %3 triangles were cut %4 times. "
                                "Take fewer triangles, sort=centroid, or a higher limit."),
                   {m_scene.name(), std::to_string(m_options.limit), std::to_string(m_scene.triangleCount()),
                    std::to_string(m_triangles.cuts())});
    }

    CutTriangles& m_triangles;
    const Scene& m_scene;
    const View& m_view;
    const PaintersOptions& m_options;
    WorkCheck m_work;
    ScreenProjection m_projection;
    std::vector<Vec3> m_corners;
    std::vector<Piece> m_pieces;
    std::optional<PieceGrid> m_grid;
    std::priority_queue<FarFirst> m_heap;
    std::vector<Waiting> m_waiting;
    std::vector<Cut> m_cuts;
    uint32_t m_inHand = 0;  ///< the piece that the last step was about, while some wait
    NewellTest m_lastTest = NewellTest::Depth;
    uint64_t m_firstTriangle = 0, m_endTriangle = 0;  ///< of the instance last asked about
    bool m_mirrored = false, m_dropsBacks = false;    ///< of that instance
    PaintersOrder m_result;
};

}  // namespace

PaintersOrder paintersOrder(CutTriangles& triangles, const Scene& scene, const View& view, const PaintersOptions& options,
                            const Progress& progress) {
    return Painter(triangles, scene, view, options, progress).order();
}

}  // namespace cullscope
