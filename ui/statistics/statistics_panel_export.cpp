// The export of the statistics to files.
#include <QFileDialog>

#include "core/experiments/result_file.h"
#include "ui/plots/plot_file.h"
#include "ui/plots/result_exporter.h"
#include "ui/statistics/html_report.h"
#include "ui/statistics/pareto_plot.h"
#include "ui/statistics/path_plot.h"
#include "ui/statistics/pose_strip.h"
#include "ui/statistics/run_figures.h"
#include "ui/statistics/sphere_map.h"
#include "ui/statistics/statistics_panel.h"
#include "ui/statistics/time_bar.h"

namespace cullscope::ui {

namespace {

constexpr int kPlotWidth = 960;
constexpr int kPlotHeight = 420;

QSize sizeOf(const PlotWidget& plot) { return {kPlotWidth, std::max(kPlotHeight, plot.neededHeight(kPlotWidth))}; }

/// The size of a plot in the report; plots of one row per strategy take only the height of their rows.
QSize reportSizeOf(const PlotWidget& plot, bool rows) {
    return rows ? QSize(kPlotWidth, plot.neededHeight(kPlotWidth)) : sizeOf(plot);
}

}  // namespace

void StatisticsPanel::setUpMenu() {
    for (const File file : {File::Csv, File::Json, File::Svg, File::Pdf, File::Html, File::Report}) {
        QAction* action = m_menu->addAction({}, this, [this, file] { askWhereTo(file); });
        action->setData(int(file));
    }
}

std::vector<ReportPlot> StatisticsPanel::reportPlots() const {
    std::vector<ReportPlot> plots;
    const auto add = [&](const PlotWidget& plot, bool rows) {
        if (!plot.empty()) plots.push_back({plot.title(), plotSvg(plot, reportSizeOf(plot, rows))});
    };
    const std::vector<RunFigures> runs = runFigures(*m_result);
    // The window shows the poses of one strategy at a time, the report those of all strategies.
    const auto addEachRun = [&](PosePlot&& plot) {
        plot.setFont(font());
        for (const RunFigures& run : runs) {
            plot.setRun(run, m_result->request.path.poses.size());
            add(plot, false);
        }
    };
    add(*m_times, true);
    addEachRun(PoseStrip());
    add(*m_path, false);
    add(*m_pareto, false);
    addEachRun(SphereMap());
    return plots;
}

void StatisticsPanel::askWhereTo(File file) {
    const std::array<QString, 6> endings{QStringLiteral("csv"), QStringLiteral("json"), QStringLiteral("svg"),
                                         QStringLiteral("pdf"), QStringLiteral("html"), QStringLiteral("pdf")};
    const QString ending = endings[size_t(file)];
    QFileDialog dialog(this, tr("Export"), {}, QStringLiteral("%1 (*.%2)").arg(ending.toUpper(), ending));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(ending);
    if (dialog.exec() == QDialog::Accepted) exportTo(file, dialog.selectedFiles().front().toStdString());
}

void StatisticsPanel::exportTo(File file, const std::filesystem::path& path) {
    if (file == File::Svg || file == File::Pdf) {
        const PlotWidget* plot = currentPlot();
        if (!plot || plot->empty()) return;
        const QSize size = reportSizeOf(*plot, plot == m_times);
        const QByteArray bytes = file == File::Svg ? plotSvg(*plot, size) : plotPdf(*plot, size);
        return m_exporter->write(path, [bytes] { return bytes; });
    }
    if (!m_result) return;
    if (file == File::Html || file == File::Report) {
        // Render the plots here: widgets are painted on the window's thread only.
        const ReportParts parts{measureCommand(m_result->request, m_origin), m_scenePicture(), reportPlots()};
        if (file == File::Html) return m_exporter->write(path, [result = *m_result, parts] { return htmlReport(result, parts); });
        // A text document is laid out on the window's thread only, too.
        return m_exporter->write(path, [bytes = pdfReport(*m_result, parts)] { return bytes; });
    }
    m_exporter->write(path, [result = *m_result, file] {
        return QByteArray::fromStdString(file == File::Csv ? resultCsv(result) : resultJson(result));
    });
}

}  // namespace cullscope::ui
