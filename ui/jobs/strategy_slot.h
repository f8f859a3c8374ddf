#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "core/base/message.h"
#include "ui/jobs/background.h"
#include "ui/jobs/built_strategy.h"

namespace cullscope::ui {

/// The strategy of one view: which one with which parameters, and the newest one that is built.
/// Building happens beside the window; while a newer one is under way the older one goes on drawing, and only the
/// last of many quick changes is built. What is refused is not built, and what was built before it goes.
class StrategySlot : public QObject {
    Q_OBJECT

public:
    /// Why a strategy cannot be used here; nothing: it can.
    using Refusal = std::function<std::optional<Message>(const StrategyInfo&)>;

    StrategySlot(std::string id, ParameterSet parameters, Refusal refusal, QObject* parent = nullptr);

    [[nodiscard]] const std::string& id() const { return m_id; }
    [[nodiscard]] const ParameterSet& parameters() const { return m_parameters; }
    /// Null while nothing is built for the present scene.
    [[nodiscard]] const BuiltStrategyPointer& built() const { return m_built; }
    [[nodiscard]] bool building() const { return m_background.busy(); }
    /// Whether what was chosen is refused, so that there is nothing to show until another one is chosen.
    [[nodiscard]] bool refused() const { return m_refused; }

    /// All parameters at their defaults. Throws what findStrategy throws, and nothing changes.
    void choose(const std::string& id);
    void setParameters(const ParameterSet& parameters);
    /// Null: no scene.
    void setScene(const ScenePointer& scene);

signals:
    /// `id` or `parameters` changed.
    void chosen();
    /// `built` changed.
    void builtChanged();
    void failed(const cullscope::Message& message);

private:
    void build();
    void start();
    void refuse(const Message& why);

    Refusal m_refusal;
    std::string m_id;
    ParameterSet m_parameters;
    ScenePointer m_scene;
    BuiltStrategyPointer m_built;
    Background m_background;
    bool m_again = false;
    bool m_refused = false;
};

}  // namespace cullscope::ui
