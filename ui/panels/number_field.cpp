#include "ui/panels/number_field.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>
#include <climits>
#include <cmath>

#include "ui/look/undo_guard.h"
#include "ui/look/wheel_guard.h"

namespace cullscope::ui {

namespace {

constexpr int kSliderSteps = 1000;
constexpr double kWideRange = 1000.0;  ///< a range with a larger ratio is logarithmic unasked
constexpr int kDigits = 3;

QString suffix(const ParameterDeclaration& declaration) {
    return declaration.unit.empty() ? QString() : QLatin1Char(' ') + QString::fromStdString(declaration.unit);
}

/// To kDigits digits.
double rounded(double value) {
    if (!(std::abs(value) > 0.0)) return value;
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - (kDigits - 1));
    return std::round(value / unit) * unit;
}

/// A box for numbers of very different sizes: without zeros at the end, and with steps of a tenth of the number's own size.
class WideNumberBox : public QDoubleSpinBox {
public:
    using QDoubleSpinBox::QDoubleSpinBox;

    [[nodiscard]] QString textFromValue(double value) const override {
        QString text = QDoubleSpinBox::textFromValue(value);
        const QString point = locale().decimalPoint();
        if (!text.contains(point)) return text;
        while (text.endsWith(locale().zeroDigit())) text.chop(int(locale().zeroDigit().size()));
        if (text.endsWith(point)) text.chop(int(point.size()));
        return text;
    }

    [[nodiscard]] QSize sizeHint() const override { return widened(QDoubleSpinBox::sizeHint()); }
    [[nodiscard]] QSize minimumSizeHint() const override { return widened(QDoubleSpinBox::minimumSizeHint()); }

private:
    /// The box counts on the texts of both ends, and here those between are longer.
    [[nodiscard]] QSize widened(const QSize& size) const {
        const int ends = std::max(fontMetrics().horizontalAdvance(textFromValue(minimum())),
                                  fontMetrics().horizontalAdvance(textFromValue(maximum())));
        const int between = fontMetrics().horizontalAdvance(QDoubleSpinBox::textFromValue(0.0));
        return {size.width() + std::max(0, between - ends), size.height()};
    }
};

}  // namespace

SliderScale::SliderScale(const ParameterDeclaration& declaration) {
    const double least = declaration.minimum, most = declaration.maximum;
    const bool whole = declaration.type == ParameterType::Integer;
    if (declaration.logarithmicFrom > 0.0)
        m_from = declaration.logarithmicFrom;
    else if (least > 0.0 && most / least > kWideRange)
        m_from = least;
    else if (whole && least >= 0.0 && most - least > kWideRange)
        m_from = std::max(least, 1.0);
    const int steps = whole && !logarithmic() ? int(std::min(most - least, double(kSliderSteps))) : kSliderSteps;
    m_values.push_back(least);
    for (int i = 0; i <= steps; ++i) {
        const double share = steps > 0 ? double(i) / steps : 1.0;
        double value = logarithmic() ? rounded(m_from * std::pow(most / m_from, share)) : least + share * (most - least);
        if (i == steps) value = most;
        if (whole) value = std::round(value);
        if (value > m_values.back() && value <= most) m_values.push_back(value);
    }
}

int SliderScale::positionOf(double value) const {
    const auto above = std::ranges::lower_bound(m_values, value);
    if (above == m_values.end()) return last();
    const auto position = int(above - m_values.begin());
    return position > 0 && value - m_values[size_t(position) - 1] < *above - value ? position - 1 : position;
}

int SliderScale::decimals() const {
    const double finest =
        logarithmic() ? m_from * std::pow(10.0, 1 - kDigits) : (m_values.back() - m_values.front()) / kSliderSteps;
    return finest > 0.0 ? std::clamp(int(std::ceil(-std::log10(finest) - 1e-9)), 0, 9) : 3;
}

NumberField::NumberField(const ParameterDeclaration& declaration, const ParameterValue& value, QWidget* parent)
    : QWidget(parent), m_scale(declaration), m_slider(new QSlider(Qt::Horizontal, this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    leaveWheelUnlessFocused(*m_slider);
    m_slider->setRange(0, m_scale.last());
    m_slider->setPageStep(std::max(1, m_scale.last() / 20));
    m_slider->setAccessibleName(QString::fromStdString(declaration.key));
    if (const auto* whole = std::get_if<int64_t>(&value))
        addWholeNumber(declaration, *whole);
    else
        addReal(declaration, std::get<double>(value));
    m_number->setAccessibleName(QString::fromStdString(declaration.key));
    leaveWheelUnlessFocused(*m_number);
    leaveUndoToTheWindow(*m_number);
    setFocusProxy(m_number);
    row->addWidget(m_slider, 1);
    row->addWidget(m_number);
    connect(m_slider, &QSlider::valueChanged, this, [this](int position) { m_set(m_scale.valueAt(position)); });
}

void NumberField::addWholeNumber(const ParameterDeclaration& declaration, int64_t value) {
    auto* box = new QSpinBox(this);
    m_number = box;
    const auto bounded = [](double number) { return int(std::clamp(number, double(INT_MIN), double(INT_MAX))); };
    box->setRange(bounded(declaration.minimum), bounded(declaration.maximum));
    box->setSuffix(suffix(declaration));
    box->setGroupSeparatorShown(true);
    if (m_scale.logarithmic()) box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setValue(int(value));
    follow(double(value));
    m_set = [box](double number) { box->setValue(int(number)); };
    connect(box, &QSpinBox::valueChanged, this, [this](int number) {
        follow(double(number));
        emit changed(int64_t(number));
    });
}

void NumberField::addReal(const ParameterDeclaration& declaration, double value) {
    auto* box = m_scale.logarithmic() ? new WideNumberBox(this) : new QDoubleSpinBox(this);
    m_number = box;
    box->setDecimals(m_scale.decimals());
    box->setRange(declaration.minimum, declaration.maximum);
    box->setSingleStep(std::max((declaration.maximum - declaration.minimum) / 100.0, std::pow(10.0, -box->decimals())));
    if (m_scale.logarithmic()) box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setSuffix(suffix(declaration));
    box->setValue(value);
    follow(value);
    m_set = [box](double number) { box->setValue(number); };
    connect(box, &QDoubleSpinBox::valueChanged, this, [this](double number) {
        follow(number);
        emit changed(number);
    });
}

void NumberField::follow(double value) {
    // While the user drags it, the slider stays where the pointer is.
    if (m_slider->isSliderDown()) return;
    const QSignalBlocker quiet(m_slider);
    m_slider->setValue(m_scale.positionOf(value));
}

}  // namespace cullscope::ui
