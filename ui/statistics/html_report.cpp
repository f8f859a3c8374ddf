#include "ui/statistics/html_report.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgRenderer>
#include <QTextDocument>
#include <QUrl>

#include "core/experiments/result_file.h"
#include "ui/statistics/conclusion.h"
#include "ui/statistics/result_table_model.h"
#include "ui/statistics/run_figures.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr int kPrintedWidth = 640;  // of pictures in a PDF, in the units of its text
constexpr int kPrintedLetters = 8;  // points
constexpr const char* kStyle =
    "body{font:15px/1.5 sans-serif;color:#1a1c1f;background:#fff;max-width:1100px;margin:24px auto;padding:0 16px}"
    "h1{font-size:26px;margin:0 0 8px}h2{font-size:19px;margin:28px 0 8px}table{border-collapse:collapse;margin:8px 0}"
    "th,td{padding:3px 10px;border-bottom:1px solid #d5d8dc;text-align:right;vertical-align:bottom}"
    "th:first-child,td:first-child{text-align:left}pre{background:#f3f4f5;padding:10px;white-space:pre-wrap;word-break:break-all}"
    "svg{max-width:100%;height:auto}figure{margin:8px 0}.wide{overflow-x:auto}.broken{font-weight:bold}";

QString cells(const QStringList& values, const QString& tag) {
    QString row = QStringLiteral("<tr>");
    for (const QString& value : values)
        row += QLatin1Char('<') + tag + QLatin1Char('>') +
               value.toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br>")) + QStringLiteral("</") + tag +
               QLatin1Char('>');
    return row + QStringLiteral("</tr>\n");
}

QString heading(const QString& words) { return QStringLiteral("<h2>") + words.toHtmlEscaped() + QStringLiteral("</h2>\n"); }

QString facts(const MeasureResult& result) {
    const MeasureRequest& request = result.request;
    const ToolVersion tool = toolVersion();
    const auto std = [](const std::string& words) { return QString::fromStdString(words); };
    const QString repetitions = request.timing.fixedRepetitions > 0
                                    ? QLocale().toString(request.timing.fixedRepetitions)
                                    : QCoreApplication::translate("HtmlReport", "until the median is steady");
    QString table = QStringLiteral("<table>\n");
    const auto row = [&](const QString& name, const QString& value) { table += cells({name, value}, QStringLiteral("td")); };
    row(QCoreApplication::translate("HtmlReport", "Scene"), std(request.scene->name()));
    row(QCoreApplication::translate("HtmlReport", "Triangles"), countText(request.scene->triangleCount()));
    row(QCoreApplication::translate("HtmlReport", "Objects"), countText(request.scene->instances().size()));
    row(QStringLiteral("SHA-256"), std(request.scene->sha256()));
    row(QCoreApplication::translate("HtmlReport", "Camera path"), std(request.path.name));
    row(QCoreApplication::translate("HtmlReport", "Poses measured"),
        QCoreApplication::translate("HtmlReport", "%1 of %2")
            .arg(countText(result.runs.empty() ? 0 : result.runs.front().frames.size()), countText(request.path.poses.size())));
    row(QCoreApplication::translate("HtmlReport", "Picture"),
        QStringLiteral("%1 × %2").arg(request.size.width).arg(request.size.height));
    row(QCoreApplication::translate("HtmlReport", "Pictures a frame"), QLocale().toString(request.windows));
    row(QCoreApplication::translate("HtmlReport", "Repetitions"), repetitions);
    row(QCoreApplication::translate("HtmlReport", "Processor"), std(cpuName()));
    row(QStringLiteral("OpenGL"), std(result.gl.renderer) + QStringLiteral(", ") + std(result.gl.version));
    if (result.gl.software)
        row(QString(), QCoreApplication::translate("HtmlReport", "Software OpenGL: not the times of a graphics card"));
    row(QCoreApplication::translate("HtmlReport", "Program"),
        std(tool.name + " " + tool.version + (tool.commit.empty() ? "" : " (" + tool.commit + ")")));
    return table + QStringLiteral("</table>\n");
}

