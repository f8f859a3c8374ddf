#include "core/visibility/built_strategy.h"

#include <chrono>

namespace cullscope {

BuiltStrategy::BuiltStrategy(const RegisteredStrategy& strategy, ParameterSet parameters, StructurePointer structure)
    : m_info(strategy.info),
      m_strategy(strategy.strategy),
      m_parameters(std::move(parameters)),
      m_structure(std::move(structure)),
      m_facing(m_strategy->facing(m_structure->scene(), m_parameters)),
      m_referenceFacing(m_strategy->referenceFacing(m_structure->scene(), m_parameters)) {}

void BuiltStrategy::draw(FrameContext& frame, ViewState& state) const {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    frame.setFacing(m_facing);
    m_strategy->draw(frame, *m_structure, state, m_parameters);
    const std::chrono::duration<double, std::milli> passed = Clock::now() - start;
    frame.setCullMilliseconds(passed.count() - frame.drawingMilliseconds());
}

FrameLog BuiltStrategy::decide(const View& culling, ViewState& state, bool recording) const {
    FrameContext frame(scene(), culling, recording);
    draw(frame, state);
    return frame.take();
}

BuiltStrategyPointer buildStrategy(std::string_view id, const ParameterSet& parameters, const ScenePointer& scene,
                                   StructureStore& store, const Progress& progress) {
    return buildStrategy(findStrategy(id), parameters, scene, store, progress);
}

BuiltStrategyPointer buildStrategy(const RegisteredStrategy& strategy, const ParameterSet& parameters, const ScenePointer& scene,
                                   StructureStore& store, const Progress& progress) {
    return std::make_shared<const BuiltStrategy>(strategy, parameters, store.get(strategy, parameters, scene, progress));
}

}  // namespace cullscope
