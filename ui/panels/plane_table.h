#pragma once

#include <QTableWidget>
#include <vector>

#include "core/visibility/plane_distances.h"
#include "core/visibility/why.h"

namespace cullscope::ui {

/// The plane tests of a chain of decisions: signed distance and bound of each, and a bar that shows the distance in multiples of
/// the bound, logarithmically. What lies outside goes to the left, hatched; the line at −bound is where "outside" begins. Planes
/// that the strategy did not test stand below in grey.
class PlaneTable : public QTableWidget {
    Q_OBJECT

public:
    explicit PlaneTable(QWidget* parent = nullptr);

    /// `own`: how the object's own bounds lie to every plane; empty: only what was tested is shown.
    void setSteps(const std::vector<WhyStep>& steps, const std::vector<PlaneDistance>& own);
    /// Whether any plane stands there that the strategy did not test.
    [[nodiscard]] bool showsUntested() const;
    void retranslate();

private:
    enum Column { Plane, Distance, Bound, Bar, ColumnCount };

    struct Row {
        PlaneDistance test;
        QString sentence;
        bool tested = true;
    };

    [[nodiscard]] static std::vector<Row> rowsOf(const std::vector<WhyStep>& steps, const std::vector<PlaneDistance>& own);
    void fillRow(int number, const Row& row, double largest);

    std::vector<Row> m_rows;
};

}  // namespace cullscope::ui
