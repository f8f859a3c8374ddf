// What the chip says of marked pixels agrees with the count of missed ones.
#include "core/scene/camera_moves.h"
#include "tests/ui/shown_window.h"
#include "ui/look/verdict_swatch.h"
#include "ui/text/wording.h"

namespace cullscope::ui::marked_pixels_test {
namespace {

TEST(MarkedPixels, haveColoursThatMeanNothingElse) {
    for (const bool dark : {false, true}) {
        const QPalette palette = Appearance::palette(dark);
        std::vector<QColor> known{snappedPixelColour(), addedPixelColour()};
        for (size_t state = 0; state < kTriangleStateCount; ++state)
            known.push_back(verdictColour(TriangleState(state), palette));
        for (size_t i = 0; i < 2; ++i)
            for (size_t j = i + 1; j < known.size(); ++j) {
                const QColor &a = known[i], &b = known[j];
                const int apart = std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
                EXPECT_GT(apart, 60) << (dark ? "dark: " : "light: ") << a.name().toStdString() << " and "
                                     << b.name().toStdString();
            }
    }
}

TEST_F(Window, whatSnappingExplainsIsNoMissedPixelInTheChipOfMarkedOnes) {
    openAndWait(session, QStringLiteral("knot:triangles=20000"));
    session.slot(0).choose("backface");
    ViewSetup setup = session.setup(0);
    setup.wipe.mode = Wipe::Mode::Loss;
    setup.size = Viewport{640, 480};
    session.setSetup(0, setup);
    uint64_t explained = 0;
    for (int turn = 0; turn < 40 && explained == 0; ++turn) {
        session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(9.0), {}));
        settle();
        ASSERT_TRUE(waitUntil([&] { return session.figures(0).state == ViewMetrics::State::Ready; }));
        const ViewMetrics& figures = session.figures(0);
        explained = figures.accuracy.missedPixels - figures.lostPixels();
        EXPECT_EQ(session.picture(0)->missed, figures.accuracy.missedPixels) << "so many are marked";
        const QString chip = window.views().pane(0).chipText();
        EXPECT_TRUE(chip.contains(QStringLiteral("missed pixels: %1,").arg(countText(figures.lostPixels()))))
            << chip.toStdString();
        if (explained > 0) {
            ASSERT_TRUE(waitUntil([&] { return session.picture(0)->withinSnapping == explained; }))
                << "those have a colour of their own";
            const Vec3f colour = verdictPalette(session.drawStyle().background)[size_t(TriangleState::WronglyCulled)].colour;
            const QColor ofLost(int(std::lround(colour.x * 255.0f)), int(std::lround(colour.y * 255.0f)),
                                int(std::lround(colour.z * 255.0f)));
            const QImage& marks = session.picture(0)->marks;
            size_t snapped = 0, lost = 0;
            for (int y = 0; y < marks.height(); ++y)
                for (int x = 0; x < marks.width(); ++x) {
                    snapped += marks.pixelColor(x, y) == snappedPixelColour() ? 1 : 0;
                    lost += marks.pixelColor(x, y) == ofLost ? 1 : 0;
                }
            EXPECT_GT(snapped, 0u);
            EXPECT_EQ(lost > 0, figures.lostPixels() > 0);
            const QString within = QStringLiteral("within snapping and not lost: ") + countText(explained);
            EXPECT_TRUE(chip.contains(within)) << chip.toStdString();
        }
    }
    EXPECT_GT(explained, 0u) << "else nothing was tried";
}

}  // namespace
}  // namespace cullscope::ui::marked_pixels_test
