#pragma once

#include <filesystem>

#include "ui/plots/plot_widget.h"
#include "ui/plots/result_exporter.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// The context menu of a plot: copies it, or saves it as SVG, PDF or PNG.
class PictureMenu : public QObject {
    Q_OBJECT

public:
    /// A child of the plot, which is painted at `size`, in units of 1/96 inch.
    PictureMenu(Session& session, PlotWidget& plot, const QSize& size);

    void copy() const;
    /// Saves by the file name extension: svg, pdf or png. Reports another extension, or a file that cannot be written, in the
    /// window.
    void save(const std::filesystem::path& path);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void askWhereTo();

    Session& m_session;
    PlotWidget& m_plot;
    QSize m_size;
    ResultExporter* m_exporter;
};

}  // namespace cullscope::ui
