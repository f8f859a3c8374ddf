#include "ui/look/painted_icon.h"

#include <QIconEngine>

namespace cullscope::ui {

namespace {

using Draw = std::function<void(QPainter& painter, const QRectF& place)>;

class PaintedIconEngine : public QIconEngine {
public:
    PaintedIconEngine(Draw draw, double margin) : m_draw(std::move(draw)), m_margin(margin) {}

    [[nodiscard]] QIconEngine* clone() const override { return new PaintedIconEngine(m_draw, m_margin); }

    void paint(QPainter* painter, const QRect& place, QIcon::Mode, QIcon::State) override {
        m_draw(*painter, QRectF(place).adjusted(m_margin, m_margin, -m_margin, -m_margin));
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, pixmap.rect(), mode, state);
        return pixmap;
    }

private:
    Draw m_draw;
    double m_margin;
};

}  // namespace

QIcon paintedIcon(Draw draw, double margin) { return QIcon(new PaintedIconEngine(std::move(draw), margin)); }

}  // namespace cullscope::ui
