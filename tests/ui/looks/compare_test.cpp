// Many views beside each other on the least screen, for the back row of a lecture room.
#include <QPainter>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>

#include "tests/ui/looks/desktop.h"
#include "ui/text/wording.h"

namespace cullscope::ui {
namespace {

constexpr int kEnlarged = 3;  // letters of 14 pixels are small for tesseract
constexpr int kLeast = 80;    // of 100 letters of a name that have to be read

const std::vector<std::string> kEight{"all", "backface", "frustum", "frustum", "frustum", "all", "backface", "frustum"};

/// Without what a reader may take for one more or less.
QString bare(QString text) { return text.remove(QRegularExpression(QStringLiteral("[\\s·:.,|_—–-]"))).toLower(); }

/// How many letters one text has to be changed in to be the other.
int distance(const QString& a, const QString& b) {
    std::vector<int> row(size_t(b.size()) + 1);
    for (size_t j = 0; j < row.size(); ++j) row[j] = int(j);
    for (int i = 1; i <= a.size(); ++i) {
        int diagonal = std::exchange(row[0], i);
        for (int j = 1; j <= b.size(); ++j) {
            const int changed = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = row[size_t(j)];
            row[size_t(j)] = std::min({changed, row[size_t(j)] + 1, row[size_t(j) - 1] + 1});
        }
    }
    return row.back();
}

/// Per cent of a text's letters that stand somewhere in a line.
int readable(const QString& wanted, const QString& line) {
    const QString text = bare(wanted), read = bare(line);
    int least = int(text.size());
    for (int from = 0; from <= std::max(0, int(read.size() - text.size())); ++from)
        least = std::min(least, distance(text, read.mid(from, text.size())));
    return 100 - 100 * least / std::max(1, int(text.size()));
}

/// The lines that tesseract reads in a picture.
QStringList readBack(const QImage& picture) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("line.png"));
    picture.save(file);
    QProcess tesseract;
    tesseract.start(QStringLiteral("tesseract"), {file, QStringLiteral("stdout"), QStringLiteral("-l"), QStringLiteral("kor+eng"),
                                                  QStringLiteral("--psm"), QStringLiteral("6")});
    EXPECT_TRUE(tesseract.waitForFinished(kPatience)) << "tesseract-ocr is in packaging/packages.txt and not installed";
    EXPECT_EQ(tesseract.exitCode(), 0) << tesseract.readAllStandardError().toStdString();
    return QString::fromUtf8(tesseract.readAllStandardOutput()).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
}

