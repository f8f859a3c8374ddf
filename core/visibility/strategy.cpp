#include "core/visibility/strategy.h"

#include "core/frame/decided_ahead.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/frame/curve.h"
#include "core/frame/named_parts.h"
#include "core/visibility/facing.h"
#include "core/visibility/overlay.h"
#include "core/visibility/subject_shape.h"
#include "core/visibility/why.h"

namespace cullscope {

const char* promiseId(Promise promise) {
    switch (promise) {
        case Promise::Exact:
            return "exact";
        case Promise::Conservative:
            return "conservative";
        case Promise::Approximate:
            break;
    }
    return "approximate";
}

const Show* StrategyInfo::show(std::string_view showId) const {
    const auto found = std::ranges::find_if(shows, [&](const Show& show) { return show.id == showId; });
    return found == shows.end() ? nullptr : &*found;
}

const Show* StrategyInfo::first(Show::Kind kind) const {
    const auto found = std::ranges::find(shows, kind, &Show::kind);
    return found == shows.end() ? nullptr : &*found;
}

std::optional<Message> unavailable(const StrategyInfo& info, const GlInfo& gl) {
    if (info.glRequirement != GlRequirement::CompatibilityProfile || gl.compatibilityProfile) return std::nullopt;
    return Message{info.withoutProfile, {info.id, gl.renderer}};
}

void requireAvailable(const StrategyInfo& info, const GlInfo& gl) {
    if (const std::optional<Message> why = unavailable(info, gl)) throwOpenGl(why->text, why->arguments);
}

std::optional<Message> unserved(const StrategyInfo& info, const ParameterSet& parameters, const Camera& camera) {
    if (!info.decidesByFile.empty() && parameters.choice(info.decidesByFile).empty())
        return Message{CULLSCOPE_TR("%1 decides by a file: choose one as its parameter %2. Until then every triangle is drawn."),
                       {info.id, info.decidesByFile}};
    if (!info.needsEyePoint || camera.projection == ProjectionKind::Perspective) return std::nullopt;
    return Message{CULLSCOPE_TR("%1 needs the place of an eye, and a parallel view has none: every triangle is drawn."),
                   {info.id}};
}

Facing Strategy::facing(const Scene& scene, const ParameterSet& parameters) const { return resolveFacing(parameters, scene); }

SubjectShape Strategy::groupShape(const Structure& /*structure*/, const StructureSnapshot& snapshot, uint32_t number) const {
    SubjectShape shape;
    const auto found = std::ranges::find_if(
        snapshot.nodes, [number](const SnapshotNode& node) { return node.isGroup() && node.number == number; });
    if (found == snapshot.nodes.end()) return shape;
    shape.node = number;
    shape.boxes.push_back(found->box);
    return shape;
}

NamedParts Strategy::parts(const Structure& structure, const FrameLog& log) const { return namedParts(structure.scene(), log); }

NamedParts Strategy::partsByLeaf(const Structure& structure, const FrameLog& log) const { return parts(structure, log); }

std::vector<OverlayLines> Strategy::overlay(std::string_view /*id*/, const OverlayContext& /*context*/,
                                            const Structure& /*structure*/, const FrameLog& /*log*/) const {
    return {};
}

std::optional<Message> Strategy::whyNotShown(std::string_view /*id*/, std::string_view /*colouring*/,
                                             const Structure& /*structure*/, const FrameLog& /*log*/) const {
    return std::nullopt;
}

CellMapPointer Strategy::directionMap(std::string_view /*id*/, const Structure& /*structure*/, const FrameLog& /*log*/,
                                      const std::optional<uint32_t>& /*object*/) const {
    return nullptr;
}

std::optional<Curve> Strategy::curve(std::string_view /*id*/, const Structure& /*structure*/, const FrameLog& /*log*/,
                                     const std::optional<uint32_t>& /*object*/, const std::optional<uint32_t>& /*part*/) const {
    return std::nullopt;
}

Bars Strategy::bars(std::string_view /*id*/, const Structure& /*structure*/, const FrameLog& /*log*/) const { return {}; }

std::string Strategy::frameLine(const Structure& /*structure*/, const FrameLog& /*log*/) const { return {}; }

void Strategy::addWhySteps(const Structure& /*structure*/, const FrameLog& /*log*/, uint32_t /*instance*/, uint32_t /*triangle*/,
                           std::vector<WhyStep>& /*steps*/) const {}

DrawList Strategy::decidedAhead(const Structure& /*structure*/, const FrameLog& log, size_t entries) const {
    return cullscope::decidedAhead(log, entries);
}

}  // namespace cullscope
