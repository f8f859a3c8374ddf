#pragma once

#include <QToolButton>
#include <QWidget>

#include "ui/session/session.h"

namespace cullscope::ui {

/// Two lines over a view: strategy and promise; speed, submitted share and missed pixels.
class ViewHeader : public QWidget {
    Q_OBJECT

public:
    static constexpr int kLineHeight = 20;

    ViewHeader(Session& session, int view, QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override { return {320, (m_figuresHidden ? 1 : 2) * m_lineHeight}; }
    /// Letters of so many pixels, for a lecture; 0: the usual ones.
    void setLetters(int pixels);
    /// The size of the picture and how large it is shown: device pixels of the screen per picture pixel.
    void setScale(double scale);
    /// Leaves out the second line.
    void setFiguresHidden(bool hidden);
    [[nodiscard]] QString firstLine() const;
    [[nodiscard]] QString secondLine() const;
    /// The same for a width in pixels: shorter where it does not fit while the view is stepped.
    [[nodiscard]] QString secondLine(const QFontMetrics& metrics, int width) const;
    /// The first line as shown at this width: if there is no room for the strategy's name, only its id; in the large letters of a
    /// lecture the name, which the audience reads, and no id.
    [[nodiscard]] QString shownFirstLine() const;
    /// Whether text was elided in the last paint event.
    [[nodiscard]] bool elided() const { return m_elided; }

signals:
    /// The user asks for this view's context menu.
    void menuRequested(int view, const QPoint& globalPosition);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    /// A piece of the first line in one font and colour.
    struct Part {
        QString text;
        bool bold = false;
        bool subdued = false;
        bool joined = false;              ///< no gap after it
        bool apart = false;               ///< a visible gap after it, in the tightest line, too
        std::optional<Promise> marker{};  ///< painted before the text
    };
    struct FirstLine {
        std::vector<Part> parts;
        int margin = 0;  ///< pixels at the ends of the line and between its parts
    };

    void refresh();
    void placeButton();
    [[nodiscard]] int menuLeft() const { return width() - m_lineHeight - 2; }
    /// What the first line has besides the view's letter.
    struct Contents {
        bool name = true, promise = true, word = true, id = true;
    };
    [[nodiscard]] std::vector<Part> parts(const Contents& contents) const;
    [[nodiscard]] FirstLine fittingLine() const;
    [[nodiscard]] static int gapAfter(const Part& part, const FirstLine& line);
    [[nodiscard]] int widthOf(const FirstLine& line) const;
    [[nodiscard]] int markerSize() const;
    [[nodiscard]] QFont face(bool bold) const;
    void paintFirstLine(QPainter& painter);
    /// Paints text into a rectangle, elided if it does not fit.
    void write(QPainter& painter, const QRect& place, const QString& text);
    [[nodiscard]] std::optional<Promise> promise() const;
    [[nodiscard]] const StrategyInfo& info() const;
    [[nodiscard]] QString roleWord() const;
    /// The picture's size and its scale for the end of the second line, the longer text first.
    [[nodiscard]] QStringList sizeTexts() const;
    [[nodiscard]] QString sizeSentence() const;

    Session& m_session;
    int m_view;
    QToolButton* m_measure;
    QToolButton* m_menu;
    int m_lineHeight = kLineHeight;
    bool m_large = false;  ///< letters of a lecture
    double m_scale = 1.0;
    bool m_figuresHidden = false;
    bool m_elided = false;
};

}  // namespace cullscope::ui
