// The window at the first start of the program, on the least screen, in each language.
#include "core/scene/scene_files.h"
#include "core/visibility/registry.h"
#include "tests/ui/looks/desktop.h"
#include "tests/ui/looks/shown_texts.h"
#include "ui/look/verdict_swatch.h"

namespace cullscope::ui::first_window_test {
namespace {

const QStringList kLanguages{QStringLiteral("en"), QStringLiteral("ko"), QStringLiteral("zh_CN")};

std::string joined(const QStringList& lines) { return lines.join(QLatin1Char('\n')).toStdString(); }

/// The number of pixels in a verdict's colour or a slightly shaded tone of it.
int pixelsOf(const QImage& picture, const QColor& colour) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const QColor pixel = picture.pixelColor(x, y);
            const double shade =
                double(pixel.red() + pixel.green() + pixel.blue()) / (colour.red() + colour.green() + colour.blue());
            if (shade < 0.75 || shade > 1.1) continue;
            const auto near = [shade](int a, int b) { return std::abs(a - b * shade) < 16; };
            count += near(pixel.red(), colour.red()) && near(pixel.green(), colour.green()) && near(pixel.blue(), colour.blue());
        }
    return count;
}

/// Names that are not translated.
QStringList names(Desktop& desktop) {
    QStringList names{QStringLiteral("Software OpenGL"), QStringLiteral("mesh:FILE,triangles=N")};
    names << QString::fromStdString(desktop.session.gpu()->info().renderer)
          << QString::fromStdString(desktop.session.gpu()->info().version);
    for (const std::string& format : readableSceneExtensions()) names << QString::fromStdString(format);
    for (const RegisteredStrategy& strategy : strategies()) names << QString::fromStdString(strategy.info.id);
    return names;
}

/// Calls `look` for every page of the first window that one click opens.
void forEachPage(Desktop& desktop, const std::function<void(const std::string& page)>& look) {
    look("at the start");
    for (int tab = 0; tab < desktop.window.tabs().count(); ++tab) {
        if (!desktop.window.tabs().isTabVisible(tab)) continue;
        desktop.window.tabs().setCurrentIndex(tab);
        desktop.settle();
        look("tab " + desktop.window.tabs().tabText(tab).toStdString());
    }
    for (int page = 0; page < 2; ++page) {
        desktop.window.side().setOpenPage(page);
        desktop.settle();
        look("side page " + std::to_string(page));
    }
    desktop.window.side().setOpenPage(-1);
    desktop.window.statistics().toggleViewAction()->trigger();
    desktop.settle();
    look("statistics");
    desktop.window.statistics().toggleViewAction()->trigger();
    desktop.window.tabs().setCurrentIndex(0);
}

TEST(FirstWindow, showsASceneALegendVisibleCullingAndOneNextAction) {
    Desktop desktop;
    EXPECT_EQ(desktop.session.viewCount(), 2);
    EXPECT_TRUE(desktop.window.legend().isVisible());
    const QImage observed = desktop.scene(1);
    const QPalette palette = QApplication::palette();
    for (const TriangleState state : {TriangleState::Visible, TriangleState::BackFacing})
        EXPECT_GT(pixelsOf(observed, verdictColour(state, palette)), 1000) << int(state);
    int next = 0;
    for (const auto* label : desktop.window.findChildren<QLabel*>())
        next += label->isVisible() && label->text().startsWith(QStringLiteral("Next: "));
    EXPECT_EQ(next, 1);
    const Look look = desktop.look();
    EXPECT_EQ(look.picture.size(), QSize(1366, 768));
    EXPECT_TRUE(looksAsKept(look, QStringLiteral("first-window")));
}

TEST(FirstWindow, cutsNoTextInAnyLanguage) {
    Desktop desktop;
    for (const QString& language : kLanguages) {
        desktop.language.use(language);
        desktop.settle();
        forEachPage(desktop, [&](const std::string& page) {
            static_cast<void>(desktop.look());
            const QStringList cut = cutTexts(desktop.window);
            EXPECT_TRUE(cut.isEmpty()) << language.toStdString() << ", " << page << ":\n" << joined(cut);
        });
    }
}

TEST(FirstWindow, hasEveryLetterAndNoEnglishSentenceInKoreanAndChinese) {
    for (const QString& language : kLanguages) {
        if (language == QStringLiteral("en")) continue;
        Desktop desktop({.language = language});
        EXPECT_TRUE(looksAsKept(desktop.look(), QStringLiteral("first-window-") + language));
        forEachPage(desktop, [&](const std::string& page) {
            const std::vector<ShownText> texts = shownTexts(desktop.window);
            EXPECT_GT(texts.size(), 100u);
            const QStringList missing = textsWithMissingLetters(texts), english = englishSentences(texts, names(desktop));
            EXPECT_TRUE(missing.isEmpty()) << language.toStdString() << ", " << page << ":\n" << joined(missing);
            EXPECT_TRUE(english.isEmpty()) << language.toStdString() << ", " << page << ":\n" << joined(english);
        });
    }
}

