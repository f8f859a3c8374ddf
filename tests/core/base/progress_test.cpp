#include "core/base/progress.h"
#include "core/base/error.h"

namespace cullscope::progress_test {
namespace {

TEST(Progress, partReportsWithinItsShare) {
    std::vector<double> shares;
    const Progress whole{[&](double share, std::string_view) { shares.push_back(share); }, {}};
    const Progress part = whole.part(0.25, 0.75);
    part.tell(0.0, "");
    part.tell(0.5, "");
    part.part(0.5, 1.0).tell(1.0, "");
    EXPECT_THAT(shares, testing::ElementsAre(0.25, 0.5, 0.75));
}

TEST(Progress, stopIsSeenThroughAPart) {
    std::stop_source source;
    const Progress whole{nullptr, source.get_token()};
    const Progress part = whole.part(0.0, 0.5);
    EXPECT_NO_THROW(part.check());
    part.tell(1.0, "without a listener");
    source.request_stop();
    EXPECT_TRUE(part.stopRequested());
    EXPECT_THROW(part.check(), Error);
}

}  // namespace
}  // namespace cullscope::progress_test
