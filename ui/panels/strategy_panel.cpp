#include "ui/panels/strategy_panel.h"

#include <QAbstractItemView>
#include <QEvent>
#include <QPainter>
#include <QStyle>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>

#include "core/visibility/registry.h"
#include "ui/look/promise_marker.h"
#include "ui/look/wheel_guard.h"
#include "ui/models/metrics_words.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr int kGap = 12;  // pixels between the columns of the list
constexpr int kMarker = 10;

/// Paints a strategy in three columns: its name, the promise with its marker, and the id in grey. The columns are as wide as the
/// widest entry of the list, so that nothing lies over anything.
class StrategyDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        painter->save();
        const QPalette::ColorGroup group = option.state & QStyle::State_Enabled ? QPalette::Active : QPalette::Disabled;
        QColor colour =
            option.palette.color(group, option.state & QStyle::State_Selected ? QPalette::HighlightedText : QPalette::Text);
        const QRect inner = option.rect.adjusted(0, 0, -kGap, 0);
        const Promise promise = promiseOf(index);
        const int left = inner.right() - widestId(option.fontMetrics) - kGap - widestPromise(option.fontMetrics);
        const QRectF marker(left, inner.center().y() - kMarker / 2.0 + 1.0, kMarker, kMarker);
        drawPromiseMarker(*painter, marker, promise, colour);
        painter->setPen(colour);
        painter->drawText(inner.adjusted(left + kMarker + kGap / 2 - inner.left(), 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                          promiseWord(promise));
        colour.setAlpha(160);
        painter->setPen(colour);
        painter->drawText(inner, Qt::AlignRight | Qt::AlignVCenter, id(index));
        painter->restore();
    }

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const QSize size = QStyledItemDelegate::sizeHint(option, index);
        return {size.width() + widestPromise(option.fontMetrics) + widestId(option.fontMetrics) + 3 * kGap, size.height() + 6};
    }

private:
    static QString id(const QModelIndex& index) { return index.data(StrategyModel::IdRole).toString(); }
    static Promise promiseOf(const QModelIndex& index) { return Promise(index.data(StrategyModel::PromiseRole).toInt()); }
    static int widestId(const QFontMetrics& letters) {
        int widest = 0;
        for (const RegisteredStrategy& strategy : strategies())
            widest = std::max(widest, letters.horizontalAdvance(QString::fromStdString(strategy.info.id)));
        return widest;
    }
    static int widestPromise(const QFontMetrics& letters) {
        int widest = 0;
        for (const Promise promise : {Promise::Exact, Promise::Conservative, Promise::Approximate})
            widest = std::max(widest, letters.horizontalAdvance(promiseWord(promise)));
        return widest + kMarker + kGap / 2;
    }
};

/// Its list may be wider than the field that opens it. The width is found as the list opens: it takes the length of every name
/// for every row, and the panel is filled anew with each change of a view.
class StrategyChoice : public QComboBox {
public:
    using QComboBox::QComboBox;

    void showPopup() override {
        view()->setMinimumWidth(view()->sizeHintForColumn(0) + style()->pixelMetric(QStyle::PM_ScrollBarExtent));
        QComboBox::showPopup();
    }
};

}  // namespace

StrategyPanel::StrategyPanel(Session& session, QWidget* parent)
    : QGroupBox(parent),
      m_session(session),
      m_model(new StrategyModel([&session](const StrategyInfo& info) { return session.unavailable(info); }, this)),
      m_choice(new StrategyChoice(this)),
      m_description(new QLabel(this)),
      m_missed(new QLabel(this)),
      m_form(new ParameterForm(this)) {
    auto* layout = new QVBoxLayout(this);
    m_choice->setModel(m_model);
    m_choice->setItemDelegate(new StrategyDelegate(m_choice));
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_description->setWordWrap(true);
    m_description->setTextFormat(Qt::RichText);
    m_missed->setWordWrap(true);
    QFont strong = m_missed->font();
    strong.setBold(true);
    m_missed->setFont(strong);
    leaveWheelUnlessFocused(*m_choice);
    m_form->setTabPredecessor(m_choice);
    layout->addWidget(m_choice);
    layout->addWidget(m_description);
    layout->addWidget(m_missed);
    layout->addWidget(m_form);
    layout->addStretch(1);
    connect(m_choice, &QComboBox::activated, this, [this](int row) {
        m_session.slot(culling()).choose(m_model->index(row).data(StrategyModel::IdRole).toString().toStdString());
    });
    connect(m_form, &ParameterForm::edited, this,
            [this](const ParameterSet& parameters) { m_session.slot(culling()).setParameters(parameters); });
    connect(&session, &Session::activeViewChanged, this, &StrategyPanel::refresh);
    connect(&session, &Session::viewCountChanged, this, &StrategyPanel::refresh);
    connect(&session, &Session::strategyChosen, this, &StrategyPanel::refresh);
    connect(&session, &Session::setupChanged, this, &StrategyPanel::refresh);
    connect(&session, &Session::metricsChanged, this, &StrategyPanel::showMissed);
    connect(&session, &Session::questionChanged, this, &StrategyPanel::showMissed);
    refresh();
}

void StrategyPanel::showMissed() {
    const ViewMetrics& figures = m_session.figures(culling());
    const bool known = figures.state == ViewMetrics::State::Ready;
    // While they are counted anew, the last ones stay, so that nothing jumps while a slider is dragged.
    if (known) m_missed->setText(missedSentence(figures));
    m_missed->setEnabled(known);
    const auto isNumber = [](const ParameterDeclaration& each) {
        return each.type == ParameterType::Integer || each.type == ParameterType::Real;
    };
    const bool numbers = std::ranges::any_of(m_session.slot(culling()).parameters().declarations(), isNumber);
    const bool asked = m_session.question().has_value();
    m_missed->setVisible(numbers && !asked && (known || figures.state == ViewMetrics::State::Stale));
}

void StrategyPanel::refresh() {
    const StrategySlot& slot = m_session.slot(culling());
    const StrategyInfo& info = findStrategy(slot.id()).info;
    // Of one view, the page's own title is enough.
    setTitle(m_session.viewCount() > 1 ? tr("Strategy of view %1").arg(viewLetter(culling())) : QString());
    m_choice->setCurrentIndex(m_model->rowOf(slot.id()));
    m_choice->setAccessibleName(tr("Strategy"));
    m_choice->setToolTip(translated(info.description));
    QString grey = palette().color(QPalette::Disabled, QPalette::WindowText).name();
    m_description->setText(
        QStringLiteral("%1 <span style='color:%2'>%3</span>")
            .arg(translated(info.description).toHtmlEscaped(), grey, QString::fromStdString(info.id).toHtmlEscaped()));
    m_form->setParameters(slot.parameters());
    showMissed();
}

void StrategyPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        m_model->retranslate();
        refresh();
    }
    QGroupBox::changeEvent(event);
}

}  // namespace cullscope::ui