QString resultTable(const MeasureResult& result) {
    QStringList titles;
    for (int column = 0; column < ResultTableModel::FirstFigure; ++column) titles << ResultTableModel::title(column);
    titles << QCoreApplication::translate("HtmlReport", "Promise");
    QString table = QStringLiteral("<div class=\"wide\"><table>\n") + cells(titles, QStringLiteral("th"));
    for (const ResultRow& row : resultRows(result)) {
        QStringList values;
        for (int column = 0; column < ResultTableModel::FirstFigure; ++column) values << ResultTableModel::value(row, column);
        QString promise = promiseWord(row.promise);
        if (row.promiseBroken) promise += QCoreApplication::translate("HtmlReport", ": broken");
        values << promise;
        table += cells(values, QStringLiteral("td"));
    }
    return table + QStringLiteral("</table></div>\n");
}

/// The field's figures by strategy: a line for each figure, since there are more of them than a page is wide.
QString figureTable(const MeasureResult& result) {
    const std::vector<ResultRow> rows = resultRows(result);
    QStringList titles{QString()};
    for (const ResultRow& row : rows) titles << row.name;
    QString table = QStringLiteral("<div class=\"wide\"><table>\n") + cells(titles, QStringLiteral("th"));
    for (int column = ResultTableModel::FirstFigure; column < ResultTableModel::columns(); ++column) {
        QStringList values{ResultTableModel::title(column).simplified()};
        for (const ResultRow& row : rows) values << ResultTableModel::value(row, column);
        table += cells(values, QStringLiteral("td"));
    }
    return table + QStringLiteral("</table></div>\n");
}

QString frameTable(const MeasureResult& result) {
    QString table = QStringLiteral("<div class=\"wide\"><table>\n");
    table +=
        cells({QCoreApplication::translate("HtmlReport", "Strategy"), QCoreApplication::translate("HtmlReport", "Pose"),
               QCoreApplication::translate("HtmlReport", "Frame, ms"), QCoreApplication::translate("HtmlReport", "Cull, ms"),
               QCoreApplication::translate("HtmlReport", "Submitted"), QCoreApplication::translate("HtmlReport", "Missed pixels"),
               QCoreApplication::translate("HtmlReport", "Covered pixels")},
              QStringLiteral("th"));
    const QLocale locale;
    for (const RunMeasurement& run : result.runs)
        for (const FrameMeasurement& frame : run.frames)
            table += cells({runLabel(run.strategy), QString::number(frame.pose), locale.toString(frame.frameMilliseconds, 'f', 3),
                            locale.toString(frame.cullMilliseconds, 'f', 3), countText(frame.submitted.triangles),
                            frame.accuracy ? countText(lostPixels(run, frame)) : QStringLiteral("–"),
                            frame.accuracy ? countText(frame.accuracy->coveredPixels) : QStringLiteral("–")},
                           QStringLiteral("td"));
    return table + QStringLiteral("</table></div>\n");
}

/// An SVG document without its XML declaration, for embedding in HTML.
QString inlined(const QByteArray& svg) { return QString::fromUtf8(svg.mid(std::max<qsizetype>(0, svg.indexOf("<svg")))); }

QByteArray pngOf(const QImage& picture) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    picture.save(&buffer, "PNG");
    return bytes;
}

/// How a report refers to its pictures: within the page itself, or by names that the document knows.
struct Pictures {
    bool embedded = true;
    QTextDocument* document = nullptr;  ///< where they are not embedded

