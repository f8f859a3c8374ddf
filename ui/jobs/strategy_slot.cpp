#include "ui/jobs/strategy_slot.h"

#include <QCoreApplication>

#include "core/base/error.h"
#include "core/visibility/registry.h"

namespace cullscope::ui {
namespace {

constexpr qint64 kLong = 1000;  // ms

}  // namespace

StrategySlot::StrategySlot(std::string id, ParameterSet parameters, Refusal refusal, std::shared_ptr<StructureStore> structures,
                           QObject* parent)
    : QObject(parent),
      m_refusal(std::move(refusal)),
      m_structures(std::move(structures)),
      m_id(std::move(id)),
      m_parameters(std::move(parameters)) {}

void StrategySlot::choose(const std::string& id) {
    if (id == m_id) return void(m_everChosen = true);
    choose(id, ParameterSet(findStrategy(id).info.parameters));
}

void StrategySlot::choose(const std::string& id, const ParameterSet& parameters) {
    (void)findStrategy(id);
    m_everChosen = true;
    if (id == m_id) return setParameters(parameters);
    m_parameters = parameters;
    m_id = id;
    emit chosen();
    build();
}

void StrategySlot::setParameters(const ParameterSet& parameters) {
    if (parameters == m_parameters) return;
    m_parameters = parameters;
    emit chosen();
    build();
}

void StrategySlot::setScene(const ScenePointer& scene) {
    m_scene = scene;
    m_background.cancel();
    m_again = false;
    m_built = nullptr;
    emit builtChanged();
    build();
}

void StrategySlot::setWanted(bool wanted) {
    m_wanted = wanted;
    if (m_wanted && m_due) build();
}

void StrategySlot::build() {
    if (!m_scene) return;
    m_due = !m_wanted;
    if (m_due) return;
    const std::optional<Message> why = m_refusal(findStrategy(m_id).info);
    m_refused = why.has_value();
    if (why) return refuse(*why);
    if (takeStructure()) return;
    // While a parameter is dragged, what is built on the way shows how it works. Another strategy, and what takes longer than a
    // drag, would only be waited for.
    m_again = m_background.busy() && m_started == m_id && !m_since.hasExpired(kLong);
    if (!m_again) start();
}

bool StrategySlot::takeStructure() {
    if (!m_built || m_built->scenePointer() != m_scene || m_built->id() != m_id) return false;
    if (m_built->parameters().buildText() != m_parameters.buildText()) return false;
    m_background.cancel();
    m_again = false;
    m_built = std::make_shared<const BuiltStrategy>(findStrategy(m_id), m_parameters, m_built->structure());
    emit builtChanged();
    return true;
}

void StrategySlot::refuse(const Message& why) {
    m_background.cancel();
    m_again = false;
    m_built = nullptr;
    emit builtChanged();
    emit failed(why);
}

void StrategySlot::start() {
    m_started = m_id;
    m_since.start();
    const auto work = [this, id = m_id, parameters = m_parameters, scene = m_scene,
                       structures = m_structures](const std::stop_token& stop) -> Background::Delivery {
        Progress progress;
        progress.stop = stop;
        const BuiltStrategyPointer built = buildStrategy(id, parameters, scene, *structures, progress);
        return [this, built] {
            m_built = built;
            emit builtChanged();
            if (std::exchange(m_again, false)) start();
        };
    };
    m_background.start(work, [this, id = m_id](const std::exception& error) -> Background::Delivery {
        const auto* known = dynamic_cast<const Error*>(&error);
        const Message other{QT_TRANSLATE_NOOP("core", "The strategy %1 cannot be built for this scene: %2"), {id, error.what()}};
        return [this, message = known ? known->message() : other] {
            emit failed(message);
            if (std::exchange(m_again, false)) start();
        };
    });
}

}  // namespace cullscope::ui
