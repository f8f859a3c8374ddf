#include "ui/panels/strategy_panel.h"

#include <QAbstractItemView>
#include <QEvent>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include "core/visibility/registry.h"
#include "ui/look/wheel_guard.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

/// Paints a strategy's name followed by its id in grey.
class StrategyDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        painter->save();
        const QPalette::ColorGroup group = option.state & QStyle::State_Enabled ? QPalette::Active : QPalette::Disabled;
        QColor colour =
            option.palette.color(group, option.state & QStyle::State_Selected ? QPalette::HighlightedText : QPalette::Text);
        colour.setAlpha(160);
        painter->setPen(colour);
        painter->drawText(option.rect.adjusted(0, 0, -8, 0), Qt::AlignRight | Qt::AlignVCenter, id(index));
        painter->restore();
    }

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const QSize size = QStyledItemDelegate::sizeHint(option, index);
        return {size.width() + option.fontMetrics.horizontalAdvance(id(index)) + 32, size.height() + 6};
    }

private:
    static QString id(const QModelIndex& index) { return index.data(StrategyModel::IdRole).toString(); }
};

}  // namespace

StrategyPanel::StrategyPanel(Session& session, QWidget* parent)
    : QGroupBox(parent),
      m_session(session),
      m_model(new StrategyModel([&session](const StrategyInfo& info) { return session.unavailable(info); }, this)),
      m_choice(new QComboBox(this)),
      m_description(new QLabel(this)),
      m_form(new ParameterForm(this)) {
    auto* layout = new QVBoxLayout(this);
    m_choice->setModel(m_model);
    m_choice->setItemDelegate(new StrategyDelegate(m_choice));
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_description->setWordWrap(true);
    m_description->setTextFormat(Qt::RichText);
    leaveWheelUnlessFocused(*m_choice);
    m_form->setTabPredecessor(m_choice);
    layout->addWidget(m_choice);
    layout->addWidget(m_description);
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
    refresh();
}

void StrategyPanel::refresh() {
    const StrategySlot& slot = m_session.slot(culling());
    const StrategyInfo& info = findStrategy(slot.id()).info;
    setTitle(m_session.viewCount() > 1 ? tr("Strategy of view %1").arg(viewLetter(culling())) : tr("Strategy"));
    m_choice->setCurrentIndex(m_model->rowOf(slot.id()));
    m_choice->setAccessibleName(tr("Strategy"));
    m_choice->setToolTip(translated(info.description));
    QString grey = palette().color(QPalette::Disabled, QPalette::WindowText).name();
    m_description->setText(
        QStringLiteral("%1 <span style='color:%2'>%3</span>")
            .arg(translated(info.description).toHtmlEscaped(), grey, QString::fromStdString(info.id).toHtmlEscaped()));
    m_form->setParameters(slot.parameters());
}

void StrategyPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        m_model->retranslate();
        refresh();
    }
    QGroupBox::changeEvent(event);
}

}  // namespace cullscope::ui
