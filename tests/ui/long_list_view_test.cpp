#include "ui/panels/long_list_view.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QStandardItemModel>

namespace cullscope::ui::long_list_view_test {
namespace {

TEST(LongListView, theCurrentRowStaysInViewWhereTheListBecomesLower) {
    QStandardItemModel rows;
    for (int row = 0; row < 100; ++row) rows.appendRow(new QStandardItem(QString::number(row)));
    QWidget window;
    window.resize(400, 400);
    LongListView list;
    list.setParent(&window);
    list.setModel(&rows);
    list.resize(400, 300);
    window.show();
    QApplication::processEvents();
    const QModelIndex last = list.indexAt({1, list.viewport()->height() - list.sizeHintForRow(0) - 1});
    ASSERT_TRUE(last.isValid());
    list.setCurrentIndex(last);
    list.resize(400, 120);
    QApplication::processEvents();
    EXPECT_TRUE(list.viewport()->rect().contains(list.visualRect(last).center())) << "what a step has in hand";
    list.scrollToTop();
    list.resize(400, 100);
    QApplication::processEvents();
    EXPECT_EQ(list.indexAt({1, 1}).row(), 0) << "the user has scrolled it away";
}

}  // namespace
}  // namespace cullscope::ui::long_list_view_test
