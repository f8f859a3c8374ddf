#include "core/visibility/built_strategy.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <utility>

#include "core/frame/curve.h"
#include "core/frame/named_parts.h"
#include "core/scene/scene_source.h"
#include "core/visibility/overlay.h"
#include "core/visibility/subject_shape.h"
#include "core/visibility/why.h"

namespace cullscope {

BuiltStrategy::BuiltStrategy(const RegisteredStrategy& strategy, ParameterSet parameters, StructurePointer structure)
    : m_info(strategy.info),
      m_strategy(strategy.strategy),
      m_parameters(std::move(parameters)),
      m_structure(std::move(structure)),
      m_facing(m_strategy->facing(m_structure->scene(), m_parameters)),
      m_referenceFacing(m_strategy->referenceFacing(m_structure->scene(), m_parameters)) {}

void BuiltStrategy::draw(FrameContext& frame, ViewState& state) const {
    const auto start = std::chrono::steady_clock::now();
    frame.setFacing(m_facing);
    // Each time is told once: a frame without a measured time leaves none to the next.
    frame.setFrameBefore(std::exchange(state.frameMilliseconds, std::nullopt));
    if (unserved(frame.view().camera()))
        drawEverything(frame);
    else
        m_strategy->draw(frame, *m_structure, state, m_parameters);
    const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - start;
    frame.setCullMilliseconds(passed.count() - frame.drawingMilliseconds() - frame.untimedMilliseconds());
}

void BuiltStrategy::drawEverything(FrameContext& frame) {
    DrawList list{frame.facing(), {}};
    for (uint32_t i = 0; i < frame.scene().instances().size(); ++i) {
        const auto indices = uint32_t(frame.scene().meshOf(i).indices().size());
        if (indices > 0) list.ranges.push_back({i, 0, indices});
        if (frame.recording()) frame.say(ending(Subject::ofObject(i), Decision::Outcome::Drawn));
    }
    frame.draw(std::move(list));
}

FrameLog BuiltStrategy::decide(const View& culling, ViewState& state, bool recording) const {
    FrameContext frame(scene(), culling, recording);
    draw(frame, state);
    return frame.take();
}

StructureSnapshot BuiltStrategy::snapshot(const FrameLog& log) const {
    if (unserved(log.camera)) return {};
    StructureSnapshot snapshot = m_strategy->snapshot(*m_structure, log);
    if (m_info.first(Show::Kind::Tree) == nullptr) snapshot.nodes.clear();
    return snapshot;
}

SubjectShape BuiltStrategy::groupShape(const StructureSnapshot& snapshot, uint32_t number) const {
    return m_strategy->groupShape(*m_structure, snapshot, number);
}

NamedParts BuiltStrategy::parts(const FrameLog& log) const {
    return unserved(log.camera) ? namedParts(scene(), log) : m_strategy->parts(*m_structure, log);
}

NamedParts BuiltStrategy::partsByLeaf(const FrameLog& log) const {
    return unserved(log.camera) ? namedParts(scene(), log) : m_strategy->partsByLeaf(*m_structure, log);
}

std::string BuiltStrategy::frameLine(const FrameLog& log) const {
    const std::optional<Message> reason = unserved(log.camera);
    return reason ? reason->english() : m_strategy->frameLine(*m_structure, log);
}

void BuiltStrategy::addWhySteps(const FrameLog& log, uint32_t instance, uint32_t triangle, std::vector<WhyStep>& steps) const {
    if (std::optional<Message> reason = unserved(log.camera))
        steps.push_back({std::move(*reason), {}, {}, {}, Containment::Straddles, false, false});
    else
        m_strategy->addWhySteps(*m_structure, log, instance, triangle, steps);
}

std::vector<OverlayLines> BuiltStrategy::overlay(std::string_view id, const OverlayContext& context, const FrameLog& log) const {
    if (m_info.show(id) == nullptr || unserved(log.camera)) return {};
    return m_strategy->overlay(id, context, *m_structure, log);
}

std::optional<Message> BuiltStrategy::whyNotShown(std::string_view id, std::string_view colouring, const FrameLog& log) const {
    const auto absent = [&](AbsentShow sentence, std::string_view ofColouring) {
        return sentence(commandLineOption(id, ofColouring), m_info.id, strategiesShowing(id, ofColouring));
    };
    if (id == kBoxesShow)
        if (auto reason = unserved(log.camera)) return reason;
    if (id == kBoxesShow && snapshot(log).nodes.empty())
        return Message{"%1: this strategy tests no boxes. Leave it out, or choose one that tests bounds.",
                       {commandLineOption(id)}};
    const auto& declared = declaredShows();
    const auto known = std::ranges::find_if(declared, [&](const Show* show) { return show->id == id; });
    if (m_info.show(id) == nullptr) {
        if (known == declared.end() || (*known)->absent == nullptr) return std::nullopt;
        return absent((*known)->absent, {});
    }
    if (auto reason = unserved(log.camera)) return reason;
    const auto own = m_strategy->whyNotShown(id, colouring, *m_structure, log);
    if (own || colouring.empty()) return own;
    const auto has = [&](const Show& show) {
        return std::ranges::find_if(show.colourings, [&](const ShowColouring& one) { return one.id == colouring; });
    };
    if (has(*m_info.show(id)) != m_info.show(id)->colourings.end()) return std::nullopt;
    const auto elsewhere = has(**known);
    if (elsewhere == (*known)->colourings.end() || elsewhere->absent == nullptr) return std::nullopt;
    return absent(elsewhere->absent, colouring);
}

CellMapPointer BuiltStrategy::directionMap(std::string_view id, const FrameLog& log,
                                           const std::optional<uint32_t>& object) const {
    return m_info.show(id) == nullptr || unserved(log.camera) ? nullptr : m_strategy->directionMap(id, *m_structure, log, object);
}

std::optional<Curve> BuiltStrategy::curve(std::string_view id, const FrameLog& log, const std::optional<uint32_t>& object,
                                          const std::optional<uint32_t>& part) const {
    if (m_info.show(id) == nullptr || unserved(log.camera)) return std::nullopt;
    return m_strategy->curve(id, *m_structure, log, object, part);
}

std::vector<Bars> BuiltStrategy::bars(const FrameLog& log) const {
    std::vector<Bars> all;
    for (const Show& show : m_info.shows) {
        if (show.kind != Show::Kind::Bars) continue;
        all.push_back(unserved(log.camera) ? Bars{} : m_strategy->bars(show.id, *m_structure, log));
        all.back().title = show.title;
    }
    return all;
}

std::optional<ListingState> BuiltStrategy::listing(const FrameLog& log) const {
    const Show* show = m_info.first(Show::Kind::Listing);
    return show == nullptr ? std::nullopt : std::optional(listingState(log, show->lines.size()));
}

std::optional<ListingState> BuiltStrategy::listing(const FrameLog& log, uint64_t triangle) const {
    const Show* show = m_info.first(Show::Kind::Listing);
    if (show == nullptr) return std::nullopt;
    return listingState(m_structure->scene(), log, show->lines.size(), triangle);
}

BuiltStrategyPointer buildStrategy(std::string_view id, const ParameterSet& parameters, const ScenePointer& scene,
                                   StructureStore& store, const Progress& progress) {
    return buildStrategy(findStrategy(id), parameters, scene, store, progress);
}

BuiltStrategyPointer buildStrategy(const RegisteredStrategy& strategy, const ParameterSet& parameters, const ScenePointer& scene,
                                   StructureStore& store, const Progress& progress) {
    return std::make_shared<const BuiltStrategy>(strategy, parameters, store.get(strategy, parameters, scene, progress));
}

Promise usualPromise(const std::string& id) {
    static const std::map<std::string, Promise, std::less<>> kPromises = [] {
        const ScenePointer solid = openScene("sphere:triangles=20").scene;
        StructureStore store;
        std::map<std::string, Promise, std::less<>> promises;
        for (const RegisteredStrategy& each : strategies())
            promises.emplace(each.info.id, buildStrategy(each, ParameterSet(each.info.parameters), solid, store)->promise());
        return promises;
    }();
    return kPromises.at(id);
}

}  // namespace cullscope
