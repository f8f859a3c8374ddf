#pragma once

#include <QComboBox>
#include <QGroupBox>
#include <QLabel>

#include "ui/models/strategy_model.h"
#include "ui/panels/parameter_form.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// The active view's strategy: which one, and the form made from its declared parameters. Of a view that observes another it is
/// the other's: its own draws nothing.
class StrategyPanel : public QGroupBox {
    Q_OBJECT

public:
    explicit StrategyPanel(Session& session, QWidget* parent = nullptr);

    [[nodiscard]] QComboBox& choice() { return *m_choice; }
    [[nodiscard]] ParameterForm& form() { return *m_form; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    [[nodiscard]] int culling() const { return m_session.culledBy(m_session.activeView()); }

    Session& m_session;
    StrategyModel* m_model;
    QComboBox* m_choice;
    QLabel* m_description;
    ParameterForm* m_form;
};

}  // namespace cullscope::ui
