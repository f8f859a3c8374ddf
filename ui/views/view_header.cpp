#include "ui/views/view_header.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>

#include "core/visibility/registry.h"
#include "ui/look/promise_marker.h"
#include "ui/look/wrapped_tips.h"
#include "ui/models/metrics_words.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr int kMargin = 8;
constexpr int kShortMargin = 4;
constexpr int kTightMargin = 2;  // among the large letters of a lecture
constexpr int kMarkerSize = 11;
constexpr int kFontPixels = 14;

constexpr const char* kJoint = " · ";  // between the role and the strategy's name

/// A grey with a contrast of at least 4.5 to the background, in both palettes.
QColor subdued(const QPalette& palette) {
    const QColor text = palette.color(QPalette::WindowText);
    const QColor back = palette.color(QPalette::Window);
    const auto mix = [](int a, int b) { return (65 * a + 35 * b) / 100; };
    return {mix(text.red(), back.red()), mix(text.green(), back.green()), mix(text.blue(), back.blue())};
}

}  // namespace

ViewHeader::ViewHeader(Session& session, int view, QWidget* parent)
    : QWidget(parent), m_session(session), m_view(view), m_measure(new QToolButton(this)), m_menu(new QToolButton(this)) {
    setLetters(0);
    m_measure->hide();
    m_menu->setAutoRaise(true);
    m_menu->setArrowType(Qt::DownArrow);
    m_menu->setFocusPolicy(Qt::TabFocus);
    connect(m_menu, &QToolButton::clicked, this,
            [this] { emit menuRequested(m_view, m_menu->mapToGlobal(QPoint(0, m_menu->height()))); });
    connect(m_measure, &QToolButton::clicked, &session, &Session::requestFigures);
    const auto mine = [this](int changed) {
        if (changed == m_view || changed == m_session.culledBy(m_view)) refresh();
    };
    connect(&session, &Session::setupChanged, this, mine);
    connect(&session, &Session::strategyChosen, this, mine);
    connect(&session, &Session::strategyBuilt, this, mine);
    connect(&session, &Session::metricsChanged, this, mine);
    for (const auto signal : {&Session::activeViewChanged, &Session::stepChanged, &Session::questionChanged})
        connect(&session, signal, this, &ViewHeader::refresh);
    connect(&session, &Session::viewCountChanged, this, &ViewHeader::refresh);
    refresh();
}

void ViewHeader::setLetters(int pixels) {
    const int letters = pixels > 0 ? pixels : kFontPixels;
    m_large = pixels > 0;
    m_lineHeight = pixels > 0 ? letters * kLineHeight / kFontPixels : kLineHeight;
    QFont font = this->font();
    font.setPixelSize(letters);
    setFont(font);
    setFixedHeight(sizeHint().height());
    m_measure->setFixedHeight(m_lineHeight);
    placeButton();
    update();
}

void ViewHeader::setScale(double scale) {
    if (scale == m_scale) return;
    m_scale = scale;
    refresh();
}

void ViewHeader::setFiguresHidden(bool hidden) {
    m_figuresHidden = hidden;
    setFixedHeight(sizeHint().height());
    refresh();
}

std::optional<Promise> ViewHeader::promise() const {
    // If the promise depends on the eye point, the metrics hold the promise at the measured one.
    const ViewMetrics& figures = m_session.figures(m_view);
    if (figures.state == ViewMetrics::State::Ready) return figures.promise;
    const BuiltStrategyPointer& built = m_session.slot(m_session.culledBy(m_view)).built();
    // While the chosen strategy is being built, built() returns the former one.
    if (!built || built->id() != info().id) return std::nullopt;
    return built->promise();
}

QString ViewHeader::firstLine() const {
    const QString role = roleWord();
    const QString name = role.isEmpty() ? translated(info().name) : role + QString::fromUtf8(kJoint) + translated(info().name);
    return promise() ? tr("%1: %2", "strategy: promise").arg(name, promiseWord(*promise())) : name;
}

const StrategyInfo& ViewHeader::info() const { return findStrategy(m_session.slot(m_session.culledBy(m_view)).id()).info; }

QString ViewHeader::roleWord() const {
    switch (m_session.setup(m_view).role) {
        case Role::Linked:
            return {};
        case Role::Observer:
            return tr("watches %1", "letter of a view").arg(viewLetter(m_session.setup(m_view).observed));
        case Role::Frozen:
            return tr("frozen");
    }
    return {};
}

