#include "ui/jobs/view_metrics.h"

#include <algorithm>
#include <cassert>

namespace cullscope::ui {

double median(std::vector<double> values) {
    assert(!values.empty());
    std::sort(values.begin(), values.end());
    const size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace cullscope::ui
