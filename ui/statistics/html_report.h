#pragma once

#include <QByteArray>
#include <QString>
#include <vector>

#include "core/measure/meter.h"

namespace cullscope::ui {

/// A plot as an SVG document.
struct ReportPlot {
    QString title;
    QByteArray svg;
};

/// An experiment as one self-contained HTML page in the user's language: what was measured, on which machine, the command that
/// repeats it, a table of results and one of all frames, and the plots. Hashes the scene, which takes about a second for 50
/// million triangles; may be called on any thread.
[[nodiscard]] QByteArray htmlReport(const MeasureResult& result, const QString& command, const std::vector<ReportPlot>& plots);

}  // namespace cullscope::ui
