#include "ui/views/view_pane.h"

#include <QLocale>
#include <cmath>

#include "core/measure/accuracy.h"
#include "core/visibility/registry.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr int kChipInset = 8;
constexpr double kPictureOverStrip = 0.55;  // its share of the height that a strip leaves
constexpr double kUsualPace = 1.0;
constexpr double kLettersOfLecture = 20.0;  // pixels, at 1280 × 720
constexpr double kSignsOfLetters = 0.81;    // pixels of the window for a unit: a letter in the picture, 18 high, is a capital
constexpr double kUnitSteps = 4.0;          // the unit of signs changes by quarters

}  // namespace

ViewPane::ViewPane(Session& session, int view, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_view(view),
      m_header(new ViewHeader(session, view, this)),
      m_picture(new SceneView(session, view, this)),
      m_budget(new BudgetBar(this)),
      m_chip(new QLabel(m_picture)) {
    setAutoFillBackground(true);
    m_chip->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_chip->setAutoFillBackground(true);
    m_chip->setForegroundRole(QPalette::ToolTipText);
    m_chip->setBackgroundRole(QPalette::ToolTipBase);
    m_chip->setMargin(4);
    const auto mine = [this](int changed) {
        if (changed == m_view || changed == m_session.culledBy(m_view)) refresh();
    };
    connect(&session, &Session::sceneChanged, m_budget, &BudgetBar::clear);
    connect(&session, &Session::cameraChanged, this, &ViewPane::refreshChip);
    connect(&session, &Session::hiddenChanged, this, &ViewPane::refreshChip);
    connect(&session, &Session::sectionChanged, this, &ViewPane::refreshChip);
    connect(&session, &Session::viewCountChanged, this, &ViewPane::refreshChip);
    connect(&session, &Session::setupChanged, this, mine);
    connect(&session, &Session::pictureChanged, this, mine);
    connect(&session, &Session::metricsChanged, this, mine);
    connect(&session, &Session::questionChanged, this, &ViewPane::arrange);
    connect(m_picture, &SceneView::lossMarked, this, &ViewPane::refreshChip);
    connect(m_picture, &SceneView::paceChanged, this, &ViewPane::refreshChip);
    retranslate();
}

QStringList ViewPane::lensParts() const {
    QStringList parts;
    if (m_session.chosenNear() && m_session.setup(m_view).role == Role::Linked)
        parts << tr("near plane %1").arg(QLocale().toString(m_session.camera().nearDistance, 'g', 3));
    const Camera& camera = m_session.viewingCamera(m_view);
    if (camera.projection == ProjectionKind::Parallel)
        parts << tr("parallel, height %1").arg(QLocale().toString(camera.height, 'g', 3));
    else if (std::abs((camera.fovy - m_session.defaultFovy()).degrees()) > 0.05)
        parts << tr("field of view %1°").arg(QLocale().toString(camera.fovy.degrees(), 'f', 1));
    if (!parts.isEmpty()) parts = {tr("%1 (Home resets)").arg(parts.join(QStringLiteral(" · ")))};
    return parts;
}

QString ViewPane::visibleSets() const {
    const Wipe wipe = m_picture->extras().wipe;
    if (wipe.mode != Wipe::Mode::Difference) return {};
    const ViewMetrics &mine = m_session.figures(m_view), &others = m_session.figures(wipe.other);
    const auto known = [](const ViewMetrics& figures) { return figures.state == ViewMetrics::State::Ready && figures.states; };
    if (!known(mine) || !known(others) || mine.subject.buffers->scenePointer() != others.subject.buffers->scenePointer() ||
        !(mine.subject.culling == others.subject.culling) || !(mine.subject.size == others.subject.size))
        return {};
    const VisibleSetDifference sets = compareVisibleSets(*mine.states, *others.states);
    return tr("visible triangles in both: %1, only here: %2, only in view %3: %4")
        .arg(countText(sets.both), countText(sets.onlyFirst), viewLetter(wipe.other), countText(sets.onlySecond));
}

QString ViewPane::markedPixels(const ViewPicture& shown) const {
    const ViewMetrics& figures = m_session.figures(m_view);
    // What snapping explains is known of the frame that was counted, seen by its own camera.
    const bool counted = figures.state == ViewMetrics::State::Ready && figures.frame &&
                         figures.frame->request.sameFrame(shown.frame->request) &&
                         shown.request.viewing == shown.request.culling && figures.accuracy.missedPixels == shown.missed;
    if (m_session.stepOf(m_view))
        return tr("missing up to this step, pixels: %1, nearer than the truth: %2")
            .arg(countText(shown.missed), countText(shown.added));
    const uint64_t lost = counted ? figures.lostPixels() : shown.missed;
    if (lost == shown.missed)
        return tr("missed pixels: %1, nearer than the truth: %2").arg(countText(lost), countText(shown.added));
    return tr("missed pixels: %1, within snapping and not lost: %2, nearer than the truth: %3")
        .arg(countText(lost), countText(shown.missed - lost), countText(shown.added));
}

QString ViewPane::chipText() const {
    // A refused strategy has no picture: state only the reason.
    if (m_session.slot(m_session.culledBy(m_view)).refused()) return translated(m_session.figures(m_view).failure);
    // In a lecture its numbers come when they are asked for.
    if (m_figuresHidden) return {};
    QStringList parts;
    const ViewSetup& setup = m_session.setup(m_view);
    if (m_session.setup(m_session.culledBy(m_view)).role == Role::Frozen) parts << tr("culling frozen (F)");
    const StrategySlot& slot = m_session.slot(m_session.culledBy(m_view));
    if (const auto reason = unserved(findStrategy(slot.id()).info, slot.parameters(), m_session.cullingCamera(m_view)))
        parts << translated(*reason);
    const ViewPicturePointer shown = m_session.picture(m_view);
    if (shown && shown->request.coarse)
        parts << (shown->request.look.has(Show::Kind::Verdicts) && shown->request.look.has(Show::Kind::Left)
                      ? tr("coarse while it moves: %1 of %2 triangles, by object; what lies outside as boxes")
                      : tr("coarse while it moves: %1 of %2 triangles, by object"))
                     .arg(countText(shown->request.coarse->objects->triangleCount()),
                          countText(shown->request.buffers->scene().triangleCount()));
    // At a step it may be that nothing is drawn yet.
    if (m_picture->showsNothing() && !m_session.stepOf(m_view)) parts << tr("nothing in view: Home");
    parts << lensParts();
    if (m_picture->pace() != kUsualPace)
        parts << tr("flying speed × %1 ([ and ])").arg(QLocale().toString(m_picture->pace(), 'g', 3));
    if (setup.look.has(Show::Kind::Wireframe) && !setup.look.inPlace()) parts << tr("wireframe; figures of the filled picture");
    if (m_session.section() && !setup.look.inPlace()) parts << tr("cut by a plane; figures of the whole scene");
    if (setup.upload == Upload::VertexArray) parts << tr("vertex arrays");
    const auto hidden = std::count(m_session.hidden().begin(), m_session.hidden().end(), true);
    if (hidden > 0) parts << tr("hidden objects: %1").arg(hidden);
    const PictureExtras extras = m_picture->extras();
    if (shown && shown->request.wipe == Wipe::Mode::Loss) parts << markedPixels(*shown);
    if (shown && shown->request.wipe == Wipe::Mode::Difference)
        parts << tr("%1 pixels differ from view %2").arg(countText(shown->missed + shown->added), viewLetter(extras.wipe.other));
    if (const QString sets = visibleSets(); !sets.isEmpty()) parts << sets;
    const std::vector<Hole>& holes = m_session.figures(m_view).holes;
    if (const std::optional<size_t> loss = m_picture->markedLoss(); loss && *loss < holes.size() && !setup.look.inPlace())
        parts << (m_session.figures(m_view).lostPixels() > 0 ? tr("loss %1 of %2, pixels: %3")
                  : setup.wipe.mode == Wipe::Mode::Loss      ? tr("difference %1 of %2, pixels: %3")
                                                             : tr("difference within snapping %1 of %2, pixels: %3"))
                     .arg(*loss + 1)
                     .arg(holes.size())
                     .arg(countText(holes[*loss].pixels));
    return parts.join(QStringLiteral(" · "));
}

void ViewPane::refresh() {
    m_budget->setFigures(m_session.figures(m_view));
    refreshChip();
}

void ViewPane::refreshChip() {
    const QString text = chipText();
    m_chip->setText(text);
    m_chip->setVisible(!text.isEmpty());
    const int room = m_picture->width() - 2 * kChipInset;
    // What a wrapped text would like to have is less than its line needs.
    m_chip->setWordWrap(false);
    m_chip->setWordWrap(m_chip->sizeHint().width() > room);
    m_chip->resize(m_chip->wordWrap() ? QSize(room, m_chip->heightForWidth(room)) : m_chip->sizeHint());
    m_picture->setFoot(0);
    // What is marked must not be covered by the words that count it. A picture that fits the window keeps its size.
    const Wipe::Mode mode = m_session.setup(m_view).wipe.mode;
    const bool marks = mode == Wipe::Mode::Loss || mode == Wipe::Mode::Difference;
    if (marks && !text.isEmpty() && m_session.setup(m_view).size && roomBelow() < m_chip->height())
        m_picture->setFoot(m_chip->height());
    m_header->setScale(m_picture->pictureLayout().scale());
    m_chip->move(chipPlace());
}

int ViewPane::roomBelow() const { return m_picture->height() - m_picture->pictureLayout().rect().toAlignedRect().bottom() - 1; }

/// Beside the picture where a letterboxed one leaves room for the chip, else in its upper left corner.
QPoint ViewPane::chipPlace() const {
    if (roomBelow() >= m_chip->height()) return {kChipInset, m_picture->height() - m_chip->height()};
    return {kChipInset, kChipInset};
}

void ViewPane::retranslate() {
    m_picture->setAccessibleName(tr("Picture of view %1").arg(viewLetter(m_view)));
    m_picture->setAccessibleDescription(tr("Arrow keys turn, plus and minus zoom, Shift with arrow keys pans, W A S D Q E fly."));
    refreshChip();
}

void ViewPane::setCompare(bool compare) {
    m_compare = compare;
    arrange();
}

void ViewPane::setLent(Lent lent, int letters) {
    if (lent == m_lent && letters == m_letters) return;
    m_lent = lent;
    m_letters = letters;
    QFont large;
    if (lent != Lent::No) large.setPixelSize(letters);
    setFont(large);
    m_header->setLetters(lent == Lent::No ? 0 : letters);
    if (lent == Lent::No)
        m_picture->setUnit(1.0);
    else
        m_picture->setUnit(std::max(1.0, letters / kLettersOfLecture), letters);
    arrange();
}

void ViewPane::setFiguresHidden(bool hidden) {
    if (hidden == m_figuresHidden) return;
    m_figuresHidden = hidden;
    m_header->setFiguresHidden(hidden);
    arrange();
}

void ViewPane::setPanel(QWidget* panel) {
    delete m_panel;
    m_panel = panel;
    if (panel) {
        panel->setParent(this);
        panel->show();
    }
    arrange();
}

void ViewPane::setStrip(QWidget* strip) {
    delete m_strip;
    m_strip = strip;
    if (strip) {
        strip->setParent(this);
        strip->show();
    }
    arrange();
}

void ViewPane::arrange() {
    m_picture->setVisible(!m_panel);
    m_budget->setVisible(!m_panel && !m_session.question() && !m_figuresHidden);
    if (m_strip) m_strip->setVisible(!m_panel);
    m_header->setVisible(m_lent != Lent::Alone);
    const int top = m_lent == Lent::Alone ? 0 : m_header->sizeHint().height();
    m_header->setGeometry(0, 0, width(), top);
    if (m_panel) {
        m_panel->setGeometry(0, top, width(), height() - top);
        return;
    }
    const int bar = m_figuresHidden ? 0 : m_budget->sizeHint().height();
    QSize picture(width(), std::max(1, height() - top - bar));
    if (m_strip) picture.setHeight(std::max(1, int(kPictureOverStrip * picture.height())));
    if (m_compare) picture = QSize(4, 3).scaled(picture, Qt::KeepAspectRatio);
    m_picture->setGeometry((width() - picture.width()) / 2, top, picture.width(), picture.height());
    m_budget->setGeometry(0, top + picture.height(), width(), bar);
    if (m_strip)
        m_strip->setGeometry(0, top + picture.height() + bar, width(), std::max(1, height() - top - picture.height() - bar));
    refreshChip();
    // Signs in the picture are as high as the capitals of a lecture's letters, however small the picture is shown.
    const double least = kSignsOfLetters * m_letters / kLettersOfLecture / m_picture->pictureLayout().scale();
    m_session.setPictureUnit(m_view, m_lent == Lent::No ? 1.0 : std::max(1.0, std::ceil(kUnitSteps * least) / kUnitSteps));
}

void ViewPane::resizeEvent(QResizeEvent*) { arrange(); }

void ViewPane::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
