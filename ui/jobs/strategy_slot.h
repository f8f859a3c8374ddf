#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <functional>
#include <optional>

#include "core/base/message.h"
#include "core/visibility/built_strategy.h"
#include "ui/jobs/background.h"

namespace cullscope::ui {

/// The strategy of one view: its id, its parameters, and the newest one that was built. Strategies are built in the background.
/// A change of a parameter that is read when culling builds nothing. While a newer one is being built, the older one draws. Where
/// another strategy is chosen meanwhile, or parameters change after a second, what was being built is given up; of several quick
/// changes of parameters the one being built and the last one are built. A refused strategy is not built, and the one built
/// before is released.
class StrategySlot : public QObject {
    Q_OBJECT

public:
    /// Returns why a strategy cannot be used here; none: it can be used.
    using Refusal = std::function<std::optional<Message>(const StrategyInfo&)>;

    StrategySlot(std::string id, ParameterSet parameters, Refusal refusal, std::shared_ptr<StructureStore> structures,
                 QObject* parent = nullptr);

    [[nodiscard]] const std::string& id() const { return m_id; }
    [[nodiscard]] const ParameterSet& parameters() const { return m_parameters; }
    /// The newest built strategy; null while none is built for the present scene.
    [[nodiscard]] const BuiltStrategyPointer& built() const { return m_built; }
    [[nodiscard]] bool building() const { return m_background.busy(); }
    /// Whether the chosen strategy is refused, so that there is nothing to show until another one is chosen.
    [[nodiscard]] bool refused() const { return m_refused; }

    /// Chooses a strategy with default parameters. Throws what findStrategy throws, and then changes nothing.
    void choose(const std::string& id);
    /// With these parameters of it, in one change; likewise.
    void choose(const std::string& id, const ParameterSet& parameters);
    void setParameters(const ParameterSet& parameters);
    /// Whether a strategy was chosen since the slot was made.
    [[nodiscard]] bool everChosen() const { return m_everChosen; }
    /// Builds the strategy for `scene`; null: no scene is open.
    void setScene(const ScenePointer& scene);
    /// Whether what is chosen is built at all; it is by default. A slot of a view that is not shown builds once it is wanted.
    void setWanted(bool wanted);

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
    /// Keeps the structure where only parameters that are read when culling changed; returns whether it did.
    bool takeStructure();

    Refusal m_refusal;
    std::shared_ptr<StructureStore> m_structures;
    std::string m_id;
    ParameterSet m_parameters;
    ScenePointer m_scene;
    BuiltStrategyPointer m_built;
    Background m_background;
    std::string m_started;  ///< the strategy that was built last, or is being built
    QElapsedTimer m_since;  ///< its beginning
    bool m_everChosen = false;
    bool m_again = false;  ///< once that is built, it is built with newer parameters
    bool m_refused = false;
    bool m_wanted = true;
    bool m_due = false;  ///< something was chosen that is to be built once it is wanted
};

}  // namespace cullscope::ui
