#pragma once

#include <QToolButton>
#include <QWidget>

#include "ui/session/session.h"

namespace cullscope::ui {

/// Two lines over a view: what draws it and what it promises; how fast it is, how much it submits and what it misses.
class ViewHeader : public QWidget {
    Q_OBJECT

public:
    static constexpr int kLineHeight = 20;

    ViewHeader(Session& session, int view, QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override { return {320, 2 * kLineHeight}; }
    [[nodiscard]] QString firstLine() const;
    [[nodiscard]] QString secondLine() const;
    /// What the first line shows at this width: where not all has room, the strategy's id alone stands for its name.
    [[nodiscard]] QString shownFirstLine() const;
    /// Whether words had to be cut off when it was last painted.
    [[nodiscard]] bool elided() const { return m_elided; }

signals:
    /// The user asks for this view's menu.
    void menuRequested(int view, const QPoint& globalPosition);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    /// One word or more of the first line, in one face.
    struct Part {
        QString text;
        bool bold = false;
        bool subdued = false;
        bool joined = false;              ///< no gap after it
        std::optional<Promise> marker{};  ///< before the text
    };
    struct FirstLine {
        std::vector<Part> parts;
        int margin = 0;  ///< pixels beside the line and between its parts
    };

    void refresh();
    void placeButton();
    [[nodiscard]] int menuLeft() const { return width() - kLineHeight - 2; }
    [[nodiscard]] std::vector<Part> parts(bool withName) const;
    [[nodiscard]] FirstLine fittingLine() const;
    [[nodiscard]] int widthOf(const FirstLine& line) const;
    [[nodiscard]] QFont face(bool bold) const;
    void paintFirstLine(QPainter& painter);
    /// Writes into a place of this line, as much as has room.
    void write(QPainter& painter, const QRect& place, const QString& text);
    [[nodiscard]] std::optional<Promise> promise() const;
    [[nodiscard]] const StrategyInfo& info() const;
    [[nodiscard]] QString roleWord() const;

    Session& m_session;
    int m_view;
    QToolButton* m_measure;
    QToolButton* m_menu;
    bool m_elided = false;
};

}  // namespace cullscope::ui
