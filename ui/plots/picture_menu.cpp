#include "ui/plots/picture_menu.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QFileDialog>
#include <QGuiApplication>
#include <QMenu>

#include "ui/plots/plot_file.h"

namespace cullscope::ui {

PictureMenu::PictureMenu(Session& session, PlotWidget& plot, const QSize& size)
    : QObject(&plot), m_session(session), m_plot(plot), m_size(size), m_exporter(new ResultExporter(this)) {
    plot.installEventFilter(this);
    connect(m_exporter, &ResultExporter::failed, this,
            [this](const Message& message) { m_session.raise(Severity::Error, message); });
}

bool PictureMenu::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ContextMenu || m_plot.empty()) return QObject::eventFilter(watched, event);
    QMenu menu(&m_plot);
    menu.addAction(tr("Copy"), this, &PictureMenu::copy);
    menu.addAction(tr("Save picture as…"), this, &PictureMenu::askWhereTo);
    menu.exec(static_cast<QContextMenuEvent*>(event)->globalPos());
    return true;
}

void PictureMenu::copy() const { QGuiApplication::clipboard()->setImage(plotImage(m_plot, m_size)); }

void PictureMenu::askWhereTo() {
    QFileDialog dialog(&m_plot, tr("Save picture as…"), {}, QStringLiteral("SVG (*.svg);;PDF (*.pdf);;PNG (*.png)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("svg"));
    connect(&dialog, &QFileDialog::filterSelected, &dialog,
            [&dialog](const QString& filter) { dialog.setDefaultSuffix(filter.left(3).toLower()); });
    if (dialog.exec() == QDialog::Accepted) save(dialog.selectedFiles().front().toStdString());
}

void PictureMenu::save(const std::filesystem::path& path) {
    const QString ending = QString::fromStdString(path.extension().string()).toLower();
    if (ending != QLatin1String(".svg") && ending != QLatin1String(".pdf") && ending != QLatin1String(".png")) {
        m_session.raise(Severity::Error,
                        {QT_TRANSLATE_NOOP("core",
                                           "%1 cannot be written: pictures of plots are SVG, PDF or PNG. Give the name one "
                                           "of the endings .svg, .pdf and .png."),
                         {path.string()}});
        return;
    }
    const QByteArray bytes = ending == QLatin1String(".svg")   ? plotSvg(m_plot, m_size)
                             : ending == QLatin1String(".pdf") ? plotPdf(m_plot, m_size)
                                                               : plotPng(m_plot, m_size);
    m_exporter->write(path, [bytes] { return bytes; });
}

}  // namespace cullscope::ui
