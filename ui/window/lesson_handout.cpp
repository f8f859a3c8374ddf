#include "ui/window/lesson_handout.h"

#include <QBuffer>
#include <QFileInfo>
#include <QPainter>
#include <QPdfWriter>
#include <QPixmap>
#include <QTextDocument>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr int kHandoutLookInterval = 50;  // ms between two checks
// Pixels at 96 in an inch: within the margins of A4, where two steps stand on a page with their sentences and figures.
constexpr int kHandoutPictureWidth = 600;
constexpr int kHandoutPictureHeight = 300;
constexpr const char* kStepImageName = "step-%1.png";

QByteArray pngOf(const QImage& image) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly) || !image.save(&buffer, "PNG")) bytes.clear();
    return bytes;
}

/// Both on white, the second one no higher than the first.
QImage beside(const QImage& views, const QImage& panel) {
    const QImage second =
        panel.height() > views.height() ? panel.scaledToHeight(views.height(), Qt::SmoothTransformation) : panel;
    QImage both(views.width() + second.width(), views.height(), QImage::Format_RGB32);
    both.fill(Qt::white);
    QPainter painter(&both);
    painter.drawImage(0, 0, views);
    painter.drawImage(views.width(), 0, second);
    return both;
}

bool isPdf(const QString& file) { return QFileInfo(file).suffix().compare(QLatin1String("pdf"), Qt::CaseInsensitive) == 0; }

}  // namespace

LessonHandout::LessonHandout(Session& session, LessonPlayer& lessons, ViewGrid& views, const Language& language, QObject* parent)
    : QObject(parent), m_session(session), m_lessons(lessons), m_views(views), m_language(language) {
    m_poll.setInterval(kHandoutLookInterval);
    connect(&m_poll, &QTimer::timeout, this, &LessonHandout::look);
}

void LessonHandout::requireFormat(const QString& file) {
    const QString suffix = QFileInfo(file).suffix().toLower();
    if (suffix != QLatin1String("pdf") && suffix != QLatin1String("html"))
        throwUsage(QT_TRANSLATE_NOOP("core", "%1: name a handout's file that ends in .pdf or .html."), {file.toStdString()});
}

void LessonHandout::make(const QString& file) {
    if (!m_lessons.active() || busy()) return;
    try {
        requireFormat(file);
    } catch (const Error& error) {
        emit failed(error.message());
        return;
    }
    m_file = file;
    m_before = m_lessons.step();
    m_pages.clear();
    m_lessons.go(0);
    emit progressed(0, m_lessons.count());
    m_poll.start();
}

void LessonHandout::cancel() {
    if (!busy()) return;
    m_poll.stop();
    m_pages.clear();
    m_lessons.go(m_before);
}

bool LessonHandout::settled() const {
    if (m_lessons.opening() || m_session.loader().loading() || !m_session.opened()) return false;
    for (const int view : m_session.shownViews()) {
        if (m_session.slot(m_session.culledBy(view)).building()) return false;
        if (m_session.viewRequest(view) && !m_session.pictures()->isCurrent(view)) return false;
    }
    if (showsStructure() && !m_reader->fresh() && !m_session.slot(m_session.culledBy(m_reader->view())).refused()) return false;
    const bool uploaded = m_session.buffers() || !m_session.uploadFailure().empty();
    return uploaded && !m_session.pictures()->busy() && m_session.metricsSettled();
}

bool LessonHandout::showsStructure() const {
    return m_structure && m_structure->isVisible() && m_session.shownViews().size() <= 2;
}

LessonHandout::Page LessonHandout::page() const {
    const std::string language = m_language.current().toStdString();
    Page page{QString::fromStdString(textIn(m_lessons.current().sentence, language)),
              QString::fromStdString(textIn(m_lessons.current().notes, language)),
              {},
              showsStructure() ? beside(m_views.grab().toImage(), m_structure->grab().toImage()) : m_views.grab().toImage()};
    for (const int view : m_session.shownViews()) {
        // A view that watches another one has no figures of its own.
        if (m_session.culledBy(view) != view) continue;
        const ViewHeader& header = m_views.pane(view).header();
        page.figures << QStringLiteral("%1: %2 · %3").arg(viewLetter(view), header.firstLine(), header.secondLine());
    }
    return page;
}

