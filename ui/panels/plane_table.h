#pragma once

#include <QTableWidget>
#include <vector>

#include "core/visibility/why.h"

namespace cullscope::ui {

/// The plane tests of a chain of decisions: signed distance and bound of each, and a bar that shows the distance in multiples of
/// the bound, logarithmically. What lies outside goes to the left, hatched; the line at −bound is where "outside" begins.
class PlaneTable : public QTableWidget {
    Q_OBJECT

public:
    explicit PlaneTable(QWidget* parent = nullptr);

    void setSteps(const std::vector<WhyStep>& steps);
    void retranslate();

private:
    enum Column { Plane, Distance, Bound, Bar, ColumnCount };

    void fillRow(int row, const WhyStep& step);
};

}  // namespace cullscope::ui
