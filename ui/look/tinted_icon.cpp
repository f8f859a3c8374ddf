#include "ui/look/tinted_icon.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>

namespace cullscope::ui {

namespace {

class TintedIconEngine : public QIconEngine {
public:
    explicit TintedIconEngine(QString file) : m_file(std::move(file)) {}

    [[nodiscard]] QIconEngine* clone() const override { return new TintedIconEngine(m_file); }

    void paint(QPainter* painter, const QRect& place, QIcon::Mode mode, QIcon::State) override {
        const QSize size = place.size() * painter->device()->devicePixelRatioF();
        painter->drawPixmap(place, tinted(size, mode));
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State) override { return tinted(size, mode); }

private:
    [[nodiscard]] QPixmap tinted(const QSize& size, QIcon::Mode mode) const {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        QSvgRenderer(m_file).render(&painter);
        painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
        const QPalette::ColorGroup group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        painter.fillRect(pixmap.rect(), QGuiApplication::palette().color(group, QPalette::ButtonText));
        return pixmap;
    }

    QString m_file;
};

}  // namespace

QIcon tintedIcon(const QString& name) { return QIcon(new TintedIconEngine(QStringLiteral(":/icons/%1.svg").arg(name))); }

}  // namespace cullscope::ui