    [[nodiscard]] QString scene(const QImage& picture) const {
        if (embedded)
            return QStringLiteral("<img src=\"data:image/png;base64,%1\" alt=\"\">")
                .arg(QString::fromLatin1(pngOf(picture).toBase64()));
        return named(QStringLiteral("scene"), picture);
    }
    [[nodiscard]] QString plot(const ReportPlot& plot, size_t number) const {
        if (embedded) return inlined(plot.svg);
        QSvgRenderer renderer(plot.svg);
        // Twice as fine as the text beside it is printed.
        QImage picture(2 * renderer.defaultSize(), QImage::Format_RGB32);
        picture.fill(Qt::white);
        QPainter painter(&picture);
        renderer.render(&painter);
        painter.end();
        return named(QStringLiteral("plot-%1").arg(number), picture);
    }

private:
    [[nodiscard]] QString named(const QString& name, const QImage& picture) const {
        document->addResource(QTextDocument::ImageResource, QUrl(name), picture);
        return QStringLiteral("<img src=\"%1\" width=\"%2\">").arg(name).arg(std::min(kPrintedWidth, picture.width()));
    }
};

QString conclusion(const MeasureResult& result) {
    QString list = heading(QCoreApplication::translate("HtmlReport", "Conclusion")) + QStringLiteral("<ul>\n");
    for (const QString& sentence : conclusionsOf(result))
        list += QStringLiteral("<li>") + sentence.toHtmlEscaped() + QStringLiteral("</li>\n");
    return list + QStringLiteral("</ul>\n");
}

QString reportPage(const MeasureResult& result, const ReportParts& parts, const Pictures& pictures) {
    const QString scene = QString::fromStdString(result.request.scene->name());
    const QString title =
        QCoreApplication::translate("HtmlReport", "Cullscope: what culling gains and loses in %1").arg(scene).toHtmlEscaped();
    QString page = QStringLiteral("<!DOCTYPE html>\n<html lang=\"%1\">\n<head>\n<meta charset=\"utf-8\">\n<title>%2</title>\n")
                       .arg(QLocale().bcp47Name(), title);
    page += QStringLiteral("<style>") + QLatin1String(kStyle) + QStringLiteral("</style>\n</head>\n<body>\n<h1>") + title +
            QStringLiteral("</h1>\n<p>") + QLocale().toString(QDateTime::currentDateTime(), QLocale::LongFormat).toHtmlEscaped();
    if (result.interrupted)
        page += QStringLiteral(" · ") +
                QCoreApplication::translate("HtmlReport", "stopped early: the poses measured until then").toHtmlEscaped();
    page += QStringLiteral("</p>\n") + conclusion(result);
    if (!parts.picture.isNull())
        page += heading(QCoreApplication::translate("HtmlReport", "The scene, as the active view showed it")) +
                QStringLiteral("<figure>") + pictures.scene(parts.picture) + QStringLiteral("</figure>\n");
    page += facts(result);
    page += heading(QCoreApplication::translate("HtmlReport", "The command that repeats it")) + QStringLiteral("<pre>") +
            parts.command.toHtmlEscaped() + QStringLiteral("</pre>\n");
    page += heading(QCoreApplication::translate("HtmlReport", "Results")) + resultTable(result);
    page += heading(QCoreApplication::translate("HtmlReport", "Errors in the field's figures, with their 95 % intervals")) +
            figureTable(result);
    for (size_t i = 0; i < parts.plots.size(); ++i)
        page += heading(parts.plots[i].title) + QStringLiteral("<figure>") + pictures.plot(parts.plots[i], i) +
                QStringLiteral("</figure>\n");
    page += heading(QCoreApplication::translate("HtmlReport", "Every frame")) + frameTable(result);
    return page + QStringLiteral("</body>\n</html>\n");
}

}  // namespace

QByteArray htmlReport(const MeasureResult& result, const ReportParts& parts) { return reportPage(result, parts, {}).toUtf8(); }

QByteArray pdfReport(const MeasureResult& result, const ReportParts& parts) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setTitle(QString::fromStdString(result.request.scene->name()));
    QTextDocument document;
    QFont font = document.defaultFont();
    font.setPointSize(kPrintedLetters);
    document.setDefaultFont(font);
    document.setHtml(reportPage(result, parts, {false, &document}));
    document.print(&writer);
    return bytes;
}

}  // namespace cullscope::ui