/// The headers of the shown views below each other, as large as a reader of letters wants them.
QImage headers(Desktop& desktop, const QImage& window) {
    const QSize size = desktop.window.views().pane(0).header().size();
    const std::vector<int> shown = desktop.session.shownViews();
    QImage all(size.width(), size.height() * int(shown.size()), QImage::Format_RGB32);
    QPainter painter(&all);
    for (size_t place = 0; place < shown.size(); ++place) {
        const ViewHeader& header = desktop.window.views().pane(shown[place]).header();
        painter.drawImage(QPoint(0, size.height() * int(place)),
                          window.copy(QRect(header.mapTo(&desktop.window, QPoint()), size)));
    }
    painter.end();
    return all.scaled(all.size() * kEnlarged, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

void expectLegible(Desktop& desktop, const Look& look) {
    const QStringList lines = readBack(headers(desktop, look.picture));
    for (const int view : desktop.session.shownViews()) {
        const ViewHeader& header = desktop.window.views().pane(view).header();
        EXPECT_FALSE(header.elided()) << header.firstLine().toStdString();
        const auto best = [&](const QString& text) {
            int percent = 0;
            for (const QString& line : lines) percent = std::max(percent, readable(text, line));
            return percent;
        };
        const QString name = header.firstLine().section(QLatin1Char(':'), 0, 0);
        EXPECT_GE(best(name), kLeast) << name.toStdString() << " is not in\n" << lines.join(QLatin1Char('\n')).toStdString();
        const QString missed = header.secondLine().section(QStringLiteral("·"), -1);
        EXPECT_GE(best(missed), kLeast) << missed.toStdString() << " is not in\n" << lines.join(QLatin1Char('\n')).toStdString();
    }
}

TEST(Compare, eightViewsInKoreanAreLegibleOnTheLeastScreen) {
    for (const Appearance::Mode appearance : {Appearance::Mode::Light, Appearance::Mode::Dark}) {
        Desktop desktop({.language = QStringLiteral("ko"), .appearance = appearance, .strategies = kEight});
        for (const int view : {3, 7}) {
            ParameterSet parameters = desktop.session.slot(view).parameters();
            parameters.setFromText("box", "length");
            desktop.session.slot(view).setParameters(parameters);
        }
        // Close to it, so that there is something to miss.
        desktop.session.setCamera(zoomed(desktop.session.camera(), desktop.session.camera().target, 0.6, 1.0));
        desktop.settle();
        for (int view = 0; view < 8; ++view) EXPECT_EQ(desktop.scene(view).size(), QSize(320, 240)) << "view " << view;
        const Look look = desktop.look();
        expectLegible(desktop, look);
        EXPECT_TRUE(looksAsKept(look, QStringLiteral("eight-views-ko-") + Appearance::id(appearance)));
    }
}

TEST(Compare, unreadableLettersAreFound) {
    EXPECT_EQ(readable(QStringLiteral("12 누락"), QStringLiteral("X1.0·50%·12누락")), 100);
    EXPECT_LT(readable(QStringLiteral("12 누락"), QStringLiteral("A 모든 삼각형")), kLeast);
    EXPECT_LT(readable(QStringLiteral("123"), {}), kLeast);
}

TEST(Compare, aSizeOfItsOwnIsLetterboxedAndSaysItsScale) {
    Desktop desktop({.strategies = {"all", "backface", "frustum", "backface"}});
    for (int view = 0; view < 4; ++view) desktop.edit(view, [](ViewSetup& setup) { setup.size = Viewport{640, 480}; });
    desktop.edit(3, [](ViewSetup& setup) { setup.wipe = {Wipe::Mode::OtherView, 0, 0.5}; });
    desktop.edit(1, [](ViewSetup& setup) { setup.wipe = {Wipe::Mode::Truth, 0, 0.4}; });
    desktop.settle();
    for (int view = 0; view < 4; ++view) EXPECT_EQ(desktop.scene(view).size(), QSize(640, 480));
    EXPECT_TRUE(looksAsKept(desktop.look(), QStringLiteral("four-views-wipe")));
}

TEST(Compare, aFrozenViewIsSeenFromTheSideWithItsHoles) {
    Desktop desktop({.strategies = {"backface", "all"}});
    desktop.session.setActiveView(0);
    desktop.view(0).setFocus();
    const QImage neighbour = desktop.scene(1), before = desktop.scene(0);
    const Figures figures = desktop.session.figures(0);
    QTest::keyClick(&desktop.view(0), Qt::Key_F);
    ASSERT_EQ(desktop.session.setup(0).role, Role::Frozen);
    desktop.session.setViewingCamera(0, turned(desktop.session.viewingCamera(0), UpAxis::Y, Angle::fromDegrees(90.0), {}));
    desktop.settle();
    EXPECT_EQ(desktop.session.figures(0).consideredTriangles, figures.consideredTriangles);
    EXPECT_EQ(desktop.session.figures(0).accuracy.missedPixels, figures.accuracy.missedPixels);
    EXPECT_TRUE(desktop.window.views().pane(0).chipText().contains(QStringLiteral("frozen")));
    EXPECT_EQ(desktop.scene(1), neighbour);
    EXPECT_NE(desktop.scene(0), before);
    EXPECT_TRUE(looksAsKept(desktop.look(), QStringLiteral("frozen")));
}

}  // namespace
}  // namespace cullscope::ui
