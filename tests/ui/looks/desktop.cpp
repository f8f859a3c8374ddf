#include "tests/ui/looks/desktop.h"

#include <QMouseEvent>
#include <QRegularExpression>
#include <QStatusBar>
#include <QTableView>

#include "ui/models/metrics_model.h"
#include "ui/startup/first_views.h"
#include "ui/statistics/result_table_model.h"
#include "ui/statistics/statistics_panel.h"

namespace cullscope::ui {

namespace {

constexpr int kPaintTime = 150;  // ms that the window gets to paint its last changes
constexpr int kDragSteps = 6;

QRect placeIn(const QWidget& window, const QWidget& widget, const QRect& part) {
    return {widget.mapTo(&window, part.topLeft()), part.size()};
}

/// The rectangle of a table's times and of values computed from them.
QRect timesOf(const QTableView& table) {
    const QRect cells = table.viewport()->rect();
    if (qobject_cast<const MetricsModel*>(table.model())) {
        int last = 0;
        while (last < table.model()->rowCount() && table.model()->headerData(last, Qt::Vertical) != MetricsModel::tr("Culling"))
            ++last;
        EXPECT_LT(last, table.model()->rowCount()) << "there is no row of the time for culling";
        return cells & QRect(0, 0, cells.width(), table.rowViewportPosition(last) + table.rowHeight(last));
    }
    if (qobject_cast<const ResultTableModel*>(table.model())) {
        const int first = table.columnViewportPosition(ResultTableModel::Speedup);
        return cells & QRect(first, 0, table.columnViewportPosition(ResultTableModel::Submitted) - first, cells.height());
    }
    return {};
}

bool saysTimes(const QLabel& label, const QString& renderer) {
    static const QRegularExpression time(QStringLiteral("×\\s*[0-9.,]+($|[^0-9.,x× ])|[0-9] ms|is [0-9.]+ times as fast"));
    return label.text().contains(time) || (!renderer.isEmpty() && label.text() == renderer);
}

std::vector<QRect> maskedIn(const QWidget& window, const QString& renderer) {
    std::vector<QRect> masked;
    const auto mask = [&](const QWidget& widget, const QRect& part) {
        if (widget.isVisible() && !part.isEmpty()) masked.push_back(placeIn(window, widget, part));
    };
    for (const auto* header : window.findChildren<ViewHeader*>())
        mask(*header, header->rect().adjusted(0, ViewHeader::kLineHeight, 0, 0));
    for (const auto* table : window.findChildren<QTableView*>()) mask(*table->viewport(), timesOf(*table));
    for (const auto* label : window.findChildren<QLabel*>())
        if (saysTimes(*label, renderer)) mask(*label, label->rect());
    return masked;
}

/// The steps of the program before it makes the window.
Session& begun(Desktop& desktop, const Desktop::Start& start) {
    desktop.language.use(start.language);
    desktop.appearance.setMode(start.appearance);
    showFirstViews(desktop.session, strategiesFromText(start.strategies));
    return desktop.session;
}

}  // namespace

Desktop::Desktop() : Desktop(Start()) {}

Desktop::Desktop(const Start& start) : window(begun(*this, start), language, appearance) {
    window.resize(start.size);
    window.show();
    // Asked again: another program on the screen may take the keyboard's focus before this window was seen to have it.
    EXPECT_TRUE(waitUntil([this] {
        window.activateWindow();
        return window.isActiveWindow();
    }));
    if (!start.open) return;
    session.open(start.scene.isEmpty() ? QString::fromStdString(defaultSceneSpecification(session.sceneSource())) : start.scene);
    settle();
}

bool Desktop::settled() {
    if (session.loader().loading() || !session.opened() || !session.buffers() || !session.metricsSettled() ||
        session.pictures()->busy())
        return false;
    for (const int view : session.shownViews()) {
        if (session.slot(session.culledBy(view)).building() || !session.pictures()->isCurrent(view)) return false;
        const ViewMetrics& figures = session.figures(view);
        if (figures.state == ViewMetrics::State::Ready && !figures.timed) return false;
    }
    return true;
}

void Desktop::settle() {
    // Layout and painting may request more pictures: check again.
    do {
        ASSERT_TRUE(waitUntil([this] { return settled(); }));
        QTest::qWait(kPaintTime);
    } while (!settled());
}

Look Desktop::look(QWidget& shown) {
    Look look;
    look.renderer = QString::fromStdString(session.gpu()->info().renderer);
    look.picture = shown.grab().toImage().convertToFormat(QImage::Format_RGB32);
    // The first grab may have changed the layout.
    if (session.opened()) {
        settle();
        look.picture = shown.grab().toImage().convertToFormat(QImage::Format_RGB32);
    }
    look.masked = maskedIn(shown, look.renderer);
    for (const auto* view : shown.findChildren<SceneView*>())
        if (view->isVisible()) look.scenes.push_back(placeIn(shown, *view, view->pictureLayout().rect().toAlignedRect()));
    return look;
}

void Desktop::drag(int number, const QPoint& way, Qt::MouseButton button) {
    SceneView& widget = view(number);
    const QPointF from(widget.width() / 2.0, widget.height() / 2.0);
    const auto send = [&](QEvent::Type type, const QPointF& at, Qt::MouseButton changed, Qt::MouseButtons buttons) {
        QMouseEvent event(type, at, widget.mapToGlobal(at), changed, buttons, {});
        QApplication::sendEvent(&widget, &event);
    };
    send(QEvent::MouseButtonPress, from, button, button);
    for (int step = 1; step <= kDragSteps; ++step)
        send(QEvent::MouseMove, from + QPointF(way) * step / kDragSteps, Qt::NoButton, button);
    send(QEvent::MouseButtonRelease, from + QPointF(way), button, {});
}

void Desktop::edit(int view, const std::function<void(ViewSetup&)>& change) {
    ViewSetup setup = session.setup(view);
    change(setup);
    session.setSetup(view, setup);
}

}  // namespace cullscope::ui
