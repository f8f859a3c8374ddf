#pragma once

#include <QSlider>
#include <QWidget>
#include <functional>
#include <vector>

#include "core/visibility/parameters.h"

namespace cullscope::ui {

/// The numbers at which a slider over a declared range may stand: both ends, and up to a thousand between them. Whole numbers of
/// a short range are one each. Over a logarithmic range the numbers are apart by a factor and have three digits; the first one is
/// the minimum, also where the logarithm begins above it (ParameterDeclaration::logarithmicFrom).
class SliderScale {
public:
    explicit SliderScale(const ParameterDeclaration& declaration);

    [[nodiscard]] int last() const { return int(m_values.size()) - 1; }
    [[nodiscard]] bool logarithmic() const { return m_from > 0.0; }
    [[nodiscard]] double valueAt(int position) const { return m_values[size_t(position)]; }
    /// The nearest position.
    [[nodiscard]] int positionOf(double value) const;
    /// The number of decimals that tell the positions apart.
    [[nodiscard]] int decimals() const;

private:
    double m_from = 0.0;           ///< where the logarithm begins; 0: the range is linear
    std::vector<double> m_values;  ///< ascending
};

/// A slider and a box with the number for one declared number, whole or not. Each follows the other.
class NumberField : public QWidget {
    Q_OBJECT

public:
    NumberField(const ParameterDeclaration& declaration, const ParameterValue& value, QWidget* parent = nullptr);

    [[nodiscard]] QSlider& slider() { return *m_slider; }
    [[nodiscard]] QWidget& number() { return *m_number; }

signals:
    /// The user changed the number.
    void changed(const cullscope::ParameterValue& value);

private:
    void addWholeNumber(const ParameterDeclaration& declaration, int64_t value);
    void addReal(const ParameterDeclaration& declaration, double value);
    /// Moves the slider without an echo.
    void follow(double value);

    SliderScale m_scale;
    QSlider* m_slider;
    QWidget* m_number = nullptr;
    std::function<void(double)> m_set;
};

}  // namespace cullscope::ui
