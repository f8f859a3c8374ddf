#include "app/cullbench/overlays.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/cullbench/commands.h"
#include "core/base/error.h"

namespace cullscope::cullbench {
namespace {

constexpr const char* kEveryStrategyHas = "verdicts, boxes, frustum";
/// Of strategies that have such a structure; none of today's has.
constexpr std::array kOfOtherStrategies{"index-map", "bands", "tree", "spherical-model"};

}  // namespace

void addOverlayOptions(CLI::App& command, OverlayOptions& options) {
    command
        .add_option("--overlay", options.names,
                    "verdicts (colour by verdict, against the truth), boxes (that the strategy tests), frustum (of the culling "
                    "camera); may be given more than once")
        ->allow_extra_args(false);
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

ViewLook lookOf(const OverlayOptions& options, const std::string& strategy) {
    ViewLook look;
    for (const std::string& name : options.names) {
        if (std::find(kOfOtherStrategies.begin(), kOfOtherStrategies.end(), name) != kOfOtherStrategies.end())
            throwUsage(CULLSCOPE_TR("--overlay %1: the strategy \"%2\" has no such overlay. It has: %3."),
                       {name, strategy, kEveryStrategyHas});
        if (name == "verdicts")
            look.colouring = Colouring::Verdicts;
        else if (name == "boxes")
            look.boxes = true;
        else if (name == "frustum")
            look.frustum = true;
        else
            throwUsage(CULLSCOPE_TR("There is no overlay \"%1\". Known: %2."),
                       {name, fmt::format("{}, {}", kEveryStrategyHas, fmt::join(kOfOtherStrategies, ", "))});
    }
    look.culledToo = !options.drawnOnly;
    if (options.drawnOnly && look.colouring != Colouring::Verdicts)
        throwUsage(CULLSCOPE_TR("--drawn-only says what --overlay verdicts shows: give both."));
    return look;
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
