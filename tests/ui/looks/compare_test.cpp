// Many views beside each other on the least screen must be legible from the back row of a lecture room.
#include <QFile>
#include <QPainter>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>

#include "tests/ui/looks/desktop.h"
#include "ui/text/wording.h"

namespace cullscope::ui::compare_test {
namespace {

constexpr int kEnlarged = 3;      // factor; letters of 14 pixels are too small for tesseract
constexpr int kLeast = 80;        // per cent of a name's letters that tesseract must read
constexpr int kMargin = 30;       // pixels around a line
constexpr int kHeaderMargin = 8;  // pixels between the parts of a header

const std::vector<std::string> kEight{"all", "backface", "frustum", "frustum", "frustum", "all", "backface", "frustum"};

/// The text without characters that tesseract often adds or drops.
QString bare(QString text) { return text.remove(QRegularExpression(QStringLiteral("[\\s·:.,|_—–-]"))).toLower(); }

/// The edit distance of two texts, in letters.
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

/// The per cent of the wanted text's letters that occur, in order, somewhere in a line: 100 less the smallest edit distance.
int readable(const QString& wanted, const QString& line) {
    const QString text = bare(wanted), read = bare(line);
    int least = int(text.size());
    for (int from = 0; from <= std::max(0, int(read.size() - text.size())); ++from)
        least = std::min(least, distance(text, read.mid(from, text.size())));
    return 100 - 100 * least / std::max(1, int(text.size()));
}

/// The text that tesseract reads in each picture of a line.
QStringList readBack(const std::vector<QImage>& lines) {
    const QTemporaryDir folder;
    QFile list(folder.filePath(QStringLiteral("lines.txt")));
    EXPECT_TRUE(list.open(QIODevice::WriteOnly));
    for (size_t line = 0; line < lines.size(); ++line) {
        const QString file = folder.filePath(QStringLiteral("%1.png").arg(line));
        lines[line].save(file);
        list.write(file.toUtf8() + '\n');
    }
    list.close();
    QProcess tesseract;
    tesseract.start(QStringLiteral("tesseract"), {list.fileName(), QStringLiteral("stdout"), QStringLiteral("-l"),
                                                  QStringLiteral("kor+eng"), QStringLiteral("--psm"), QStringLiteral("7")});
    EXPECT_TRUE(tesseract.waitForFinished(kPatience)) << "tesseract-ocr is in packaging/packages.txt and not installed";
    EXPECT_EQ(tesseract.exitCode(), 0) << tesseract.readAllStandardError().toStdString();
    return QString::fromUtf8(tesseract.readAllStandardOutput()).split(QLatin1Char('\f'));
}

/// A part of a window prepared for tesseract: enlarged, dark on light, with a margin.
QImage enlarged(const QImage& window, const QRect& place, bool dark) {
    QImage part = window.copy(place).convertToFormat(QImage::Format_Grayscale8);
    if (dark) part.invertPixels();
    part = part.scaled(part.size() * kEnlarged, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    QImage framed(part.size() + QSize(2 * kMargin, 2 * kMargin), QImage::Format_Grayscale8);
    framed.fill(part.pixelColor(0, 0));
    QPainter(&framed).drawImage(kMargin, kMargin, part);
    return framed;
}

/// A text to be read, and its rectangle.
struct Line {
    QString text;
    QRect place;
};

/// The strategy's name and the missed pixels in a view's header. The speed between them differs from run to run.
std::vector<Line> headerLines(Desktop& desktop, int view) {
    const ViewHeader& header = desktop.window.views().pane(view).header();
    const QPoint corner = header.mapTo(&desktop.window, QPoint());
    QFont bold = header.font();
    bold.setBold(true);
    const QFontMetrics metrics(bold);
    const QString name = header.firstLine().section(QLatin1Char(':'), 0, 0), figures = header.secondLine();
    const int left = 2 * kHeaderMargin + metrics.horizontalAdvance(viewLetter(view));
    const QSize nameSize(metrics.horizontalAdvance(name) + kHeaderMargin / 2, ViewHeader::kLineHeight);
    const QString missed = figures.section(QStringLiteral("·"), -1);
    const QFontMetrics thin(header.font());
    const int before = kHeaderMargin + thin.horizontalAdvance(figures.left(figures.size() - missed.size()));
    const QSize missedSize(thin.horizontalAdvance(missed) + kHeaderMargin, ViewHeader::kLineHeight);
    return {{name, QRect(corner + QPoint(left - kHeaderMargin / 4, 0), nameSize)},
            {missed, QRect(corner + QPoint(before, ViewHeader::kLineHeight), missedSize)}};
}

void expectLegible(Desktop& desktop, const Look& look) {
    std::vector<Line> lines;
    std::vector<QImage> pictures;
    for (const int view : desktop.session.shownViews()) {
        EXPECT_FALSE(desktop.window.views().pane(view).header().elided()) << "view " << view;
        for (const Line& line : headerLines(desktop, view)) {
            lines.push_back(line);
            pictures.push_back(enlarged(look.picture, line.place, desktop.appearance.dark()));
        }
    }
    const QStringList read = readBack(pictures);
    ASSERT_GE(size_t(read.size()), lines.size());
    for (size_t line = 0; line < lines.size(); ++line) {
        EXPECT_GE(readable(lines[line].text, read[qsizetype(line)]), kLeast)
            << "\"" << lines[line].text.toStdString() << "\" was read as \"" << read[qsizetype(line)].trimmed().toStdString()
            << "\"";
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
        // Zoom in, so that the strategy misses pixels.
        desktop.session.setCamera(zoomed(desktop.session.camera(), desktop.session.camera().target, 0.6, 1.0));
        desktop.settle();
        for (int view = 0; view < 8; ++view) {
            EXPECT_EQ(desktop.scene(view).size(), QSize(640, 480)) << "view " << view;
            EXPECT_EQ(desktop.view(view).pictureLayout().rect().size(), QSizeF(320, 240)) << "view " << view;
        }
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
    Desktop desktop({.strategies = {"frustum", "all"}, .scene = QStringLiteral("split:mesh=bunny,by=clusters,triangles=500")});
    desktop.session.setActiveView(0);
    desktop.view(0).setFocus();
    desktop.session.setCamera(zoomed(desktop.session.camera(), desktop.session.camera().target, 0.35, 1.0));
    desktop.settle();
    const QImage neighbour = desktop.scene(1), before = desktop.scene(0);
    const ViewMetrics figures = desktop.session.figures(0);
    ASSERT_LT(figures.consideredTriangles, figures.sceneTriangles);
    QTest::keyClick(&desktop.view(0), Qt::Key_F);
    ASSERT_EQ(desktop.session.setup(0).role, Role::Frozen);
    const Camera side = turned(desktop.session.viewingCamera(0), UpAxis::Y, Angle::fromDegrees(90.0), {});
    desktop.session.setViewingCamera(0, zoomed(side, side.target, 2.5, 1.0));
    desktop.settle();
    EXPECT_EQ(desktop.session.figures(0).consideredTriangles, figures.consideredTriangles);
    EXPECT_EQ(desktop.session.figures(0).accuracy.missedPixels, figures.accuracy.missedPixels);
    EXPECT_TRUE(desktop.window.views().pane(0).chipText().contains(QStringLiteral("frozen")));
    EXPECT_EQ(desktop.scene(1), neighbour);
    EXPECT_NE(desktop.scene(0), before);
    EXPECT_TRUE(looksAsKept(desktop.look(), QStringLiteral("frozen")));
}

}  // namespace
}  // namespace cullscope::ui::compare_test
