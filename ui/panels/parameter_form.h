#pragma once

#include <QWidget>

#include "core/visibility/parameters.h"

class QComboBox;
class QFormLayout;
class QLabel;

namespace cullscope::ui {

/// A form made from declared parameters: a check box, a slider with a number, or a list for each, with its unit and its
/// description. Emits every change at once.
class ParameterForm : public QWidget {
    Q_OBJECT

public:
    explicit ParameterForm(QWidget* parent = nullptr);

    /// Shows these values. Makes new fields if the declarations differ.
    void setParameters(const ParameterSet& parameters);
    /// Sets the tab order: from `widget` (in the same window) through the fields to the widget that followed it.
    void setTabPredecessor(QWidget* widget);
    [[nodiscard]] const ParameterSet& parameters() const { return m_parameters; }

signals:
    void edited(const cullscope::ParameterSet& parameters);

protected:
    void changeEvent(QEvent* event) override;

private:
    void rebuild();
    void orderTabs();
    QWidget* field(const ParameterDeclaration& declaration);
    QWidget* checkBox(const ParameterDeclaration& declaration);
    QWidget* number(const ParameterDeclaration& declaration);
    QWidget* list(const ParameterDeclaration& declaration);
    QWidget* fileName(const ParameterDeclaration& declaration);
    /// What the chosen one of several choices means, in the user's language.
    static QLabel* meaningOfChoice(QComboBox& box);
    void take(const std::string& key, const ParameterValue& value);

    ParameterSet m_parameters;
    QWidget* m_fields = nullptr;
    QWidget* m_tabPredecessor = nullptr;
    std::vector<QWidget*> m_stops;  ///< the fields in tab order
};

}  // namespace cullscope::ui
