#include "core/base/progress.h"

#include "core/base/error.h"

namespace cullscope {

void Progress::check() const {
    if (stop.stop_requested()) throwInterrupted();
}

Progress Progress::part(double from, double to) const {
    Progress sub{nullptr, stop};
    if (report)
        sub.report = [outer = report, from, to](double share, std::string_view stage) {
            outer(from + (to - from) * share, stage);
        };
    return sub;
}

}  // namespace cullscope
