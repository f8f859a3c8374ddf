#include <array>
#include <map>

#include "core/spatial/bsp_cells.h"
#include "core/visibility/displaced_surfaces.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"
#include "core/visibility/ordering/bsp_walk.h"
#include "core/visibility/ordering/named_subjects.h"
#include "core/visibility/ordering/ordering.h"
#include "core/visibility/overlay.h"
#include "core/visibility/plane_colours.h"
#include "core/visibility/subject_shape.h"
#include "core/visibility/why.h"

namespace cullscope::ordering {
namespace {

constexpr const char* kPlanes = "bsp-planes";
constexpr const char* kSides = "bsp-sides";
/// Values of `plane`, in the order of BspPlane.
constexpr std::array<std::string_view, 4> kPlaneChoices{"first", "fewest", "balance", "given"};
/// The first nodes whose planes the overlay draws; deeper cells are too small to tell apart.
constexpr uint32_t kPlanesShown = 60;

struct TreeOfScene : Structure {
    using Structure::Structure;
    std::optional<BspTree> tree;
    size_t planes = 0;  ///< levels of given planes
};

BspOptions optionsOf(const ParameterSet& parameters) {
    BspOptions options;
    options.plane = BspPlane(std::ranges::find(kPlaneChoices, parameters.choice("plane")) - kPlaneChoices.begin());
    options.candidates = int(parameters.integer("candidates"));
    options.limit = uint64_t(parameters.integer("limit"));
    return options;
}

/// Of splitting planes, by the side that the eye is on.
Vec3f colourBefore(const Vec3f& background) { return planePalette(background)[0]; }
Vec3f colourBehind(const Vec3f& background) { return planePalette(background)[1]; }

class Bsp final : public StrategyWith<TreeOfScene> {
public:
    [[nodiscard]] std::vector<OverlayLines> overlay(std::string_view /*id*/, const OverlayContext& context,
                                                    const Structure& structure, const FrameLog& log) const override {
        OverlayLines lines;
        lines.cased = true;
        const BspTree& tree = *own(structure).tree;
        for (uint32_t number = 0; number < std::min<size_t>(tree.nodes().size(), kPlanesShown); ++number) {
            const BspTree::Node& node = tree.nodes()[number];
            const std::vector<Vec3> polygon = planeInCell(tree, number, context.scene.bounds());
            // The side that the eye is on decides the colour, the depth in the tree how strong it is.
            const Vec3f side = BspTree::sideOf(node, log.camera.eye) >= 0 ? colourBefore(context.style.background)
                                                                          : colourBehind(context.style.background);
            const float weight = 1.0f / float(1 + node.depth / 2);
            const Vec3f colour = side * weight + context.contrast * (1.0f - weight) * 0.5f;
            for (size_t i = 0; i < polygon.size(); ++i)
                lines.lines.push_back({polygon[i], polygon[(i + 1) % polygon.size()], colour});
        }
        return {std::move(lines)};
    }

    [[nodiscard]] Bars bars(std::string_view /*id*/, const Structure& /*structure*/, const FrameLog& log) const override {
        std::map<Containment, uint64_t> counts;
        for (const Decision& decision : log.decisions)
            if (decision.line == uint8_t(BspLine::Side)) ++counts[decision.containment];
        return {{},
                {{CULLSCOPE_TR("the eye is before the plane"), counts[Containment::Inside]},
                 {CULLSCOPE_TR("the eye is behind the plane"), counts[Containment::Outside]},
                 {CULLSCOPE_TR("the eye is in the plane"), counts[Containment::Straddles]}}};
    }

    void addWhySteps(const Structure& structure, const FrameLog& /*log*/, uint32_t instance, uint32_t triangle,
                     std::vector<WhyStep>& steps) const override {
        const uint64_t number = structure.scene().firstTriangle(instance) + triangle;
        const auto parts = std::ranges::count(own(structure).tree->parts(), number, &BspTree::Part::triangle);
        const char* sentence = parts > 1
                                   ? CULLSCOPE_TR("The tree has the triangle in %1 parts, each drawn where the walk comes to it.")
                                   : CULLSCOPE_TR("The tree has the triangle as a whole, drawn where the walk comes to it.");
        steps.push_back({{sentence, {std::to_string(parts)}}, {}, {}, {}, Containment::Straddles});
    }

