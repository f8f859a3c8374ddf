// What cullbench says of the interval of frames that were drawn once.

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/cullbench_contract.h"

namespace cullscope::test::intervals_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

using CullbenchIntervals = CullbenchContract;

struct Measured {
    std::string out;
    json interval;  ///< of `all` against itself, which is 1 in every resample
};

TEST_F(CullbenchIntervals, oneRepetitionOfOneViewHasNone) {
    const auto measured = [&](const std::string& path, const std::string& repetitions) {
        const ProcessResult result = cullbench({"measure", "torus:triangles=500", "-s", "all,backface", "--path", path, "--size",
                                                "32x32", "--repeat", repetitions, "--json", file("r.json")});
        EXPECT_EQ(result.exitStatus, 0) << result.err;
        std::ifstream in(file("r.json"));
        return Measured{result.out, json::parse(in)["runs"][0]["summary"]["ratio_to_all_ci95"]};
    };
    const json one = json::array({1.0, 1.0});
    const Measured single = measured("orbit:1", "1");
    EXPECT_TRUE(single.interval.is_null()) << single.interval;
    EXPECT_THAT(single.out, HasSubstr("One repetition of one view: no interval."));
    EXPECT_THAT(single.out, Not(HasSubstr("[1.00,1.00]")));
    const Measured views = measured("orbit:2", "1");
    EXPECT_EQ(views.interval, one);
    EXPECT_THAT(views.out, HasSubstr("One repetition: the intervals are of the scatter between the views"));
    const Measured repeated = measured("orbit:1", "2");
    EXPECT_EQ(repeated.interval, one);
    EXPECT_THAT(repeated.out, HasSubstr("[1.00,1.00]"));
    EXPECT_THAT(repeated.out, Not(HasSubstr("One repetition")));
}

}  // namespace
}  // namespace cullscope::test::intervals_test
