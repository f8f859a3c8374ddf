#pragma once

#include <QLabel>
#include <QWidget>

#include "ui/session/session.h"
#include "ui/views/scene_view.h"
#include "ui/views/view_header.h"

namespace cullscope::ui {

/// A view with its header, and a chip in the picture while the lens is not the usual one.
class ViewPane : public QWidget {
    Q_OBJECT

public:
    ViewPane(Session& session, int view, QWidget* parent = nullptr);

    [[nodiscard]] SceneView& picture() { return *m_picture; }
    [[nodiscard]] ViewHeader& header() { return *m_header; }
    /// What the chip says; empty: no chip.
    [[nodiscard]] QString chipText() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void refreshChip();
    void retranslate();

    Session& m_session;
    int m_view;
    ViewHeader* m_header;
    SceneView* m_picture;
    QLabel* m_chip;
};

/// The views side by side, all of exactly the same size, so that they share one truth.
class ViewGrid : public QWidget {
    Q_OBJECT

public:
    explicit ViewGrid(Session& session, QWidget* parent = nullptr);

    [[nodiscard]] ViewPane& pane(int view) { return *m_panes[size_t(view)]; }

signals:
    void menuRequested(int view, const QPoint& globalPosition);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void arrange();

    Session& m_session;
    std::vector<ViewPane*> m_panes;
};

}  // namespace cullscope::ui
