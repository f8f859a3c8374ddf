// No driver resets on demand: the tests answer for it when the GPU thread asks whether its context is lost, and the old context
// then is as gone for the thread as a lost one.
#pragma once

#include <gtest/gtest.h>

#include <atomic>

#include "tests/ui/test_scene.h"

namespace cullscope::ui {

inline const Viewport kLossSize{320, 240};
inline const QString kLossScene = QStringLiteral("field:mesh=star:seed=7,triangles=2000,n=4,spacing=2.5");

/// What a driver does to a context, and whether it then gives another one.
struct Driver {
    std::atomic<int> reset = 0;        ///< the question about the context, from 1, that is answered with its loss; 0: none
    std::atomic<bool> always = false;  ///< all of them
    std::atomic<bool> broken = false;  ///< no new context

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

/// What a view shows and what is known of it.
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

/// Four views: a linked pair that uploads in both ways, an observer with verdict colours, and a frozen one.
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
    observer.look = {Colouring::Verdicts, true, true, true};
    session.setSetup(2, observer);
    session.setFrozen(3, true);
    std::vector<bool> hidden(session.hidden().size(), false);
    hidden[5] = true;
    session.setHidden(hidden);
}

/// A session on a driver that resets when it is told to, and what the session says.
struct ContextLoss : ::testing::Test {
    ContextLoss() {
        QObject::connect(&session, &Session::messageRaised, [this](Severity severity, const Message& message) {
            said.push_back(message.english());
            severities.push_back(severity);
        });
    }

    static Session::Options optionsOf(Driver& driver) {
        Session::Options options = sessionOptions(true);
        options.rounds = {};  // the context is lost between the figures and their times
        options.gpu = driver.options();
        return options;
    }
    /// The driver resets while nothing is drawn; ends when the loss is known.
    void lose() {
        const size_t before = said.size();
        driver.reset = 1;
        session.gpu()->run([] {});
        ASSERT_TRUE(waitUntil([&] { return said.size() > before; }));
    }
    /// Until every shown view was drawn anew since.
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
