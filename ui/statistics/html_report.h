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

/// An experiment as one HTML page that needs no other file, in the user's language: what was measured, where, the command that
/// repeats it, a table of results and of every frame, and the plots. Hashes the scene: takes about a second for 50 million
/// triangles, so it may be called from any thread.
[[nodiscard]] QByteArray htmlReport(const MeasureResult& result, const QString& command, const std::vector<ReportPlot>& plots);

}  // namespace cullscope::ui
