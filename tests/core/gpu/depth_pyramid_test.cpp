// Boxes against a depth pyramid, held against the depth of every pixel: in pictures of any size, perspective and parallel; and
// what is drawn by its answers, indirectly or as a list.

#include <cmath>
#include <cstdio>
#include <limits>

#include "core/base/error.h"
#include "core/geometry/random.h"
#include "core/gpu/gpu_frame.h"
#include "core/mesh/parametric.h"
#include "tests/support/gl_environment.h"
#include "tests/support/long_mode.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::depth_pyramid_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Camera standardCamera() { return {Vec3(0.0), Vec3(0, 0, -1), Vec3(0, 1, 0), Angle::fromDegrees(90), 0.1, 10}; }

EyeBox box(const Vec3& min, const Vec3& max) { return {0.5 * (min + max), 0.5 * (max - min)}; }

/// The corner of a box as a place in the picture, and its reversed depth; in double.
Vec3 placeOf(const View& view, const EyeBox& box, int corner) {
    const Vec3 side((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
    const Vec4 clip = view.clipFromEyeRelative() * Vec4(box.centre + side * box.halfExtent, 1.0);
    return {(0.5 * clip.x / clip.w + 0.5) * view.viewport().width, (0.5 * clip.y / clip.w + 0.5) * view.viewport().height,
            clip.z / clip.w};
}

/// The pixels of a rectangle around a box, `around` more on each side, and the depth of the box's nearest point.
struct Rectangle {
    Rectangle(const View& view, const EyeBox& box, double around) {
        Vec3 low(1e30), high(-1e30);
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 place = placeOf(view, box, corner);
            low = glm::min(low, place);
            high = glm::max(high, place);
        }
        const Viewport size = view.viewport();
        left = int(std::clamp(std::floor(low.x - around), 0.0, size.width - 1.0));
        right = int(std::clamp(std::floor(high.x + around), 0.0, size.width - 1.0));
        bottom = int(std::clamp(std::floor(low.y - around), 0.0, size.height - 1.0));
        top = int(std::clamp(std::floor(high.y + around), 0.0, size.height - 1.0));
        nearest = high.z;
    }
    [[nodiscard]] float farthestOf(const FinishedPicture& picture) const {
        float farthest = 1.0f;
        for (int y = bottom; y <= top; ++y)
            for (int x = left; x <= right; ++x)
                farthest = std::min(farthest, picture.depth[size_t(y) * size_t(picture.size.width) + size_t(x)]);
        return farthest;
    }

    int left = 0, right = 0, bottom = 0, top = 0;
    double nearest = 0.0;
};

/// A wall with holes of single pixels, some at the borders.
FinishedPicturePointer wallWithHoles(const Viewport& size, float depth, Random& random) {
    auto picture = std::make_shared<FinishedPicture>();
    picture->size = size;
    const size_t pixels = size_t(size.width) * size_t(size.height);
    picture->triangle.assign(pixels, 1);
    picture->depth.assign(pixels, depth);
    const int holes = int(random.between(0, 4));
    for (int hole = 0; hole < holes; ++hole) {
        const auto place = [&](int length) {
            const int at = int(random.between(-0.3 * length, 1.3 * length));
            return size_t(std::clamp(at, 0, length - 1));
        };
        const size_t column = place(size.width), row = place(size.height);
        picture->depth[row * size_t(size.width) + column] = random.between(0, 1) < 0.5 ? 0.0f : 0.5f * depth;
    }
    return picture;
}

/// A box behind or before the wall, of a pixel to several times the picture, also beside it.
EyeBox randomBox(const View& view, double wall, Random& random) {
    const Frustum& frustum = view.frustum();
    const double ahead = wall * random.between(0.9, 2.0), up = frustum.halfHeightAt(ahead);
    const double pixel = 2.0 * up / view.viewport().height;
    const double aspect = double(view.viewport().width) / view.viewport().height;
    const Vec3 centre(random.between(-1.2, 1.2) * up * aspect, random.between(-1.2, 1.2) * up, -ahead);
    const auto extent = [&] { return pixel * std::pow(10.0, random.between(-0.5, 2.5)); };
    return {centre, {extent(), extent(), std::min(extent(), 0.5 * ahead)}};
}

struct Tally {
    uint64_t boxes = 0, hidden = 0, shown = 0, hiddenByPixels = 0, coarse = 0;
};

void compare(const View& view, const FinishedPicture& picture, std::span<const EyeBox> boxes, Tally& tally,
             const std::string& where) {
    Renderer& renderer = GlEnvironment::renderer();
    Framebuffer target(picture.size);
    target.setDepth(std::make_shared<FinishedPicture>(picture));
    const BoxTicketPointer ticket = renderer.askPyramid(view, boxes, target);
    const std::vector<uint32_t> visible = *renderer.answer(*ticket);
    const std::vector<PyramidReading> readings = renderer.readings(*ticket);
    ASSERT_EQ(readings.size(), boxes.size());
    for (uint32_t i = 0; i < boxes.size(); ++i) {
        // The box without the thousandth of a pixel by which its float projection may be displaced.
        const Rectangle inner(view, boxes[i], -0.001), outer(view, boxes[i], 0.001);
        const PyramidReading& reading = readings[i];
        const bool hidden = !std::ranges::binary_search(visible, i);
        const std::string what = where + ", box " + std::to_string(i) + ", level " + std::to_string(reading.level);
        EXPECT_EQ(hidden, reading.nearest < reading.farthest) << what;
        EXPECT_NEAR(reading.nearest, std::max(inner.nearest, 0.0), 1e-5 * inner.nearest) << what;
        EXPECT_LE(reading.farthest, inner.farthestOf(picture)) << what << ": a farther pixel was overlooked";
        // Texels stand for their own pixels and no others.
        const int side = 1 << reading.level;
        Rectangle blocks = outer;
        blocks.left -= blocks.left % side;
        blocks.bottom -= blocks.bottom % side;
        blocks.right = std::min(blocks.right - blocks.right % side + side - 1, view.viewport().width - 1);
        blocks.top = std::min(blocks.top - blocks.top % side + side - 1, view.viewport().height - 1);
        EXPECT_GE(reading.farthest, blocks.farthestOf(picture)) << what;
        // The level is the lowest with four texels at most along each side.
        EXPECT_TRUE(reading.texels >= 1 && reading.texels <= 16) << what;
        if (reading.level > 0) {
            const int below = side / 2;
            EXPECT_TRUE(outer.right / below - outer.left / below >= 4 || outer.top / below - outer.bottom / below >= 4) << what;
        }
        ++tally.boxes;
        ++(hidden ? tally.hidden : tally.shown);
        tally.hiddenByPixels += inner.nearest < inner.farthestOf(picture) ? 1 : 0;
        tally.coarse += reading.level > 2 ? 1 : 0;
    }
}

TEST(DepthPyramid, hidesNoBoxThatShowsAPixelInPicturesOfAnySizeUpTo1025) {
    Tally tally;
    const uint64_t pictures = howMany(4000, 200);
    for (uint64_t seed = 1; seed <= pictures; ++seed) {
        Random random(seed);
        // Every width and height from 1 to 1,025 comes, with a length of its own on the other side.
        const int length = 1 + int((seed * 1024) / pictures);
        const int other = std::max(1, int(std::pow(2.0, random.between(0, 9)))) + int(random.between(0, 2));
        const Viewport size = seed % 2 == 0 ? Viewport{length, other} : Viewport{other, length};
        const View view(seed % 3 == 0 ? inParallel(standardCamera()) : standardCamera(), size);
        const double wall = 3.0;
        const FinishedPicturePointer picture = wallWithHoles(size, float(view.depthFromDistance(wall)), random);
        std::vector<EyeBox> boxes;
        while (boxes.size() < 24) boxes.push_back(randomBox(view, wall, random));
        compare(view, *picture, boxes, tally,
                "seed " + std::to_string(seed) + ", " + std::to_string(size.width) + " × " + std::to_string(size.height));
    }
    std::printf("long: depth-pyramid boxes %llu hidden %llu of %llu by all pixels, shown %llu, above level 2 %llu\n",
                static_cast<unsigned long long>(tally.boxes), static_cast<unsigned long long>(tally.hidden),
                static_cast<unsigned long long>(tally.hiddenByPixels), static_cast<unsigned long long>(tally.shown),
                static_cast<unsigned long long>(tally.coarse));
    EXPECT_GT(tally.hidden, tally.hiddenByPixels * 9 / 10) << "the levels are too coarse";
    EXPECT_GT(tally.hidden, tally.boxes / 5);
    EXPECT_GT(tally.shown, tally.boxes / 5);
    EXPECT_GT(tally.coarse, tally.boxes / 10);
}

TEST(DepthPyramid, boxBeforeTheNearPlaneOrOfNoNumbersIsVisible) {
    const View view(standardCamera(), {33, 17});
    Framebuffer target(view.viewport());
    auto wall = std::make_shared<FinishedPicture>();
    wall->size = view.viewport();
    wall->depth.assign(33u * 17u, 1.0f);  // at the near plane
    target.setDepth(wall);
    const double nan = std::numeric_limits<double>::quiet_NaN(), much = 1e300;
    const std::vector<EyeBox> boxes{box({-1, -1, -6}, {1, 1, -4}),     // hidden
                                    box({-1, -1, -3}, {1, 1, -0.05}),  // across the near plane
                                    box({-1, -1, -3}, {1, 1, 3}),      // around the eye
                                    box({-9, -9, 4}, {9, 9, 6}),       // behind it
                                    box({-.01, -.01, -.06}, {.01, .01, -.05}),
                                    box({-50, -50, -50}, {50, 50, -0.2}),  // hidden, larger than the picture
                                    {Vec3(0, 0, -5), Vec3(nan)},
                                    {Vec3(nan, 0, -5), Vec3(1)},
                                    {Vec3(0, 0, -5), Vec3(much, 1, 1)},
                                    {Vec3(much, much, -much), Vec3(much)},
                                    box({7, -1, -6}, {9, 1, -4}),      // beside the picture: it has no pixel there
                                    box({-1, -1, -20}, {1, 1, -14})};  // beyond the far plane
    Renderer& renderer = GlEnvironment::renderer();
    const BoxTicketPointer ticket = renderer.askPyramid(view, boxes, target);
    EXPECT_THAT(*renderer.answer(*ticket), ElementsAre(1, 2, 3, 4, 6, 7, 8, 9));
    const std::vector<PyramidReading> readings = renderer.readings(*ticket);
    const std::vector<uint32_t> visible = *renderer.answer(*ticket);
    for (const uint32_t number : visible) EXPECT_EQ(readings[number].texels, 0u) << number;
    // Where nothing is drawn nothing is hidden, also beyond the far plane.
    target.dropDepth();
    renderer.clear(view, target, {});
    EXPECT_EQ(renderer.answer(*renderer.askPyramid(view, boxes, target))->size(), boxes.size());
}

TEST(DepthPyramid, groupIsVisibleWhereOneOfItsBoxesIsAndAnswersStayThoseOfTheirPicture) {
    const ScenePointer scene = sceneOf({squareMesh(20, -3)});
    const SceneBuffers buffers(scene, Upload::Vbo);
    Renderer& renderer = GlEnvironment::renderer();
    const View view(standardCamera(), {101, 99});
    Framebuffer target(view.viewport());
    renderer.draw(buffers, view, everything(*scene, Facing::TwoSided), target);
    const EyeBox behind = box({-1, -1, -6}, {1, 1, -4}), before = box({-1, -1, -2.5}, {1, 1, -2});
    const std::vector<EyeBox> boxes{behind, behind, behind, before, before, behind, behind};
    const std::vector<uint32_t> ends{2, 4, 5, 6, 7};
    const BoxTicketPointer first = renderer.askPyramid(view, boxes, target, ends);
    renderer.clear(view, target, {});
    const BoxTicketPointer second = renderer.askPyramid(view, boxes, target);
    EXPECT_THAT(*renderer.answer(*first), ElementsAre(1, 2));
    EXPECT_THAT(*renderer.answer(*second), ElementsAre(0, 1, 2, 3, 4, 5, 6));
    EXPECT_THAT(*renderer.answer(*first), ElementsAre(1, 2)) << "at every call the same";
    EXPECT_EQ(first->answers(), ends.size());
    EXPECT_THAT(*renderer.answer(*renderer.askPyramid(view, {}, target)), IsEmpty());
    // A ticket outlives its renderer, and is nothing to another one.
    auto other = std::make_unique<Renderer>();
    const BoxTicketPointer foreign = other->askPyramid(view, boxes, target);
    EXPECT_FALSE(renderer.answer(*foreign).has_value());
    other.reset();
    EXPECT_FALSE(renderer.answer(*foreign).has_value());
    EXPECT_THAT(renderer.readings(*foreign), IsEmpty());
}

/// A wall and spheres beside, before and behind it; the wall first.
ScenePointer wallAndSpheres() {
    std::vector<MeshPointer> meshes{squareMesh(1, -3)};
    std::vector<Mat4> places{Mat4(1.0)};
    for (int i = 0; i < 40; ++i) {
        meshes.push_back(sphereMesh(80));
        places.push_back(translation({-4.0 + 0.2 * i, 0.3 * (i % 5) - 0.6, i % 7 == 0 ? -2.0 : -6.0 - 0.05 * i}) *
                         scaling(Vec3(0.12)));
    }
    return sceneOf(std::move(meshes), places);
}

/// What a frame shows that draws the wall, and of the spheres what its depth pyramid finds visible.
struct TwoPasses {
    TwoPasses(Renderer& renderer, const SceneBuffers& buffers, const View& view, bool drawn) {
        const Scene& scene = buffers.scene();
        Framebuffer target(view.viewport());
        std::unique_ptr<GpuFrame> frame = drawn ? std::make_unique<GpuFrame>(renderer, buffers, view, target, DrawStyle{})
                                                : std::make_unique<GpuFrame>(renderer, buffers, view);
        const auto whole = [&](uint32_t i) { return DrawRange{i, 0, uint32_t(scene.meshOf(i).indices().size())}; };
        frame->draw(DrawList{Facing::TwoSided, {whole(0)}});
        DrawList candidates{Facing::TwoSided, {}};
        std::vector<EyeBox> boxes;
        for (uint32_t i = 1; i < scene.instances().size(); ++i) {
            candidates.ranges.push_back(whole(i));
            boxes.push_back(relativeToEye(scene.instanceBox(i), view.eye()));
        }
        const BoxTicketPointer ticket = frame->ask(boxes, BoxQuestion::Pyramid);
        frame->drawVisible(*ticket, candidates);
        visible = *frame->answer(*ticket);
        log = frame->take();
        if (drawn) picture = {target.readColour(), target.readDepth()};
    }

    std::vector<uint32_t> visible;
    FrameLog log;
    Picture picture;
};

TEST(DrawVisible, isTheSameIndirectlyAndAsAListAndItsLogReplays) {
    const ScenePointer scene = wallAndSpheres();
    const SceneBuffers buffers(scene, Upload::Vbo);
    const View view(standardCamera(), {161, 119});
    Renderer indirect(true), listed(false);
    EXPECT_TRUE(indirect.drawsIndirectly());
    EXPECT_FALSE(listed.drawsIndirectly());
    EXPECT_NE(Renderer().drawsIndirectly(), GlEnvironment::info().software);
    const TwoPasses first(indirect, buffers, view, true);
    const auto& list = std::get<DrawList>(first.log.commands.back());
    ASSERT_GT(list.ranges.size(), 10u);
    ASSERT_LT(list.ranges.size(), 35u) << "the wall hides some";
    const uint64_t hidden = 40 - list.ranges.size();
    EXPECT_EQ(first.log.counters.culledTriangles[size_t(Cause::Hidden)], hidden * scene->meshOf(1).triangleCount());
    std::vector<uint32_t> drawn;
    for (const DrawRange& range : list.ranges) drawn.push_back(range.instance - 1);
    EXPECT_EQ(drawn, first.visible);
    for (Renderer* renderer : {&indirect, &listed})
        for (const bool toTarget : {true, false}) {
            const TwoPasses other(*renderer, buffers, view, toTarget);
            EXPECT_EQ(std::get<DrawList>(other.log.commands.back()).ranges, list.ranges);
            EXPECT_EQ(other.log.counters.culledTriangles, first.log.counters.culledTriangles);
            if (toTarget) {
                EXPECT_TRUE(other.picture == first.picture);
            }
            Framebuffer target(view.viewport());
            renderer->draw(buffers, view, other.log, target);
            EXPECT_TRUE((Picture{target.readColour(), target.readDepth()} == first.picture)) << "the replay";
        }
    EXPECT_TRUE(picture(buffers, view, everything(*scene, Facing::TwoSided)) == first.picture) << "nothing visible is left out";
}

TEST(DrawVisible, drawsFromClientMemoryToo) {
    const ScenePointer scene = wallAndSpheres();
    const View view(standardCamera(), {64, 48});
    Renderer indirect(true);
    const TwoPasses expected(indirect, SceneBuffers(scene, Upload::Vbo), view, true);
    const TwoPasses client(indirect, SceneBuffers(scene, Upload::VertexArray), view, true);
    EXPECT_TRUE(client.picture == expected.picture);
    EXPECT_EQ(client.visible, expected.visible);
}

TEST(DrawVisible, needsAnAnswerForEachRangeAndDrawsAllWhereTheAnswersAreNotItsOwn) {
    const ScenePointer scene = wallAndSpheres();
    const SceneBuffers buffers(scene, Upload::Vbo);
    const View view(standardCamera(), {64, 48});
    const std::vector<EyeBox> hidden(2, box({-.1, -.1, -6}, {.1, .1, -5}));
    for (const bool indirectly : {true, false}) {
        Renderer renderer(indirectly), other;
        Framebuffer target(view.viewport());
        GpuFrame frame(renderer, buffers, view, target, {});
        frame.draw(DrawList{Facing::TwoSided, {{0, 0, 6}}});
        const BoxTicketPointer own = frame.ask(hidden, BoxQuestion::Pyramid);
        EXPECT_THROW(frame.drawVisible(*own, {Facing::TwoSided, {{1, 0, 3}}}), Error);
        const DrawList two{Facing::TwoSided, {{1, 0, 3}, {2, 0, 3}}};
        frame.drawVisible(*own, two);
        frame.drawVisible(*other.askPyramid(view, hidden, target), two);
        // Any question will do.
        frame.drawVisible(*frame.ask(hidden, BoxQuestion::DepthSoFar), two);
        const FrameLog log = frame.take();
        std::vector<size_t> drawn;
        for (const Command& command : log.commands)
            if (const auto* list = std::get_if<DrawList>(&command)) drawn.push_back(list->ranges.size());
        EXPECT_THAT(drawn, ElementsAre(1, 0, 2, 0));
    }
    FrameContext none(*scene, view, false);
    EXPECT_THROW((void)none.ask(hidden, BoxQuestion::Pyramid), Error);
}

}  // namespace
}  // namespace cullscope::test::depth_pyramid_test
