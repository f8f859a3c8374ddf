#include "core/visibility/spherical/map_shows.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "core/gpu/colour.h"
#include "core/visibility/registry.h"
#include "core/visibility/spherical/band_curve.h"
#include "core/visibility/spherical/index_map.h"
#include "core/visibility/spherical/map_overlays.h"
#include "core/visibility/spherical/map_values.h"
#include "core/visibility/spherical/recorded_decisions.h"
#include "core/visibility/spherical/why.h"

namespace cullscope::spherical {
namespace {

constexpr const char* kBands = "bands";
constexpr const char* kSizes = "sizes";
constexpr const char* kBandCurve = "band-sizes";
constexpr const char* kKernel = "kernel";
constexpr const char* kIndexMap = "index-map";

Message noBands(const std::string& option, const std::string& strategy, const std::string& having) {
    return {"%1: the strategy \"%2\" has no contour bands. Strategies that have them: %3.", {option, strategy, having}};
}

Message noCells(const std::string& option, const std::string& strategy, const std::string& having) {
    return {"%1: the strategy \"%2\" has no quadtree and no inner kernel. Strategies that have them: %3.",
            {option, strategy, having}};
}

Message noMap(const std::string& option, const std::string& strategy, const std::string& having) {
    return {"%1: the strategy \"%2\" has no index map. Strategies that have one: %3.", {option, strategy, having}};
}

Show boxesShow(bool region) {
    Show show;
    show.kind = Show::Kind::Boxes;
    show.id = kBoxesShow;
    show.help = "bounding spheres, visible region and corner rays of spherical strategies, judged cells of spherical-lossless";
    show.meanings = {{CULLSCOPE_TR("bounding sphere"), sphereColour}};
    if (region) {
        show.meanings.push_back({CULLSCOPE_TR("visible region"), regionColour});
        show.meanings.push_back({CULLSCOPE_TR("corner ray"), contrastTo});
    }
    return show;
}

Show bandsShow() {
    Show show;
    show.id = kBands;
    show.help = "contour bands of spherical strategies";
    show.title = CULLSCOPE_TR("Contour bands");
    show.action = CULLSCOPE_TR("&Contour bands");
    show.explanation =
        CULLSCOPE_TR("Show the contour bands of spherical strategies on the objects' bounding spheres in the active view");
    show.legend = {TriangleState::Visible, TriangleState::Hidden};
    show.absent = noBands;
    return show;
}

Show sizesShow(bool slopes) {
    Show show;
    show.id = kSizes;
    show.help = "S of the contour bands in one sector, each at the surface that it is measured at";
    show.title = CULLSCOPE_TR("S of the contour bands");
    show.action = CULLSCOPE_TR("S of the contour ba&nds");
    show.explanation = CULLSCOPE_TR(
        "Show S of each contour band of one sector in the active view: a line from the axis to the surface that it is measured "
        "at, dashed where the band is hidden");
    const char* const size = CULLSCOPE_TR("S of a contour band");
    const char* const slope = CULLSCOPE_TR("height of the sight line with a band's slope");
    show.meanings = {{slopes ? slope : size, sizeColour}};
    show.absent = noBands;
    return show;
}

Show bandCurveShow() {
    Show show;
    show.kind = Show::Kind::Curve;
    show.id = kBandCurve;
    show.help = "sizes of the contour bands over the angle from the axis to the eye";
    show.title = CULLSCOPE_TR("Bands");
    return show;
}

Show kernelShow() {
    Show show;
    show.id = kKernel;
    show.help = "of spherical-lossless: what is filled of a solid around its centre, with the horizon that the eye sees of it";
    show.title = CULLSCOPE_TR("Inner kernel and horizon");
    show.action = CULLSCOPE_TR("Inner &kernel and horizon");
    show.explanation = CULLSCOPE_TR(
        "Show the solid's inner kernel in the active view, and its outline as the culling camera sees it: what lies "
        "behind it is left out by the lossless spherical strategy");
    show.meanings = {{CULLSCOPE_TR("horizon of the kernel"), regionColour}};
    show.absent = noCells;
    return show;
}

Show indexMapShow(bool cells) {
    Show show;
    show.kind = Show::Kind::DirectionMap;
    show.id = kIndexMap;
    show.help = "of spherical strategies, of the first object in the frustum";
    show.title = CULLSCOPE_TR("index map");
    show.absent = noMap;
    for (const MapQuantity quantity : {MapQuantity::Entries, MapQuantity::Radius, MapQuantity::State})
        show.colourings.push_back({mapQuantityId(quantity)});
    if (cells)
        for (const MapQuantity quantity : {MapQuantity::Level, MapQuantity::Kernel})
            show.colourings.push_back({mapQuantityId(quantity), noCells});
    show.colouringHelp =
        "of the index map: entries (triangles by cell, the default), radius, state, or of spherical-lossless level (of the "
        "judged "
        "cells) or kernel (its radius)";
    return show;
}

const MapSnapshot& shownOf(const std::vector<MapSnapshot>& maps) { return maps[placeOfMap(maps, std::nullopt)]; }

std::string nameOf(const MapSnapshot& map, const Scene& scene) { return scene.instances()[map.decision.instance].name; }

/// Why no object has contour bands.
Message bandsMissing(const MapSnapshot& shown, const std::string& option, const Scene& scene) {
    return {
        "%1: the object \"%2\" is %3, and only one inside the frustum has contour bands. Choose an eye farther away or a larger "
        "--fovy; for what the frustum cuts there are --overlay boxes and --overlay index-map.",
        {option, nameOf(shown, scene), relationName(shown.decision.relation)}};
}

/// Why an object has no kernel; none where it has one.
std::optional<Message> kernelMissing(const MapSnapshot& map, const std::string& option, const Scene& scene) {
    if (!map.kernel)
        return Message{
            "%1: no inner kernel was made for the object \"%2\", because the parameter horizon is off or the mesh has too "
            "few triangles for it to pay. Choose horizon=true, or a larger mesh.",
            {option, nameOf(map, scene)}};
    if (!map.kernel->filled())
        return Message{"%1: the object \"%2\" has no inner kernel: %3. Leave it out, or choose another scene.",
                       {option, nameOf(map, scene), InnerKernel::stateName(map.kernel->state())}};
    return std::nullopt;
}

/// The tests of a walk over an object's cells, and how many triangles each of them culled.
std::string walkLine(const CellWalk& walk) {
    const auto culled = [&](Cause cause) { return std::to_string(walk.culled[size_t(cause)]) + " " + causeName(cause); };
    return std::to_string(walk.nodesVisited) + " nodes visited; planes: " + culled(Cause::OutsideFrustum) +
           "; cones: " + (walk.cones ? culled(Cause::BackFacing) : "not used") +
           "; horizon: " + (walk.hiding ? culled(Cause::Hidden) : "not used");
}

}  // namespace

std::vector<Show> showsOfBands(bool slopes) {
    return {treeShow(), boxesShow(true), bandsShow(), sizesShow(slopes), bandCurveShow(), indexMapShow(false)};
}
std::vector<Show> showsOfCells() { return {treeShow(), boxesShow(false), kernelShow(), indexMapShow(true)}; }

std::vector<OverlayLines> mapOverlay(std::string_view id, const OverlayContext& context, const StructureSnapshot& snapshot) {
    const std::vector<MapSnapshot>& maps = mapsOf(snapshot);
    if (id == kBands) return bandOverlay(context, maps);
    if (id == kSizes) return sizeOverlay(context, maps);
    if (id == kKernel) return kernelOverlay(context, maps);
    if (id != kBoxesShow) return {};
    std::vector<OverlayLines> overlays{groupOverlay(context, snapshot)};
    std::ranges::move(sphereOverlay(context, maps), std::back_inserter(overlays));
    return overlays;
}

std::optional<Message> whyNoMapShow(std::string_view id, std::string_view colouring, std::string_view strategy,
                                    const StructureSnapshot& snapshot, const Scene& scene) {
    if (id == kBoxesShow) return std::nullopt;
    const std::vector<MapSnapshot>& maps = mapsOf(snapshot);
    const std::string option = commandLineOption(id);
    if (maps.empty()) {
        const AbsentShow absent = id == kBands || id == kSizes ? noBands : id == kKernel ? noCells : noMap;
        return absent(option, std::string(strategy), strategiesShowing(id));
    }
    const MapSnapshot& shown = shownOf(maps);
    if (id == kBands || id == kSizes) {
        if (std::ranges::any_of(maps, [](const MapSnapshot& map) { return map.decision.bands.has_value(); })) return std::nullopt;
        return bandsMissing(shown, option, scene);
    }
    if (id == kKernel) {
        if (std::ranges::any_of(maps, hasKernel)) return std::nullopt;
        if (auto missing = kernelMissing(shown, option, scene)) return missing;
        return Message{"%1: the object \"%2\" is %3, so that its inner kernel is not shown. Choose another eye or target.",
                       {option, nameOf(shown, scene), relationName(shown.decision.relation)}};
    }
    const bool needsKernel = id == kIndexMap && colouring == mapQuantityId(MapQuantity::Kernel) && shown.tree;
    return needsKernel ? kernelMissing(shown, commandLineOption(id, colouring), scene) : std::nullopt;
}

std::optional<SphericalDecision> shownDecision(const FrameLog& log, const std::optional<uint32_t>& object) {
    std::vector<SphericalDecision> decisions = decisionsOf(log);
    if (decisions.empty()) return std::nullopt;
    return std::move(decisions[placeOfDecision(decisions, object)]);
}

CellMapPointer indexMapOf(MapSnapshot map, const Scene& scene) {
    const std::string name = nameOf(map, scene);
    return indexMap(std::move(map), name, scene.instances().size());
}

Curve curveOf(const SphericalDecision& decision, const Scene& scene, const std::optional<uint32_t>& part) {
    return bandCurve(decision, scene.instances()[decision.instance].name, part);
}

std::string mapLine(const StructureSnapshot& snapshot, const Scene& scene) {
    if (mapsOf(snapshot).empty()) return {};
    const MapSnapshot& map = shownOf(mapsOf(snapshot));
    const SphericalDecision& decision = map.decision;
    std::string text = "the bounding sphere of \"" + nameOf(map, scene) + "\" is " + relationName(decision.relation);
    if (decision.region) text += ", case " + std::to_string(decision.region->caseNumber);
    if (decision.walk) text += "; " + walkLine(*decision.walk);
    return text;
}

void addMapStepsOf(const StructureSnapshot& snapshot, const FrameLog& log, uint32_t instance, uint32_t triangle,
                   std::vector<WhyStep>& steps) {
    if (const MapSnapshot* map = mapOf(snapshot, instance)) addMapSteps(*map, log, triangle, steps);
}

}  // namespace cullscope::spherical
