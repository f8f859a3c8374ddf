#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>
#include <vector>

#include "core/measure/meter.h"

namespace cullscope::ui {

/// A plot as an SVG document.
struct ReportPlot {
    QString title;
    QByteArray svg;
};

/// All that a report shows besides the result.
struct ReportParts {
    QString command;  ///< that repeats the measurement
    QImage picture;   ///< of the scene; null: none
    std::vector<ReportPlot> plots;
};

/// An experiment as one self-contained HTML page in the user's language: a conclusion in words, a picture of the scene, what was
/// measured, on which machine, the command that repeats it, a table of results and one of all frames, and the plots. Hashes the
/// scene, which takes about a second for 50 million triangles; may be called on any thread.
[[nodiscard]] QByteArray htmlReport(const MeasureResult& result, const ReportParts& parts);
/// The same as PDF, on pages of A4; the plots as pictures. Called on the window's thread.
[[nodiscard]] QByteArray pdfReport(const MeasureResult& result, const ReportParts& parts);

}  // namespace cullscope::ui
