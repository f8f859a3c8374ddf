// What is asked for by a number or by nesting is refused before it takes memory and time.
#include <gmock/gmock.h>

#include "core/scene/generator_memory.h"
#include "core/scene/scene_source.h"
#include "tests/support/peak_memory.h"
#include "tests/support/refusal.h"

namespace cullscope::scene_limits_test {
namespace {

using testing::HasSubstr;

std::string refusalWithin(size_t bytes, const std::string& specification) {
    SceneSourceOptions options;
    options.load.memoryLimitBytes = bytes;
    return test::refusalOf([&] { (void)openScene(specification, options); }, ErrorKind::Usage);
}

TEST(SceneLimits, generatorsHaveTheMemoryLimitOfFiles) {
    constexpr size_t kMegabyte = 1'000'000;
    for (const char* specification :
         {"sphere:triangles=2e9", "torus:triangles=1e6", "bowl:triangles=1e6", "knot:triangles=1e6", "star:triangles=1e6",
          "teapot:triangles=1e6", "layers:count=1,triangles=1e6", "layers:count=1e5,triangles=2",
          "field:mesh=sphere:triangles=80,n=2000", "plant:pipelines=1e6",
          "mesh:field:mesh=sphere:triangles=2000,n=20,triangles=100", "split:mesh=torus:triangles=1e6"}) {
        const std::string sentence = refusalWithin(kMegabyte, specification);
        EXPECT_THAT(sentence, HasSubstr("MB of memory, more than the 0 MB allowed. Ask for fewer")) << specification;
    }
    EXPECT_EQ(refusalWithin(kMegabyte, "field:mesh=sphere:triangles=2000,n=20"), "");
    EXPECT_THAT(refusalWithin(kMegabyte, "sphere:triangles=2e9"), HasSubstr("sphere: a scene of this size needs about 76294 MB"));
}

TEST(SceneLimits, generatorsTakeNoMoreMemoryThanIsPlanned) {
    if (!test::memoryIsTheWorks()) GTEST_SKIP() << "the sanitizer's memory would be measured";
    constexpr double kOther = 4e6;  // of the process: stacks, and pages that are not full
    const auto peakOf = [](const char* specification) {
        return double(test::peakBytesOf([&] { (void)openScene(specification); }));
    };
    for (const char* shape : {"sphere:triangles=1e6", "torus:triangles=1e6", "bowl:triangles=1e6", "knot:triangles=1e6",
                              "star:triangles=1e6", "teapot:triangles=1e6", "layers:count=1,triangles=1e6"})
        EXPECT_LT(peakOf(shape), 1e6 * kBytesOfMadeTriangle + kOther) << shape;
    EXPECT_LT(peakOf("field:mesh=sphere:triangles=80,n=400"), 160'000 * kBytesOfInstance + kOther);
    EXPECT_LT(peakOf("plant:pipelines=1000"), 1000 * kBytesOfPipeline + kOther);
}

std::string nested(const std::string& outer, size_t times, const std::string& inner) {
    std::string text;
    for (size_t i = 0; i < times; ++i) text += outer;
    return text + inner;
}

TEST(SceneLimits, generatorsAreNestedUpToADepth) {
    for (const char* outer : {"mesh:", "split:mesh=", "field:mesh="}) {
        EXPECT_THAT(test::refusalOf([&] { (void)openScene(nested(outer, 65, "sphere:triangles=80")); }, ErrorKind::Usage),
                    HasSubstr("More than 64 generators"))
            << outer;
        // 64 of them are cut as before; what is refused is the file.
        EXPECT_THAT(test::refusalOf([&] { (void)openScene(nested(outer, 64, "/no/such.obj")); }, ErrorKind::Input),
                    HasSubstr("/no/such.obj"))
            << outer;
    }
}

TEST(SceneLimits, aMillionNestedGeneratorsTakeNoMemory) {
    const std::string text = nested("mesh:", 1'000'000, "sphere:triangles=80");
    const auto same = [](const std::string& file) { return file; };
    for (const auto& work :
         {std::function<void()>([&] { (void)openScene(text); }), std::function<void()>([&] { (void)withFiles(text, same); })}) {
        EXPECT_THAT(test::refusalOf(work, ErrorKind::Usage), HasSubstr("More than 64 generators"));
        if (!test::memoryIsTheWorks()) continue;
        EXPECT_LT(test::peakBytesOf(work), 10 * text.size());
    }
}

}  // namespace
}  // namespace cullscope::scene_limits_test
