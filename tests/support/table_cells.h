#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/experiments/result_table.h"

namespace cullscope::test {

/// A cell of a table by its column's key; a failure of the test where there is no such column.
inline const CellValue& valueOf(const ResultTable& table, size_t row, const std::string& key) {
    for (size_t i = 0; i < table.columns.size(); ++i)
        if (table.columns[i].key == key) return table.rows.at(row).at(i);
    ADD_FAILURE() << "there is no column " << key;
    static const CellValue kNothing;
    return kNothing;
}
inline double number(const ResultTable& table, size_t row, const std::string& key) {
    return std::get<double>(valueOf(table, row, key));
}

}  // namespace cullscope::test