    /// Its plane within its cell, its own polygons, and the box of all below it.
    [[nodiscard]] SubjectShape groupShape(const Structure& structure, const StructureSnapshot& /*snapshot*/,
                                          uint32_t number) const override {
        const BspTree& tree = *own(structure).tree;
        const BspTree::Node& node = tree.nodes()[number];
        SubjectShape shape;
        shape.node = number;
        if (!node.box.empty()) shape.boxes.push_back(node.box);
        if (!node.leaf) shape.polygons.push_back(planeInCell(tree, number, structure.scene().bounds()));
        for (const BspTree::Part& part : tree.partsOf(node))
            for (const auto& corners : trianglesOf(tree, part, structure.scene()))
                if (shape.triangles.size() < SubjectShape::kMostTriangles) shape.triangles.push_back(corners);
        return shape;
    }

    [[nodiscard]] std::optional<uint32_t> groupAt(const Structure& structure, uint64_t triangle,
                                                  const Vec3& point) const override {
        const BspTree& tree = *own(structure).tree;
        std::optional<uint32_t> node = nodeAt(tree, structure.scene(), triangle, point);
        while (node && *node >= kRecordedNodes) node = uint32_t(tree.nodes()[*node].parent);
        return node;
    }

    [[nodiscard]] NamedParts parts(const Structure& structure, const FrameLog& log) const override {
        return own(structure).planes > 0 ? partsByLeaf(structure, log) : namedParts(structure.scene(), log);
    }
    [[nodiscard]] NamedParts partsByLeaf(const Structure& structure, const FrameLog& log) const override {
        return partsInCells(structure.scene(), log, *own(structure).tree, own(structure).planes, kNodeOfFragment);
    }

    [[nodiscard]] Promise promiseAt(const Structure& structure, const ParameterSet& parameters, Facing facing,
                                    const View& view) const override {
        return promiseWhereSurfacesStandStill(promise(structure, parameters, facing), structure.scene(), view);
    }

protected:
    void fill(TreeOfScene& structure, const ParameterSet& parameters, const Progress& progress) const override {
        const BspOptions options = optionsOf(parameters);
        structure.planes = options.plane == BspPlane::Given ? structure.scene().planes().size() : 0;
        structure.tree.emplace(structure.scene(), options, progress);
        const BspTree& tree = *structure.tree;
        structure.report.bytes = tree.bytes();
        structure.report.figures = {{"nodes", double(tree.nodes().size())},
                                    {"depth", double(tree.depth())},
                                    {"fragments", double(tree.parts().size())},
                                    {"cuts", double(tree.cuts())}};
    }

    void decide(FrameContext& frame, const TreeOfScene& structure, ViewState& /*state*/,
                const ParameterSet& parameters) const override {
        OwnTrianglesPointer own;
        {
            const StageTimer stage(frame, CULLSCOPE_TR("walking the tree"));
            sayBegin(frame, uint8_t(BspLine::Start), CULLSCOPE_TR("The walk starts at the root: %1 nodes, %2 polygons."),
                     {double(structure.tree->nodes().size()), double(structure.tree->parts().size())});
            own = walkOfFrame(frame, *structure.tree, parameters.choice("order") == "front-to-back");
            if (frame.recording()) sayObjectsAreDrawn(frame);
            frame.counters().bytesTouched = structure.tree->bytes();
            frame.counters().figures = {{"fragments", double(structure.tree->parts().size())}};
        }
        if (!own->triangles.empty()) frame.draw(std::move(own));
    }

    [[nodiscard]] Promise promiseOf(const TreeOfScene& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Conservative;
    }

