#include "app/cullbench/overlays.h"

#include <algorithm>

#include "app/cullbench/commands.h"
#include "core/base/error.h"
#include "core/image/overlays.h"

namespace cullscope::cullbench {
namespace {

constexpr const char* kOverlays = "verdicts, boxes, frustum, bands, kernel, index-map, spherical-model";
constexpr const char* kStrategiesWithMaps = "spherical, spherical-horizon, spherical-lossless";
constexpr const char* kStrategiesWithBands = "spherical, spherical-horizon";
constexpr const char* kStrategiesWithCells = "spherical-lossless";

/// Adds one overlay; false: there is none of that name.
bool add(const std::string& name, OverlayChoice& choice) {
    if (name == "verdicts")
        choice.look.colouring = Colouring::Verdicts;
    else if (name == "boxes")
        choice.look.boxes = true;
    else if (name == "frustum")
        choice.look.frustum = true;
    else if (name == "bands")
        choice.look.bands = true;
    else if (name == "kernel")
        choice.look.kernel = true;
    else if (name == "spherical-model")
        choice.look.sphericalModel = true;
    else if (name == "index-map")
        choice.map = MapColouring::Entries;
    else
        return false;
    return true;
}

/// What stands in place of the scene stands alone.
void requireAlone(const OverlayChoice& choice, const std::vector<std::string>& names) {
    if (!choice.replacesScene()) return;
    const std::string alone = choice.map ? "index-map" : "spherical-model";
    for (const std::string& name : names)
        if (name != alone)
            throwUsage(CULLSCOPE_TR("--overlay %1 stands in place of the scene's picture: give it without --overlay %2."),
                       {alone, name});
}

void requireBands(const std::string& strategy, const StructureSnapshot& snapshot, const Scene& scene) {
    if (snapshot.maps.empty() || snapshot.maps.front().tree)
        throwUsage(CULLSCOPE_TR("--overlay bands: the strategy \"%1\" has no contour bands. Strategies that have them: %2."),
                   {strategy, kStrategiesWithBands});
    for (const MapSnapshot& map : snapshot.maps)
        if (map.decision.bands) return;
    const SphericalDecision& decision = shownMap(snapshot)->decision;
    throwUsage(
        CULLSCOPE_TR("--overlay bands: the object \"%1\" is %2, and only one inside the frustum has contour bands. Choose an "
                     "eye farther away or a larger --fovy; for what the frustum cuts there are --overlay boxes and "
                     "--overlay index-map."),
        {scene.instances()[decision.instance].name, relationName(decision.relation)});
}

/// Says why an object has no kernel; nothing where it has one.
void requireKernelOf(const MapSnapshot& map, const std::string& option, const Scene& scene) {
    const std::string& name = scene.instances()[map.decision.instance].name;
    if (!map.kernel)
        throwUsage(CULLSCOPE_TR("%1: no inner kernel was made for the object \"%2\", because the parameter horizon is off or the "
                                "mesh has too few triangles for it to pay. Choose horizon=true, or a larger mesh."),
                   {option, name});
    if (!map.kernel->filled())
        throwUsage(CULLSCOPE_TR("%1: the object \"%2\" has no inner kernel: %3. Leave it out, or choose another scene."),
                   {option, name, InnerKernel::stateName(map.kernel->state())});
}

void requireKernel(const std::string& strategy, const StructureSnapshot& snapshot, const Scene& scene) {
    const std::string option = "--overlay kernel";
    if (snapshot.maps.empty() || !snapshot.maps.front().tree)
        throwUsage(CULLSCOPE_TR("%1: the strategy \"%2\" has no quadtree and no inner kernel. Strategies that have them: %3."),
                   {option, strategy, kStrategiesWithCells});
    if (std::ranges::any_of(snapshot.maps, hasKernel)) return;
    const MapSnapshot& shown = *shownMap(snapshot);
    requireKernelOf(shown, option, scene);
    throwUsage(CULLSCOPE_TR("%1: the object \"%2\" is %3, so that its inner kernel is not shown. Choose another eye or target."),
               {option, scene.instances()[shown.decision.instance].name, relationName(shown.decision.relation)});
}

void requireMap(MapColouring colouring, const std::string& strategy, const StructureSnapshot& snapshot, const Scene& scene) {
    if (snapshot.maps.empty())
        throwUsage(CULLSCOPE_TR("--overlay index-map: the strategy \"%1\" has no index map. Strategies that have one: %2."),
                   {strategy, kStrategiesWithMaps});
    const MapSnapshot& shown = *shownMap(snapshot);
    if (hasColouring(shown, colouring)) return;
    const std::string option = std::string("--map-colouring ") + mapColouringId(colouring);
    if (shown.tree) requireKernelOf(shown, option, scene);
    throwUsage(CULLSCOPE_TR("%1: the strategy \"%2\" has no quadtree and no inner kernel. Strategies that have them: %3."),
               {option, strategy, kStrategiesWithCells});
}

}  // namespace

void addOverlayOptions(CLI::App& command, OverlayOptions& options) {
    command
        .add_option(
            "--overlay", options.names,
            "verdicts (colour by verdict, against the truth), boxes (that the strategy tests; bounding spheres, visible "
            "region and corner rays of spherical strategies, judged cells of spherical-lossless), frustum (of the culling "
            "camera), bands (contour bands of spherical strategies, with S), kernel (of spherical-lossless: what is filled "
            "of a solid around its centre, with the horizon that the eye sees of it); in place of the scene: index-map (of "
            "spherical strategies, of the first "
            "object in the frustum), spherical-model (what was drawn of the first object, over azimuth and zenith "
            "angle); may be given more than once")
        ->allow_extra_args(false);
    command.add_option("--below", options.below,
                       "a second picture of the same size below the first: index-map, spherical-model, or behind (the same from "
                       "the other side)");
    command.add_option(
        "--map-colouring", options.mapColouring,
        "of the index map: entries (triangles by cell, the default), radius, state, or of spherical-lossless level (of the "
        "judged cells) or kernel (its radius)");
    command
        .add_option(
            "--box-colouring", options.boxColouring,
            "of --overlay boxes: verdict (the default), or plane (of the frustum, that rejected them; with --overlay frustum "
            "its planes have the same colours)")
        ->check(CLI::IsMember({boxColouringId(BoxColouring::Verdict), boxColouringId(BoxColouring::Plane)}));
    command.add_option("--view-eye", options.eye, "eye of an observer, x,y,z (default: the culling camera's)");
    command.add_option("--view-target", options.target, "what the observer looks at, x,y,z");
    command.add_option("--view-up", options.up, "the observer's up, x,y,z");
    command.add_option("--view-fovy", options.fovy, "the observer's vertical field of view in degrees")
        ->check(CLI::PositiveNumber);
    command.add_option("--view-near", options.nearDistance, "the observer's near distance (default: from the eye's place)")
        ->check(CLI::PositiveNumber);
    command.add_option("--view-far", options.farDistance, "the observer's far distance (default: from the eye's place)")
        ->check(CLI::PositiveNumber);
    command.add_option("--culling-size", options.cullingSize,
                       "WIDTHxHEIGHT of the culling camera's picture, where an observer's is another (default: --size)");
    command.add_flag("--drawn-only", options.drawnOnly, "with --overlay verdicts: leave out what was culled");
}

OverlayChoice overlaysOf(const OverlayOptions& options) {
    OverlayChoice choice;
    for (const std::string& name : options.names)
        if (!add(name, choice)) throwUsage(CULLSCOPE_TR("There is no overlay \"%1\". Known: %2."), {name, kOverlays});
    requireAlone(choice, options.names);
    choice.look.culledToo = !options.drawnOnly;
    if (options.drawnOnly && choice.look.colouring != Colouring::Verdicts)
        throwUsage(CULLSCOPE_TR("--drawn-only says what --overlay verdicts shows: give both."));
    if (!options.boxColouring.empty() && !choice.look.boxes)
        throwUsage(CULLSCOPE_TR("--box-colouring says what --overlay boxes shows: give both."));
    if (options.boxColouring == boxColouringId(BoxColouring::Plane)) choice.look.boxColouring = BoxColouring::Plane;
    if (options.mapColouring.empty()) return choice;
    if (choice.map)
        choice.map = mapColouringFromId(options.mapColouring);
    else if (options.below != "index-map")
        throwUsage(CULLSCOPE_TR("--map-colouring says what --overlay index-map shows: give both."));
    return choice;
}

std::optional<BelowChoice> belowOf(const OverlayOptions& options, const OverlayChoice& above) {
    if (options.below.empty()) return std::nullopt;
    BelowChoice below;
    if (options.below == "index-map")
        below.overlays.map = options.mapColouring.empty() ? MapColouring::Entries : mapColouringFromId(options.mapColouring);
    else if (options.below == "spherical-model")
        below.overlays.look.sphericalModel = true;
    else if (options.below != "behind")
        throwUsage(CULLSCOPE_TR("--below %1: index-map, spherical-model or behind can stand below a picture."), {options.below});
    else if (above.replacesScene())
        throwUsage(CULLSCOPE_TR("--below behind: a map has no other side. Leave it out, or show the scene."));
    else
        below = {above, true};
    return below;
}

Camera cameraBehind(const Camera& camera, const Scene& scene) {
    const Vec3 centre = scene.boundingSphere().centre;
    Camera behind = camera;
    behind.eye = 2.0 * centre - camera.eye;
    behind.target = 2.0 * centre - camera.target;
    fitDepthRange(behind, scene);
    return behind;
}

void requireOverlays(const OverlayChoice& choice, const std::string& strategy, const StructureSnapshot& snapshot,
                     const Scene& scene) {
    if (choice.look.boxes && snapshot.nodes.empty() && snapshot.maps.empty())
        throwUsage(CULLSCOPE_TR("--overlay boxes: this strategy tests no boxes. Leave it out, or choose the strategy frustum."));
    if (choice.look.bands) requireBands(strategy, snapshot, scene);
    if (choice.look.kernel) requireKernel(strategy, snapshot, scene);
    if (choice.map) requireMap(*choice.map, strategy, snapshot, scene);
}

const MapSnapshot* shownMap(const StructureSnapshot& snapshot) {
    for (const MapSnapshot& map : snapshot.maps)
        if (map.decision.relation != SphereRelation::Outside) return &map;
    return snapshot.maps.empty() ? nullptr : &snapshot.maps.front();
}

Camera viewingCamera(const OverlayOptions& options, const Camera& culling, const Scene& scene) {
    if (!options.observer()) return culling;
    Camera camera = culling;
    if (!options.eye.empty()) camera.eye = vectorFromText("--view-eye", options.eye);
    if (!options.target.empty()) camera.target = vectorFromText("--view-target", options.target);
    if (!options.up.empty()) camera.up = vectorFromText("--view-up", options.up);
    if (options.fovy > 0.0) camera.fovy = Angle::fromDegrees(options.fovy);
    fitDepthRange(camera, scene);
    if (options.nearDistance > 0.0) camera.nearDistance = options.nearDistance;
    if (options.farDistance > 0.0) camera.farDistance = options.farDistance;
    return camera;
}

Viewport cullingSize(const OverlayOptions& options, const Viewport& size) {
    return options.cullingSize.empty() ? size : sizeFromText(options.cullingSize, "--culling-size");
}

}  // namespace cullscope::cullbench
