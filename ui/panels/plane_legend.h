#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QWidget>
#include <array>
#include <optional>

#include "core/visibility/plane_colours.h"

namespace cullscope::ui {

/// The legend of boxes that are coloured by the plane that rejected them, with the numbers of objects.
class PlaneLegend : public QWidget {
    Q_OBJECT

public:
    explicit PlaneLegend(QWidget* parent = nullptr);

    /// Sets the counts; none: not known yet.
    void setCounts(const std::optional<PlaneCounts>& counts);
    /// Sets the number of rows; entries that do not fit go to a second column.
    void setRows(int rows);
    void retranslate();

private:
    /// One line per plane, one for boxes rejected without a single plane, one for kept boxes.
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