    /// The tree that the panel "Tree" shows: a box around what each node has below it.
    [[nodiscard]] StructureSnapshot snapshotOf(const TreeOfScene& structure, const FrameLog& log) const override {
        StructureSnapshot snapshot;
        const NamedParts named = NamedSubjects::namesPartsOf(log) ? parts(structure, log) : NamedParts();
        snapshot.places = std::make_shared<NamedSubjects>(structure.scene(), log, named, roleInBspWalk);
        const BspTree& tree = *structure.tree;
        const BspCells cells = cellsOf(tree, structure.planes);
        snapshot.groupName = CULLSCOPE_TR("%1: %2 polygons");
        for (uint32_t number = 0; number < std::min<size_t>(tree.nodes().size(), kRecordedNodes); ++number) {
            const BspTree::Node& from = tree.nodes()[number];
            SnapshotNode node;
            node.parent = from.parent;
            node.instance = SnapshotNode::kGroup;
            node.number = number;
            node.name = nodeName(tree, cells, structure.scene(), number);
            node.objects = from.polygons;
            node.box = from.box.empty() ? Box3{Vec3(0.0), Vec3(0.0)} : from.box;
            node.triangles = from.polygons;
            snapshot.nodes.push_back(node);
        }
        return snapshot;
    }
};

Message noPlanes(const std::string& option, const std::string& strategy, const std::string& having) {
    return {"%1: the strategy \"%2\" has no splitting planes. Having them: %3.", {option, strategy, having}};
}

Show splittingPlanes() {
    Show show;
    show.id = kPlanes;
    show.help = "of bsp: the first splitting planes, each within its cell and the scene's box";
    show.title = CULLSCOPE_TR("Splitting planes");
    show.action = CULLSCOPE_TR("&Splitting planes");
    show.explanation = CULLSCOPE_TR("Show in the active view the first planes of the BSP tree, each within its cell");
    show.meanings = {{CULLSCOPE_TR("plane that the eye is before"), colourBefore},
                     {CULLSCOPE_TR("plane that the eye is behind"), colourBehind}};
    show.absent = noPlanes;
    return show;
}

Show bspListing() {
    return listingShow({{CULLSCOPE_TR("node = root"), 0},
                        {CULLSCOPE_TR("s = side of node's plane that V is on"), 0},
                        {CULLSCOPE_TR("go on with the child drawn first"), 1},
                        {CULLSCOPE_TR("draw what lies in the plane"), 1},
                        {CULLSCOPE_TR("go on with the child drawn last"), 1}});
}

std::vector<ParameterDeclaration> bspParameters() {
    const auto number = [](const char* key, int64_t value, double most, const char* sentence) {
        return readWhenBuilding({key, ParameterType::Integer, value, 1.0, most, "", sentence, {}});
    };
    return {
        facingParameter(),
        choiceParameter("order", "back-to-front", CULLSCOPE_TR("In which order the tree is walked."),
                        {{"back-to-front", CULLSCOPE_TR("far to near, without depth test")},
                         {"front-to-back", CULLSCOPE_TR("near to far, with depth test")}}),
        readWhenBuilding(choiceParameter("plane", "balance", CULLSCOPE_TR("Which plane divides the polygons of a node."),
                                         {{"first", CULLSCOPE_TR("that of its first polygon")},
                                          {"fewest", CULLSCOPE_TR("of some candidates the one that cuts the fewest polygons")},
                                          {"balance", CULLSCOPE_TR("of some candidates the one that divides them best")},
                                          {"given", CULLSCOPE_TR("the planes that the scene names, one for each level")}})),
        number("candidates", 8, 1000.0, CULLSCOPE_TR("How many planes are tried at a node (plane=fewest and balance).")),
        number("limit", 1'000'000, 1e8,
               CULLSCOPE_TR("How many polygons the tree may have, the cut ones among them, and how many nodes."))};
}

}  // namespace

RegisteredStrategy bsp() {
    StrategyInfo info{"bsp", CULLSCOPE_TR("BSP tree"),
                      CULLSCOPE_TR("Draws all triangles in the order of a BSP tree, cut where its planes pass through them."),
                      "Fuchs, Kedem & Naylor 1980", bspParameters()};
    info.needsEyePoint = true;
    info.shows = {treeShow(), splittingPlanes(), bspListing(), barsShow(kSides, CULLSCOPE_TR("Nodes by the eye's side"))};
    return {std::move(info), std::make_shared<Bsp>()};
}

}  // namespace cullscope::ordering
