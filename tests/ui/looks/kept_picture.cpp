#include "tests/ui/looks/kept_picture.h"

#include <QDir>
#include <QImageWriter>
#include <QPainter>
#include <algorithm>
#include <cstdlib>

namespace cullscope::ui {

namespace {

constexpr int kTolerance = 24;            // of 255, in each channel
constexpr double kToleratedShare = 1e-3;  // of the pixels
constexpr qint64 kLargestFile = 150'000;  // bytes
constexpr QRgb kKeptBits = 0xfff8f8f8;    // bits of a colour that are stored, which keeps the files small
const QString kRendererKey = QStringLiteral("Renderer");

QString keptFile(const QString& name) { return QStringLiteral(CULLSCOPE_SOURCE_DIR "/tests/ui/looks/pictures/%1.png").arg(name); }

bool differ(QRgb a, QRgb b, int tolerance) {
    return std::abs(qRed(a) - qRed(b)) > tolerance || std::abs(qGreen(a) - qGreen(b)) > tolerance ||
           std::abs(qBlue(a) - qBlue(b)) > tolerance;
}

/// The picture with colours reduced to the stored bits.
QImage coarse(const QImage& picture) {
    QImage kept = picture.convertToFormat(QImage::Format_RGB32);
    for (int y = 0; y < kept.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(kept.scanLine(y));
        std::transform(line, line + kept.width(), line, [](QRgb pixel) { return pixel & kKeptBits; });
    }
    return kept;
}

/// The number of pixels that differ in a rectangle; marks them in `marks`.
int countDifferent(const QImage& a, const QImage& b, const QRect& place, int tolerance, QImage& marks) {
    int count = 0;
    for (int y = place.top(); y <= place.bottom(); ++y)
        for (int x = place.left(); x <= place.right(); ++x)
            if (differ(a.pixel(x, y), b.pixel(x, y), tolerance)) {
                marks.setPixel(x, y, qRgb(255, 0, 0));
                ++count;
            }
    return count;
}

bool write(QImage picture, const QString& file, const QString& renderer) {
    picture.setText(kRendererKey, renderer);
    QDir().mkpath(QFileInfo(file).absolutePath());
    QImageWriter writer(file, "png");
    writer.setCompression(100);
    return writer.write(picture);
}

/// A failed assertion: writes the picture and the marks to the build folder and states their paths.
::testing::AssertionResult different(const Look& look, const QString& name, const QImage& marks) {
    const QString file = QStringLiteral("%1/%2.png").arg(writtenPicturesFolder(), name);
    const QString markFile = QStringLiteral("%1/%2-difference.png").arg(writtenPicturesFolder(), name);
    write(look.picture, file, look.renderer);
    if (!marks.isNull()) write(marks, markFile, look.renderer);
    return ::testing::AssertionFailure() << "The window looks as in " << file.toStdString() << ", which is kept as "
                                         << keptFile(name).toStdString()
                                         << (marks.isNull() ? "" : "; differences are marked in " + markFile.toStdString())
                                         << ". Where it is meant, run again with CULLSCOPE_RENEW_PICTURES=1. ";
}

::testing::AssertionResult renew(const Look& look, const QString& name) {
    const QString file = keptFile(name);
    if (!write(coarse(look.picture), file, look.renderer))
        return ::testing::AssertionFailure() << file.toStdString() << " cannot be written.";
    const qint64 bytes = QFileInfo(file).size();
    if (bytes > kLargestFile) return ::testing::AssertionFailure() << file.toStdString() << " is large: " << bytes << " bytes.";
    return ::testing::AssertionSuccess();
}

}  // namespace

QString writtenPicturesFolder() { return QStringLiteral(CULLSCOPE_LOOKS_FOLDER); }

void keepToLookAt(QWidget& widget, const QString& name) {
    if (qEnvironmentVariableIsSet("CULLSCOPE_SAVE_LOOKS"))
        widget.grab().save(writtenPicturesFolder() + QStringLiteral("/%1.png").arg(name));
}

QImage withoutMasked(const QImage& picture, const std::vector<QRect>& masked) {
    QImage copy = picture.convertToFormat(QImage::Format_RGB32);
    QPainter painter(&copy);
    for (const QRect& place : masked) painter.fillRect(place, Qt::gray);
    return copy;
}

::testing::AssertionResult looksAsKept(const Look& look, const QString& name) {
    if (qEnvironmentVariableIntValue("CULLSCOPE_RENEW_PICTURES") == 1) return renew(look, name);
    const QImage kept(keptFile(name));
    if (kept.isNull()) return different(look, name, {}) << "There is no kept picture.";
    if (kept.size() != look.picture.size())
        return different(look, name, {}) << "It is of " << look.picture.width() << " x " << look.picture.height()
                                         << " pixels and not of " << kept.width() << " x " << kept.height() << ".";
    const QImage now = withoutMasked(coarse(look.picture), look.masked), before = withoutMasked(kept, look.masked);
    QImage marks = now.convertToFormat(QImage::Format_Grayscale8).convertToFormat(QImage::Format_RGB32);
    int inScenes = 0;
    if (kept.text(kRendererKey) == look.renderer)
        for (const QRect& scene : look.scenes) inScenes += countDifferent(now, before, scene & now.rect(), 0, marks);
    const int count = countDifferent(now, before, now.rect(), kTolerance, marks);
    const int pixels = now.width() * now.height();
    if (inScenes == 0 && count <= int(kToleratedShare * pixels)) return ::testing::AssertionSuccess();
    return different(look, name, marks) << count << " of " << pixels << " pixels differ clearly, and " << inScenes
                                        << " at all in the pictures of the scene.";
}

}  // namespace cullscope::ui
