#pragma once

#include <filesystem>

#include "ui/session/session.h"
#include "ui/statistics/plot_widget.h"
#include "ui/statistics/result_exporter.h"

namespace cullscope::ui {

/// A plot's context menu: copy it, or save it as SVG, PDF or PNG.
class PictureMenu : public QObject {
    Q_OBJECT

public:
    /// Belongs to the plot, which is painted in `size`, in units of 1/96 inch.
    PictureMenu(Session& session, PlotWidget& plot, const QSize& size);

    void copy() const;
    /// By the name's ending: svg, pdf or png; says in the window what is wrong with another one, or with the place.
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
