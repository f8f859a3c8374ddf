#pragma once

#include <QTableWidget>
#include <vector>

#include "core/visibility/plane_distances.h"
#include "core/visibility/why.h"

namespace cullscope::ui {

/// The plane tests of the object in a chain of decisions: signed distance and bound of each, and a bar of the distance in
/// multiples of the bound on a logarithmic scale. The bar of a distance outside points to the left and is hatched; "outside"
/// begins at the line at −bound. Planes that the strategy did not test are listed below in grey.
class PlaneTable : public QTableWidget {
    Q_OBJECT

public:
    explicit PlaneTable(QWidget* parent = nullptr);

    /// `own`: distances of the object's own bounds to all planes; empty: only tested planes are listed.
    void setSteps(const std::vector<WhyStep>& steps, const std::vector<PlaneDistance>& own);
    /// Whether the table lists a plane that the strategy did not test.
    [[nodiscard]] bool showsUntested() const;
    void retranslate();

protected:
    void changeEvent(QEvent* event) override;

private:
    enum Column { Plane, Distance, Bound, Bar, ColumnCount };

    struct Row {
        PlaneDistance test;
        QString sentence;
        bool tested = true;
    };

    [[nodiscard]] static std::vector<Row> rowsOf(const std::vector<WhyStep>& steps, const std::vector<PlaneDistance>& own);
    void fitRows();
    void fitBarHeading(int width);
    void fillRow(int number, const Row& row, double largest);

    std::vector<Row> m_rows;
};

}  // namespace cullscope::ui
