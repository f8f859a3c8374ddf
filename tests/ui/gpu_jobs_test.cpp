#include "ui/jobs/gpu_jobs.h"

#include <gtest/gtest.h>

#include <atomic>

#include "tests/ui/test_scene.h"

namespace cullscope::ui::gpu_jobs_test {
namespace {

using Step = GpuJobs::Step;

SceneBuffersPointer uploaded(GpuThread& gpu) {
    SceneBuffersPointer buffers;
    gpu.run([&] { buffers = gpu.upload(openScene("sphere:triangles=20").scene); });
    return buffers;
}

TEST(GpuJobs, onlyTheNewestIsBegunAndBringsSomething) {
    GpuThread gpu;
    GpuJobs jobs;
    std::atomic<bool> release{false};
    std::atomic<int> begun{0};
    std::vector<int> delivered;
    gpu.post([&] {
        while (!release) std::this_thread::yield();
    });
    for (int i = 0; i < 5; ++i)
        jobs.start(gpu, [&, i](Step& step) {
            ++begun;
            step.deliver([&delivered, i] { delivered.push_back(i); });
        });
    EXPECT_TRUE(jobs.busy());
    release = true;
    ASSERT_TRUE(waitUntil([&] { return !jobs.busy(); }));
    EXPECT_EQ(begun, 1);
    EXPECT_EQ(delivered, std::vector<int>{4});
}

TEST(GpuJobs, addedOnesCountBesideEachOther) {
    GpuThread gpu;
    GpuJobs jobs;
    std::vector<int> delivered;
    for (int i = 0; i < 3; ++i) jobs.add(gpu, [&, i](Step& step) { step.deliver([&delivered, i] { delivered.push_back(i); }); });
    ASSERT_TRUE(waitUntil([&] { return !jobs.busy(); }));
    EXPECT_EQ(delivered, (std::vector<int>{0, 1, 2}));
}

TEST(GpuJobs, stepsBringTheirsOneByOneUntilTheJobIsCancelled) {
    GpuThread gpu;
    GpuJobs jobs;
    std::atomic<int> steps{0};
    int delivered = 0;
    const auto work = [&](Step& step) {
        ++steps;
        step.deliver([&] { ++delivered; });
        if (steps % 3 != 0) step.again();
    };
    jobs.start(gpu, work);
    ASSERT_TRUE(waitUntil([&] { return !jobs.busy(); }));
    EXPECT_EQ(steps, 3);
    EXPECT_EQ(delivered, 3);
    jobs.start(gpu, [&](Step& step) {
        QThread::msleep(1);
        step.deliver([&] { ++delivered; });
        step.again();
    });
    ASSERT_TRUE(waitUntil([&] { return delivered > 5; }));
    jobs.cancel();
    const int before = delivered;
    EXPECT_FALSE(jobs.busy());
    QTest::qWait(50);
    EXPECT_EQ(delivered, before);
}

TEST(GpuJobs, endOfTheOwnerWaitsForTheStepInHand) {
    GpuThread gpu;
    std::atomic<bool> begun{false}, done{false};
    auto jobs = std::make_unique<GpuJobs>();
    jobs->start(gpu, [&](Step& step) {
        begun = true;
        QThread::msleep(50);
        done = true;
        step.deliver([] { FAIL() << "its owner is gone"; });
        step.again();
    });
    while (!begun) std::this_thread::yield();
    jobs.reset();
    EXPECT_TRUE(done);
    QTest::qWait(20);
}

TEST(GpuJobs, whatTheLossOfTheContextSpoilsIsDropped) {
    std::atomic<bool> lost{false};
    GpuThread gpu({.lost = [&] { return lost.exchange(false); }, .context = {}});
    GpuJobs jobs;
    const SceneBuffersPointer buffers = uploaded(gpu);
    int brought = 0, told = 0;
    const auto work = [&](Step& step) {
        lost = brought > 0;
        if (lost) step.again();
        step.deliver([&] { ++brought; });
    };
    const auto run = [&] {
        jobs.start(gpu, work, {.buffers = {buffers}, .lost = [&] { ++told; }});
        EXPECT_TRUE(waitUntil([&] { return !jobs.busy(); }));
    };
    run();
    EXPECT_EQ(brought, 1);
    EXPECT_EQ(told, 0);
    run();
    EXPECT_EQ(brought, 1) << "lost in the work";
    EXPECT_EQ(told, 1);
    run();
    EXPECT_EQ(brought, 1) << "lost before: the buffers are of the old context";
    EXPECT_EQ(told, 2);
}

}  // namespace
}  // namespace cullscope::ui::gpu_jobs_test
