#include "ui/panels/parameter_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QSpinBox>
#include <cmath>

#include "ui/look/wheel_guard.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr int kSliderSteps = 1000;
constexpr double kLogarithmicFrom = 1000.0;  // a range with a larger ratio gets a logarithmic slider

bool sameDeclarations(const ParameterSet& a, const ParameterSet& b) {
    const auto key = [](const ParameterDeclaration& x, const ParameterDeclaration& y) {
        return x.key == y.key && x.type == y.type && x.description == y.description && x.minimum == y.minimum &&
               x.maximum == y.maximum;
    };
    return std::equal(a.declarations().begin(), a.declarations().end(), b.declarations().begin(), b.declarations().end(), key);
}

bool logarithmic(const ParameterDeclaration& declaration) {
    return declaration.minimum > 0.0 && declaration.maximum / declaration.minimum > kLogarithmicFrom;
}

double valueAt(const ParameterDeclaration& declaration, int step) {
    const double share = double(step) / kSliderSteps;
    if (logarithmic(declaration)) return declaration.minimum * std::pow(declaration.maximum / declaration.minimum, share);
    return declaration.minimum + share * (declaration.maximum - declaration.minimum);
}

int stepOf(const ParameterDeclaration& declaration, double value) {
    const double range = declaration.maximum - declaration.minimum;
    if (!(range > 0.0)) return 0;
    const double share = logarithmic(declaration)
                             ? std::log(value / declaration.minimum) / std::log(declaration.maximum / declaration.minimum)
                             : (value - declaration.minimum) / range;
    return int(std::lround(kSliderSteps * share));
}

/// The number of decimals that resolve a thousandth of the range.
int decimalsFor(const ParameterDeclaration& declaration) {
    const double finest = logarithmic(declaration) ? declaration.minimum : (declaration.maximum - declaration.minimum) / 1000.0;
    return finest > 0.0 ? std::clamp(int(std::ceil(-std::log10(finest))), 0, 9) : 3;
}

QString suffix(const ParameterDeclaration& declaration) {
    return declaration.unit.empty() ? QString() : QLatin1Char(' ') + QString::fromStdString(declaration.unit);
}

}  // namespace

ParameterForm::ParameterForm(QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
}

void ParameterForm::setParameters(const ParameterSet& parameters) {
    const bool same = m_fields && sameDeclarations(parameters, m_parameters);
    if (same && parameters == m_parameters) return;
    m_parameters = parameters;
    rebuild();
}

void ParameterForm::rebuild() {
    if (m_fields) {
        layout()->removeWidget(m_fields);
        m_fields->hide();
        m_fields->deleteLater();
    }
    m_stops.clear();
    m_fields = new QWidget(this);
    auto* form = new QFormLayout(m_fields);
    form->setContentsMargins(0, 0, 0, 0);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    for (const ParameterDeclaration& declaration : m_parameters.declarations()) {
        QWidget* editor = field(declaration);
        const QString sentence = translated(declaration.description);
        auto* label = new QLabel(QString::fromStdString(declaration.key));
        label->setBuddy(editor);
        label->setToolTip(sentence);
        editor->setToolTip(sentence);
        form->addRow(label, editor);
        auto* explanation = new QLabel(sentence);
        explanation->setWordWrap(true);
        explanation->setEnabled(false);
        form->addRow(explanation);
    }
    if (m_parameters.declarations().empty()) {
        auto* none = new QLabel(tr("This strategy has no parameters."));
        none->setWordWrap(true);
        form->addRow(none);
    }
    layout()->addWidget(m_fields);
    orderTabs();
}

void ParameterForm::setTabPredecessor(QWidget* widget) {
    m_tabPredecessor = widget;
    orderTabs();
}

void ParameterForm::orderTabs() {
    QWidget* last = m_tabPredecessor;
    for (QWidget* stop : m_stops) {
        if (last) setTabOrder(last, stop);
        last = stop;
    }
}

