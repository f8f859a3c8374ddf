// Simulates a driver reset, because no driver resets on demand: the test answers the GPU thread's query whether its context is
// lost. The thread then treats the old context exactly like a lost one.
#pragma once

#include <gtest/gtest.h>

#include <atomic>

#include "tests/ui/test_scene.h"

namespace cullscope::ui {

inline const Viewport kLossSize{320, 240};
inline const QString kLossScene = QStringLiteral("field:mesh=star:seed=7,triangles=2000,n=4,spacing=2.5");

/// The simulated driver: when it resets, and whether a new context can be made afterwards.
struct Driver {
    std::atomic<int> reset = 0;        ///< number, from 1, of the query that reports the loss; 0: none does
    std::atomic<bool> always = false;  ///< every query reports a loss
    std::atomic<bool> broken = false;  ///< no new context can be made

    GpuThread::Options options() {
        return {[this] { return (reset > 0 && --reset == 0) || always; },
                [this]() -> std::unique_ptr<QOpenGLContext> {
                    if (broken) return nullptr;
                    auto context = std::make_unique<QOpenGLContext>();
                    context->setFormat(QSurfaceFormat::defaultFormat());
                    return context->create() ? std::move(context) : nullptr;
                }};
    }
};

/// The pictures and metrics of the shown views.
struct Seen {
    std::vector<QImage> pictures;
    std::vector<std::tuple<uint64_t, uint64_t, uint64_t, uint64_t>> counts;  ///< missed, extra, covered, considered

    bool operator==(const Seen&) const = default;
};

inline Seen seenIn(const Session& session) {
    Seen seen;
    for (const int view : session.shownViews()) {
        seen.pictures.push_back(session.picture(view) ? session.picture(view)->colour : QImage());
        const ViewMetrics& figures = session.figures(view);
        seen.counts.emplace_back(figures.accuracy.missedPixels, figures.accuracy.extraPixels, figures.accuracy.coveredPixels,
                                 figures.consideredTriangles);
    }
    return seen;
}

inline void settle(Session& session) {
    ASSERT_TRUE(waitUntil([&] {
        for (const int view : session.shownViews())
            if (session.slot(session.culledBy(view)).building() || !session.pictures()->isCurrent(view)) return false;
        return session.metricsSettled() && !session.pictures()->busy();
    }));
}

/// Sets up four views: two linked ones with both ways of uploading, an observer with verdict colours, and a frozen one.
inline void setUp(Session& session) {
    session.setViewCount(4);
    for (int view = 0; view < 4; ++view) session.setViewport(view, kLossSize);
    openAndWait(session, kLossScene);
    session.slot(0).choose("frustum");
    session.slot(1).choose("backface");
    session.slot(3).choose("frustum");
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.4, 1.0));
    ViewSetup arrays = session.setup(1);
    arrays.upload = Upload::VertexArray;
    session.setSetup(1, arrays);
    session.observe(2, 0);
    ViewSetup observer = session.setup(2);
    observer.look = {"verdicts", "frustum", "boxes"};
    session.setSetup(2, observer);
    session.setFrozen(3, true);
    std::vector<bool> hidden(session.hidden().size(), false);
    hidden[5] = true;
    session.setHidden(hidden);
}

/// A session on a driver that resets on demand, with the messages of the session.
struct ContextLoss : ::testing::Test {
    ContextLoss() {
        QObject::connect(&session, &Session::messageRaised, [this](Severity severity, const Message& message) {
            said.push_back(message.english());
            severities.push_back(severity);
        });
    }

    static Session::Options optionsOf(Driver& driver) {
        Session::Options options = sessionOptions(true);
        options.rounds = ViewMeter::protocol();  // the context is lost between the figures and their times
        options.gpu = driver.options();
        return options;
    }
    /// Resets the driver while no picture is drawn; returns when the session has reported the loss.
    void lose() {
        const size_t before = said.size();
        driver.reset = 1;
        session.gpu()->run([] {});
        ASSERT_TRUE(waitUntil([&] { return said.size() > before; }));
    }
    /// Waits until every shown view was drawn again since `drawn` was counted.
    void waitForRedrawing(const std::vector<size_t>& drawn) {
        ASSERT_TRUE(waitUntil([&] {
            for (const int view : session.shownViews())
                if (session.pictures()->drawn(view) <= drawn[size_t(view)]) return false;
            return true;
        }));
        settle(session);
    }
    [[nodiscard]] std::vector<size_t> drawn() {
        std::vector<size_t> counts;
        for (int view = 0; view < Session::kMostViews; ++view) counts.push_back(session.pictures()->drawn(view));
        return counts;
    }

    Driver driver;
    std::vector<std::string> said;
    std::vector<Severity> severities;
    Session session{optionsOf(driver)};
};

}  // namespace cullscope::ui
