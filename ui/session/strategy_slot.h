#pragma once

#include <QObject>

#include "core/base/message.h"
#include "ui/session/background.h"
#include "ui/session/built_strategy.h"

namespace cullscope::ui {

/// The strategy of one view: which one with which parameters, and the newest one that is built.
/// Building happens beside the window; while a newer one is under way the older one goes on drawing, and only the
/// last of many quick changes is built.
class StrategySlot : public QObject {
    Q_OBJECT

public:
    StrategySlot(std::string id, ParameterSet parameters, QObject* parent = nullptr);

    [[nodiscard]] const std::string& id() const { return m_id; }
    [[nodiscard]] const ParameterSet& parameters() const { return m_parameters; }
    /// Null while nothing is built for the present scene.
    [[nodiscard]] const BuiltStrategyPointer& built() const { return m_built; }
    [[nodiscard]] bool building() const { return m_background.busy(); }

    /// All at their defaults.
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

    std::string m_id;
    ParameterSet m_parameters;
    ScenePointer m_scene;
    BuiltStrategyPointer m_built;
    Background m_background;
    bool m_again = false;
};

}  // namespace cullscope::ui