TEST(FirstWindow, aMissingLetterAndAnEnglishSentenceAreFound) {
    // No font has a glyph for this character of a private use plane.
    const ShownText text{QString::fromUcs4(U"가\U000F1234", 2), QApplication::font(), QStringLiteral("here"), true};
    EXPECT_EQ(textsWithMissingLetters({text}).size(), 1);
    EXPECT_EQ(englishSentences({{QStringLiteral("왼쪽: Drag with this"), {}, {}, true}}, {}).size(), 1);
    EXPECT_TRUE(englishSentences({{QStringLiteral("Software OpenGL 4.5"), {}, {}, true}}, {}).isEmpty());
}

/// The state that a change of language must not affect.
struct State {
    Camera camera, observer;
    int views = 0, active = 0;
    std::vector<std::string> strategies;
    std::vector<ParameterSet> parameters;
    std::vector<QImage> pictures;

    explicit State(Desktop& desktop)
        : camera(desktop.session.camera()),
          observer(desktop.session.viewingCamera(1)),
          views(desktop.session.viewCount()),
          active(desktop.session.activeView()) {
        for (const int view : desktop.session.shownViews()) {
            const StrategySlot& slot = desktop.session.slot(view);
            strategies.push_back(slot.id());
            parameters.push_back(slot.parameters());
            pictures.push_back(desktop.scene(view));
        }
    }
    bool operator==(const State&) const = default;
};

void expectTheSameInEveryLanguage(Desktop& desktop, const std::string& when) {
    desktop.settle();
    const State before(desktop);
    for (const char* language : {"ko", "zh_CN", "en"}) {
        desktop.language.use(QString::fromLatin1(language));
        desktop.settle();
        const State now(desktop);
        EXPECT_EQ(now.pictures, before.pictures) << when << ", " << language;
        EXPECT_TRUE(now == before) << when << ", " << language;
    }
}

TEST(FirstWindow, anotherLanguageWhileSteppingKeepsTheState) {
    Desktop desktop;
    Session& session = desktop.session;
    // Fixed sizes: larger letters would reduce a picture that is fitted to the window.
    for (int view = 0; view < 2; ++view) desktop.edit(view, [](ViewSetup& setup) { setup.size = Viewport{400, 500}; });
    WindowActions& actions = desktop.window.actions();
    session.slot(0).choose("frustum");
    ParameterSet parameters = session.slot(0).parameters();
    parameters.setFromText("box", "length");
    session.slot(0).setParameters(parameters);
    // A path of three poses, and one of them as a bookmark.
    for (int pose = 0; pose < 3; ++pose) {
        session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(20.0), {}));
        actions.addPose->trigger();
    }
    actions.bookmarks->actions().at(CameraBookmarks::kCount + 1)->trigger();
    const Camera kept = session.viewingCamera(session.activeView());
    actions.play->trigger();
    ASSERT_TRUE(desktop.window.paths().player().active());
    desktop.window.paths().player().pause();
    const int pose = desktop.window.paths().player().pose();
    expectTheSameInEveryLanguage(desktop, "between two poses");
    EXPECT_TRUE(desktop.window.paths().player().active());
    EXPECT_EQ(desktop.window.paths().player().pose(), pose);
    actions.stop->trigger();
    QCoreApplication::processEvents();
    actions.bookmarks->actions().front()->trigger();
    EXPECT_EQ(session.viewingCamera(session.activeView()), kept) << "the bookmark went with the language";

    actions.lecture->trigger();
    ASSERT_TRUE(desktop.window.lecture());
    const int first = desktop.window.lecture()->shownView();
    for (int page = 0; page < 2; ++page) QTest::keyClick(desktop.window.lecture(), Qt::Key_PageDown);
    const int shown = desktop.window.lecture()->shownView();
    EXPECT_NE(shown, first);
    expectTheSameInEveryLanguage(desktop, "in a lecture");
    EXPECT_EQ(desktop.window.lecture()->shownView(), shown);
    QTest::keyClick(desktop.window.lecture(), Qt::Key_Escape);
    EXPECT_TRUE(waitUntil([&] { return !desktop.window.lecture(); }));
}

}  // namespace
}  // namespace cullscope::ui::first_window_test