QString ViewHeader::secondLine() const {
    if (m_session.question()) return tr("What do you expect? The figures come with the answer.");
    const QString figures = metricsLine(m_session.figures(m_view));
    const ShownStep* step = m_session.stepOf(m_view);
    if (!step) return figures;
    return tr("step %1 of %2 · whole frame: %3").arg(countText(step->step), countText(step->count), figures);
}

QString ViewHeader::secondLine(const QFontMetrics& metrics, int width) const {
    const QString whole = secondLine();
    const ShownStep* step = m_session.stepOf(m_view);
    if (!step || m_session.question() || metrics.horizontalAdvance(whole) <= width) return whole;
    return tr("step %1 · %2", "of a narrow view, figures").arg(countText(step->step), metricsLine(m_session.figures(m_view)));
}

QStringList ViewHeader::sizeTexts() const {
    const Viewport size = m_session.renderSize(m_view);
    if (!m_session.opened() || size.width < 1) return {};
    const QString pixels = pixelText(size);
    //: Of a picture: its size in pixels, and how large the window shows it.
    return {tr("%1 · at %2 %", "size, percent").arg(pixels, QLocale().toString(100.0 * m_scale, 'f', 0)), pixels};
}

QString ViewHeader::sizeSentence() const {
    const QString pixels = pixelText(m_session.renderSize(m_view));
    if (!m_session.setup(m_view).size)
        return tr("Picture and figures: %1 pixels, which fit the window: figures change with it").arg(pixels);
    return tr("Picture and figures: %1 pixels, shown at %2 %; figures do not change with the window")
        .arg(pixels, QLocale().toString(100.0 * m_scale, 'f', 0));
}

void ViewHeader::refresh() {
    const ViewMetrics& figures = m_session.figures(m_view);
    m_measure->setText(tr("Measure"));
    m_measure->setToolTip(tr("Compare this large scene with the truth now; this may take a while"));
    m_measure->setVisible(figures.state == ViewMetrics::State::OnRequest && !m_figuresHidden);
    placeButton();
    m_menu->setToolTip(tr("What view %1 shows, and how").arg(viewLetter(m_view)));
    m_menu->setAccessibleName(m_menu->toolTip());
    QStringList lines{firstLine() + QString::fromUtf8(kJoint) + QString::fromStdString(info().id),
                      translated(info().description)};
    if (promise()) lines << tr("Promise: %1, %2", "word, sentence").arg(promiseWord(*promise()), promiseSentence(*promise()));
    const QString details = metricsDetails(figures, m_session.gpu() ? m_session.gpu()->info() : GlInfo{});
    if (m_session.opened()) lines << sizeSentence();
    if (!details.isEmpty() && !m_session.question()) lines << details;
    setToolTip(wrappedTip(lines.join(QLatin1Char('\n'))));
    setAccessibleName(
        tr("View %1: %2, %3", "letter, strategy and promise, figures").arg(viewLetter(m_view), firstLine(), secondLine()));
    update();
}

void ViewHeader::placeButton() {
    m_measure->resize(m_measure->sizeHint().width(), m_lineHeight);
    m_measure->move(width() - m_measure->width() - kMargin, m_lineHeight);
    m_menu->setGeometry(menuLeft(), 0, m_lineHeight, m_lineHeight);
}

int ViewHeader::markerSize() const { return kMarkerSize * m_lineHeight / kLineHeight; }

QFont ViewHeader::face(bool bold) const {
    QFont result = font();
    result.setBold(bold);
    return result;
}

std::vector<ViewHeader::Part> ViewHeader::parts(const Contents& contents) const {
    std::vector<Part> parts;
    if (m_session.viewCount() > 1) parts.push_back({.text = viewLetter(m_view), .bold = true, .subdued = true, .apart = true});
    if (const QString role = roleWord(); !role.isEmpty())
        parts.push_back({.text = contents.name ? role + QString::fromUtf8(kJoint) : role, .joined = contents.name});
    if (contents.name) parts.push_back({.text = translated(info().name), .bold = true});
    if (contents.promise && promise())
        parts.push_back({.text = contents.word ? promiseWord(*promise()) : QString(), .marker = promise()});
    if (contents.id) parts.push_back({.text = QString::fromStdString(info().id), .subdued = true});
    return parts;
}

