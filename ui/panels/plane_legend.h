#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QWidget>
#include <array>
#include <optional>

#include "core/image/plane_colours.h"

namespace cullscope::ui {

/// What the colours of boxes mean where they tell the plane that rejected them, with the numbers of objects.
class PlaneLegend : public QWidget {
    Q_OBJECT

public:
    explicit PlaneLegend(QWidget* parent = nullptr);

    /// None: not known yet.
    void setCounts(const std::optional<PlaneCounts>& counts);
    /// As many rows as that, in one column or two.
    void setRows(int rows);
    void retranslate();

private:
    /// The six planes, then what was rejected without one, then what was kept.
    static constexpr size_t kLines = kFrustumPlaneCount + 2;

    [[nodiscard]] static QString wordsOf(size_t line);
    [[nodiscard]] static uint64_t countOf(const PlaneCounts& counts, size_t line);

    std::optional<PlaneCounts> m_counts;
    QLabel* m_heading;
    QGridLayout* m_grid;
    std::array<QWidget*, kLines> m_swatches{};
    std::array<QLabel*, kLines> m_words{}, m_numbers{};
};

}  // namespace cullscope::ui
