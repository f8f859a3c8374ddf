#include "app/cullbench/overlays.h"

#include <algorithm>

#include "app/cullbench/commands.h"
#include "core/base/error.h"
#include "core/visibility/registry.h"

namespace cullscope::cullbench {
namespace {

/// What strategies declare that stands in place of the scene's picture.
std::vector<const Show*> declaredPictures() { return declaredShows(Show::Kind::DirectionMap); }

/// What --overlay knows, in the order in which it is named.
std::vector<const Show*> knownShows() {
    std::vector<const Show*> shows;
    std::ranges::copy_if(namedShows(), std::back_inserter(shows), [](const Show* show) { return !show->help.empty(); });
    std::ranges::copy(declaredPictures(), std::back_inserter(shows));
    std::ranges::stable_sort(shows, {}, &Show::kind);
    return shows;
}

/// The ids of what stands in place of the scene, each with a separator behind it but the last one.
std::string pictureList(const std::string& separator) {
    std::string text;
    for (const Show* show : knownShows())
        if (show->inPlace()) text += (text.empty() ? "" : separator) + show->id;
    return text;
}

/// "--overlay ID" of each picture that has colourings.
std::string coloured() {
    std::string text;
    for (const Show* show : declaredPictures())
        if (!show->colourings.empty()) text += (text.empty() ? "" : " or ") + commandLineOption(show->id);
    return text;
}

/// The ids of all overlays, separated by commas.
std::string overlayList() {
    std::string text;
    for (const Show* show : knownShows()) text += (text.empty() ? "" : ", ") + show->id;
    return text;
}

/// What is said of all overlays in the command line's help.
std::string overlayHelp() {
    std::string text;
    bool inPlace = false;
    for (const Show* show : knownShows()) {
        std::string help = show->help;
        if (show->kind == Show::Kind::Boxes)
            for (const Show* own : declaredShows(show->kind)) help += "; " + own->help;
        if (!text.empty()) text += show->inPlace() && !inPlace ? "; in place of the scene: " : ", ";
        inPlace = show->inPlace();
        text += show->id + " (" + help + ")";
    }
    return text + "; may be given more than once";
}

/// The picture with this id that a strategy declares; null where there is none.
const Show* pictureOf(const std::string& id) {
    for (const Show* show : declaredPictures())
        if (show->id == id) return show;
    return nullptr;
}

/// The colouring of a picture, by default its first. Throws Error(Usage) naming the known ones for an unknown id.
std::string colouringOf(const Show& picture, const std::string& id) {
    if (id.empty()) return picture.colourings.empty() ? std::string() : picture.colourings.front().id;
    std::string known;
    for (const ShowColouring& colouring : picture.colourings) {
        if (colouring.id == id) return id;
        known += (known.empty() ? "" : ", ") + colouring.id;
    }
    throwUsage(CULLSCOPE_TR("There is no colouring \"%1\" of %2. Known: %3."), {id, picture.id, known});
}

const Show& byPlane() { return commonShow(Show::Kind::Planes); }

/// Adds one overlay; returns false for an unknown name.
bool add(const std::string& name, OverlayChoice& choice) {
    if (pictureOf(name) != nullptr)
        choice.picture = name;
    else if (std::ranges::any_of(knownShows(), [&](const Show* show) { return show->id == name; }))
        choice.look.show(name, true);
    else
        return false;
    return true;
}

/// Throws Error(Usage) where an overlay that replaces the scene is combined with another.
void requireAlone(const OverlayChoice& choice, const std::vector<std::string>& names) {
    if (!choice.replacesScene()) return;
    const std::string alone = choice.picture.empty() ? overlayIds(choice.look).front() : choice.picture;
    for (const std::string& name : names)
        if (name != alone)
            throwUsage(CULLSCOPE_TR("--overlay %1 stands in place of the scene's picture: give it without --overlay %2."),
                       {alone, name});
}

}  // namespace

void addOverlayOptions(CLI::App& command, OverlayOptions& options) {
    command.add_option("--overlay", options.names, overlayHelp())->allow_extra_args(false);
    command.add_option(
        "--below", options.below,
        "a second picture of the same size below the first: " + pictureList(", ") + ", or behind (the same from the other side)");
    std::string colourings;
    for (const Show* show : declaredPictures())
        if (!show->colourings.empty()) colourings += (colourings.empty() ? "" : "; ") + show->colouringHelp;
    command.add_option("--map-colouring", options.mapColouring, colourings);
    command
        .add_option(
            "--box-colouring", options.boxColouring,
            "of --overlay boxes: verdict (the default), or plane (of the frustum, that rejected them; with --overlay frustum "
            "its planes have the same colours)")
        ->check(CLI::IsMember({byPlane().field.off, byPlane().field.on}));
    command.add_option("--view-eye", options.eye, "eye of an observer, x,y,z (default: the culling camera's)");
    command.add_option("--view-target", options.target, "what the observer looks at, x,y,z");
    command.add_option("--view-up", options.up, "the observer's up, x,y,z");
    command.add_option("--view-fovy", options.fovy, "the observer's vertical field of view in degrees")->check(positiveNumber());
    addProjectionOptions(command, options.projection, "--view-");
    command.add_option("--view-near", options.nearDistance, "the observer's near distance (default: from the eye's place)")
        ->check(positiveNumber());
    command.add_option("--view-far", options.farDistance, "the observer's far distance (default: from the eye's place)")
        ->check(positiveNumber());
    command.add_option("--culling-size", options.cullingSize,
                       "WIDTHxHEIGHT of the culling camera's picture, where an observer's is another (default: --size)");
    command.add_option("--section", options.section,
                       "cut the picture by a plane: x:0.5, y:0.5, z:0.5 or view:0.5, the share of the scene's extent where it "
                       "lies; with :flip the other side is kept");
    command.add_flag("--drawn-only", options.drawnOnly, "with --overlay verdicts: leave out what was culled");
}

OverlayChoice overlaysOf(const OverlayOptions& options) {
    OverlayChoice choice;
    for (const std::string& name : options.names)
        if (!add(name, choice)) throwUsage(CULLSCOPE_TR("There is no overlay \"%1\". Known: %2."), {name, overlayList()});
    requireAlone(choice, options.names);
    choice.look.show(commonShow(Show::Kind::Left).id, !options.drawnOnly);
    if (options.drawnOnly && !choice.look.has(Show::Kind::Verdicts))
        throwUsage(CULLSCOPE_TR("--drawn-only says what --overlay verdicts shows: give both."));
    if (!options.boxColouring.empty() && !choice.look.has(Show::Kind::Boxes))
        throwUsage(CULLSCOPE_TR("--box-colouring says what --overlay boxes shows: give both."));
    if (options.boxColouring == byPlane().field.on) choice.look.show(byPlane().id, true);
    if (const Show* picture = pictureOf(choice.picture))
        choice.colouring = colouringOf(*picture, options.mapColouring);
    else if (!options.mapColouring.empty() && pictureOf(options.below) == nullptr)
        throwUsage(CULLSCOPE_TR("--map-colouring says what %1 shows: give both."), {coloured()});
    return choice;
}

std::optional<BelowChoice> belowOf(const OverlayOptions& options, const OverlayChoice& above) {
    if (options.below.empty()) return std::nullopt;
    BelowChoice below;
    if (const Show* picture = pictureOf(options.below)) {
        below.overlays.picture = picture->id;
        below.overlays.colouring = colouringOf(*picture, options.mapColouring);
        return below;
    }
    const std::vector<const Show*> known = knownShows();
    const auto inPlace =
        std::ranges::find_if(known, [&](const Show* show) { return show->inPlace() && show->id == options.below; });
    if (inPlace != known.end())
        below.overlays.look.show(options.below, true);
    else if (options.below != "behind")
        throwUsage(CULLSCOPE_TR("--below %1: %2 or behind can stand below a picture."), {options.below, pictureList(", ")});
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

void requireOverlays(const OverlayChoice& choice, const BuiltStrategy& strategy, const FrameLog& log) {
    const auto require = [&](const std::string& id, const std::string& colouring) {
        if (const std::optional<Message> why = strategy.whyNotShown(id, colouring, log)) throwUsage(why->text, why->arguments);
    };
    for (const std::string& id : overlayIds(choice.look)) require(id, {});
    // Bounds in a form of the strategy's own have colours of their own.
    const bool ownBoxes = strategy.info().first(Show::Kind::Boxes) != nullptr;
    const auto ofPlane = [](const Decision& decision) { return decision.plane.has_value(); };
    if (choice.look.has(Show::Kind::Planes) && (ownBoxes || std::ranges::none_of(log.decisions, ofPlane)))
        throwUsage(
            CULLSCOPE_TR("--box-colouring %1: \"%2\" tests no box against a plane of the frustum here, which could give it a "
                         "colour. Leave it out."),
            {byPlane().field.on, strategy.id()});
    if (!choice.picture.empty()) require(choice.picture, choice.colouring);
}

Camera viewingCamera(const OverlayOptions& options, const Camera& culling, const Scene& scene) {
    if (!options.observer()) return culling;
    // A change to perspective moves the eye of a parallel camera, and so comes before an eye that is given.
    const bool perspective = options.projection.projection == projectionId(ProjectionKind::Perspective);
    Camera camera = perspective ? options.projection.of(culling) : culling;
    if (!options.eye.empty()) camera.eye = vectorFromText("--view-eye", options.eye);
    if (!options.target.empty()) camera.target = vectorFromText("--view-target", options.target);
    if (!options.up.empty()) camera.up = vectorFromText("--view-up", options.up);
    if (options.fovy > 0.0) camera.fovy = Angle::fromDegrees(options.fovy);
    if (!perspective) camera = options.projection.of(camera);
    fitDepthRange(camera, scene);
    if (options.nearDistance > 0.0) camera.nearDistance = options.nearDistance;
    if (options.farDistance > 0.0) camera.farDistance = options.farDistance;
    return camera;
}

std::optional<Section> sectionOf(const OverlayOptions& options) {
    if (options.section.empty()) return std::nullopt;
    if (std::optional<Section> section = sectionFromText(options.section)) return section;
    throwUsage(CULLSCOPE_TR("--section %1 is no plane: write x, y, z or view, a share from 0 to 1, and flip, as in x:0.5:flip."),
               {options.section});
}

Viewport cullingSize(const OverlayOptions& options, const Viewport& size) {
    return options.cullingSize.empty() ? size : sizeFromText(options.cullingSize, "--culling-size");
}

}  // namespace cullscope::cullbench