int ViewHeader::gapAfter(const Part& part, const FirstLine& line) {
    return part.joined ? 0 : part.apart ? std::max(line.margin, kShortMargin) : line.margin;
}

int ViewHeader::widthOf(const FirstLine& line) const {
    int width = line.margin;
    for (const Part& part : line.parts) {
        if (part.marker) width += markerSize() + kMargin / 2;
        width += QFontMetrics(face(part.bold)).horizontalAdvance(part.text) + gapAfter(part, line);
    }
    return width;
}

ViewHeader::FirstLine ViewHeader::fittingLine() const {
    static const std::vector<Contents> inWindow{{}, {.id = false}, {.word = false, .id = false}, {.name = false}};
    static const std::vector<Contents> inLecture{
        {}, {.id = false}, {.word = false, .id = false}, {.promise = false, .id = false}, {.name = false, .word = false}};
    FirstLine line;
    for (const Contents& contents : m_large ? inLecture : inWindow) {
        for (const int margin : {kMargin, kShortMargin, kTightMargin}) {
            // The id is not worth a line without gaps.
            if (margin == kTightMargin && (!m_large || contents.id)) continue;
            line = {parts(contents), margin};
            if (widthOf(line) <= menuLeft()) return line;
        }
    }
    return line;
}

QString ViewHeader::shownFirstLine() const {
    QString shown;
    for (const Part& part : fittingLine().parts) shown += part.text + (part.joined ? QString() : QStringLiteral(" "));
    return shown.trimmed();
}

void ViewHeader::write(QPainter& painter, const QRect& place, const QString& text) {
    const QString fitting = painter.fontMetrics().elidedText(text, Qt::ElideRight, place.width());
    m_elided = m_elided || fitting != text;
    painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, fitting);
}

void ViewHeader::paintFirstLine(QPainter& painter) {
    const QColor text = palette().color(QPalette::WindowText);
    const FirstLine line = fittingLine();
    int x = line.margin;
    for (const Part& part : line.parts) {
        if (part.marker) {
            const int size = markerSize();
            drawPromiseMarker(painter, QRectF(x, (m_lineHeight - size) / 2.0, size, size), *part.marker, text);
            x += size + kMargin / 2;
        }
        painter.setFont(face(part.bold));
        painter.setPen(part.subdued ? subdued(palette()) : text);
        write(painter, QRect(x, 0, menuLeft() - x, m_lineHeight), part.text);
        x += painter.fontMetrics().horizontalAdvance(part.text) + gapAfter(part, line);
    }
}

void ViewHeader::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QPalette& colours = palette();
    painter.fillRect(rect(), colours.color(QPalette::Window));
    const bool active = m_session.activeView() == m_view;
    if (active && m_session.viewCount() > 1) painter.fillRect(0, 0, 4, height(), colours.color(QPalette::Highlight));
    m_elided = false;
    paintFirstLine(painter);
    if (m_figuresHidden) return;
    const ViewMetrics& figures = m_session.figures(m_view);
    const bool ready = figures.state == ViewMetrics::State::Ready;
    painter.setFont(face(ready && figures.lostPixels() > 0));
    painter.setPen(ready ? colours.color(QPalette::WindowText) : subdued(colours));
    const QRect second(kMargin, m_lineHeight, width() - 2 * kMargin, m_lineHeight);
    const QString text = secondLine(painter.fontMetrics(), second.width());
    write(painter, second, text);
    if (!m_measure->isHidden()) return;
    const int room = second.width() - painter.fontMetrics().horizontalAdvance(text) - 2 * kMargin;
    painter.setFont(face(false));
    painter.setPen(subdued(colours));
    for (const QString& size : sizeTexts())
        if (painter.fontMetrics().horizontalAdvance(size) <= room)
            return painter.drawText(second, Qt::AlignRight | Qt::AlignVCenter, size);
}

void ViewHeader::resizeEvent(QResizeEvent*) { placeButton(); }

void ViewHeader::mousePressEvent(QMouseEvent* event) {
    m_session.setActiveView(m_view);
    if (event->button() == Qt::RightButton) emit menuRequested(m_view, event->globalPosition().toPoint());
}

void ViewHeader::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) refresh();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