void LessonHandout::look() {
    if (!m_lessons.active()) return cancel();
    // A scene that cannot be opened has been said; the handout shows what there is.
    const bool failed = !m_lessons.opening() && !m_session.opened() && !m_session.loader().loading();
    if (!settled() && !failed) return;
    m_pages.push_back(page());
    const int next = int(m_pages.size());
    if (next >= m_lessons.count()) return end();
    m_lessons.go(next);
    emit progressed(next, m_lessons.count());
}

void LessonHandout::end() {
    m_poll.stop();
    try {
        write();
        emit done(m_file);
    } catch (const Error& error) {
        emit failed(error.message());
    }
    m_pages.clear();
    m_lessons.go(m_before);
}

QString LessonHandout::html(bool embedded) const {
    const QString title = QString::fromStdString(textIn(m_lessons.lesson().title, m_language.current().toStdString()));
    QString text = QStringLiteral(
                       "<!DOCTYPE html>\n<html lang=\"%1\"><head><meta charset=\"utf-8\"><title>%2</title>\n"
                       "<style>body { font-family: sans-serif; max-width: 60em; margin: 2em auto; } "
                       "img { max-width: 100%; border: 1px solid #999; }</style></head>\n<body>\n<h1>%2</h1>\n")
                       .arg(QString(m_language.current()).replace(QLatin1Char('_'), QLatin1Char('-')), title.toHtmlEscaped());
    for (size_t i = 0; i < m_pages.size(); ++i) {
        const Page& page = m_pages[i];
        const QString name = embedded
                                 ? QStringLiteral("data:image/png;base64,") + QString::fromLatin1(pngOf(page.picture).toBase64())
                                 : QString::fromLatin1(kStepImageName).arg(i + 1);
        const QSize fitting = page.picture.size().scaled(kHandoutPictureWidth, kHandoutPictureHeight, Qt::KeepAspectRatio);
        const QString size = embedded ? QString() : QStringLiteral(" width=\"%1\"").arg(fitting.width());
        // On paper a sentence and its picture are not parted.
        const bool newPage = !embedded && i > 0 && i % 2 == 0;
        text += QStringLiteral("<h3%3>%1. %2</h3>\n")
                    .arg(QString::number(i + 1), page.sentence.toHtmlEscaped(),
                         newPage ? QStringLiteral(" style=\"page-break-before: always\"") : QString());
        text += QStringLiteral("<p><img src=\"%1\"%2 alt=\"\"></p>\n<p>").arg(name, size);
        for (const QString& line : page.figures) text += line.toHtmlEscaped() + QStringLiteral("<br>\n");
        text += QStringLiteral("</p>\n");
        if (!page.notes.isEmpty()) text += QStringLiteral("<p><i>%1</i></p>\n").arg(page.notes.toHtmlEscaped());
    }
    return text + QStringLiteral("</body></html>\n");
}

void LessonHandout::write() const {
    QByteArray bytes;
    if (isPdf(m_file)) {
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        QPdfWriter writer(&buffer);
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setTitle(QString::fromStdString(textIn(m_lessons.lesson().title, m_language.current().toStdString())));
        QTextDocument document;
        for (size_t i = 0; i < m_pages.size(); ++i)
            document.addResource(QTextDocument::ImageResource, QUrl(QString::fromLatin1(kStepImageName).arg(i + 1)),
                                 m_pages[i].picture);
        document.setHtml(html(false));
        document.print(&writer);
    } else {
        bytes = html(true).toUtf8();
    }
    writeFileAtomically(m_file.toStdString(), [&](std::ostream& out) { out.write(bytes.constData(), bytes.size()); });
}

}  // namespace cullscope::ui
