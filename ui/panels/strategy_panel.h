#pragma once

#include <QComboBox>
#include <QGroupBox>
#include <QLabel>

#include "ui/models/strategy_model.h"
#include "ui/panels/parameter_form.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// The choice of the active view's strategy, and the form made from its declared parameters. For an observer it shows the
/// strategy of the observed view, because the observer's own one draws nothing.
class StrategyPanel : public QGroupBox {
    Q_OBJECT

public:
    explicit StrategyPanel(Session& session, QWidget* parent = nullptr);

    [[nodiscard]] QComboBox& choice() { return *m_choice; }
    [[nodiscard]] ParameterForm& form() { return *m_form; }
    /// What the parameters cost: the missed pixels of the view, greyed while they are counted anew.
    [[nodiscard]] const QLabel& missed() const { return *m_missed; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void showMissed();
    [[nodiscard]] int culling() const { return m_session.culledBy(m_session.activeView()); }

    Session& m_session;
    StrategyModel* m_model;
    QComboBox* m_choice;
    QLabel* m_description;
    QLabel* m_missed;
    ParameterForm* m_form;
};

}  // namespace cullscope::ui