QWidget* ParameterForm::field(const ParameterDeclaration& declaration) {
    QWidget* editor = nullptr;
    switch (declaration.type) {
        case ParameterType::Boolean:
            editor = checkBox(declaration);
            break;
        case ParameterType::Integer:
            editor = spinBox(declaration);
            break;
        case ParameterType::Real:
            editor = sliderWithNumber(declaration);
            break;
        case ParameterType::Choice:
            editor = list(declaration);
            break;
    }
    editor->setObjectName(QString::fromStdString(declaration.key));
    editor->setAccessibleName(QString::fromStdString(declaration.key));
    editor->setAccessibleDescription(translated(declaration.description));
    return editor;
}

QWidget* ParameterForm::checkBox(const ParameterDeclaration& declaration) {
    auto* box = new QCheckBox;
    m_stops.push_back(box);
    box->setChecked(m_parameters.boolean(declaration.key));
    connect(box, &QCheckBox::toggled, this, [this, key = declaration.key](bool on) { take(key, on); });
    return box;
}

QWidget* ParameterForm::spinBox(const ParameterDeclaration& declaration) {
    auto* box = new QSpinBox;
    m_stops.push_back(box);
    leaveWheelUnlessFocused(*box);
    const auto bounded = [](double value) { return int(std::clamp(value, double(INT_MIN), double(INT_MAX))); };
    box->setRange(bounded(declaration.minimum), bounded(declaration.maximum));
    box->setSuffix(suffix(declaration));
    box->setGroupSeparatorShown(true);
    box->setValue(int(m_parameters.integer(declaration.key)));
    connect(box, &QSpinBox::valueChanged, this, [this, key = declaration.key](int value) { take(key, int64_t(value)); });
    return box;
}

QWidget* ParameterForm::sliderWithNumber(const ParameterDeclaration& declaration) {
    auto* both = new QWidget;
    auto* row = new QHBoxLayout(both);
    row->setContentsMargins(0, 0, 0, 0);
    auto* slider = new QSlider(Qt::Horizontal);
    auto* number = new QDoubleSpinBox;
    both->setFocusProxy(number);
    m_stops.insert(m_stops.end(), {slider, number});
    leaveWheelUnlessFocused(*slider);
    leaveWheelUnlessFocused(*number);
    slider->setRange(0, kSliderSteps);
    slider->setAccessibleName(QString::fromStdString(declaration.key));
    number->setAccessibleName(QString::fromStdString(declaration.key));
    number->setDecimals(decimalsFor(declaration));
    number->setRange(declaration.minimum, declaration.maximum);
    number->setSingleStep(std::max((declaration.maximum - declaration.minimum) / 100.0, std::pow(10.0, -number->decimals())));
    number->setSuffix(suffix(declaration));
    const double value = m_parameters.real(declaration.key);
    number->setValue(value);
    slider->setValue(stepOf(declaration, value));
    row->addWidget(slider, 1);
    row->addWidget(number);
    connect(slider, &QSlider::valueChanged, number, [number, declaration](int step) {
        if (step != stepOf(declaration, number->value())) number->setValue(valueAt(declaration, step));
    });
    connect(number, &QDoubleSpinBox::valueChanged, this, [this, slider, declaration](double changed) {
        const QSignalBlocker quiet(slider);
        slider->setValue(stepOf(declaration, changed));
        take(declaration.key, changed);
    });
    return both;
}

QWidget* ParameterForm::list(const ParameterDeclaration& declaration) {
    auto* box = new QComboBox;
    m_stops.push_back(box);
    leaveWheelUnlessFocused(*box);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(8);
    for (const ParameterDeclaration::Choice& choice : declaration.choices) {
        const QString id = QString::fromStdString(choice.id);
        box->addItem(id, id);
        box->setItemData(box->count() - 1, translated(choice.description), Qt::ToolTipRole);
    }
    box->setCurrentIndex(box->findData(QString::fromStdString(m_parameters.choice(declaration.key))));
    connect(box, &QComboBox::currentIndexChanged, this,
            [this, box, key = declaration.key] { take(key, box->currentData().toString().toStdString()); });
    return box;
}

void ParameterForm::take(const std::string& key, const ParameterValue& value) {
    if (m_parameters.value(key) == value) return;
    m_parameters.set(key, value);
    emit edited(m_parameters);
}

void ParameterForm::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange && m_fields) rebuild();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
