#include "tests/ui/looks/shown_texts.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QComboBox>
#include <QGlyphRun>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSpinBox>
#include <QTabBar>
#include <QTableView>
#include <QTextDocument>
#include <QTextLayout>
#include <QTreeView>

#include "ui/views/view_header.h"

namespace cullscope::ui {

namespace {

QString plain(const QString& text) {
    if (!Qt::mightBeRichText(text)) return text;
    QTextDocument document;
    document.setHtml(text);
    return document.toPlainText();
}

QString nameOf(const QWidget& widget) {
    return QStringLiteral("%1 %2").arg(QString::fromLatin1(widget.metaObject()->className()), widget.objectName());
}

/// Collects the texts of widgets.
class Gatherer {
public:
    void add(const QWidget& widget);
    std::vector<ShownText> texts;

private:
    void say(const QString& text, const QWidget& widget, bool painted = true) {
        if (!text.trimmed().isEmpty()) texts.push_back({plain(text), widget.font(), nameOf(widget), painted});
    }
    void addMenu(const QList<QAction*>& actions, const QWidget& widget);
    void addModel(const QAbstractItemModel& model, const QModelIndex& parent, const QWidget& widget);
    void addHeaders(const QAbstractItemModel& model, Qt::Orientation orientation, const QWidget& widget);
};

void Gatherer::addMenu(const QList<QAction*>& actions, const QWidget& widget) {
    for (const QAction* action : actions) {
        say(action->text(), widget);
        say(action->toolTip(), widget, false);
        if (action->menu()) addMenu(action->menu()->actions(), widget);
    }
}

void Gatherer::addModel(const QAbstractItemModel& model, const QModelIndex& parent, const QWidget& widget) {
    constexpr int kMostRows = 50;
    for (int row = 0; row < std::min(kMostRows, model.rowCount(parent)); ++row)
        for (int column = 0; column < model.columnCount(parent); ++column) {
            const QModelIndex index = model.index(row, column, parent);
            say(index.data().toString(), widget);
            say(index.data(Qt::ToolTipRole).toString(), widget, false);
            if (column == 0) addModel(model, index, widget);
        }
}

void Gatherer::addHeaders(const QAbstractItemModel& model, Qt::Orientation orientation, const QWidget& widget) {
    const int sections = orientation == Qt::Horizontal ? model.columnCount() : model.rowCount();
    for (int section = 0; section < sections; ++section) {
        say(model.headerData(section, orientation).toString(), widget);
        say(model.headerData(section, orientation, Qt::ToolTipRole).toString(), widget, false);
    }
}

void Gatherer::add(const QWidget& widget) {
    say(widget.toolTip(), widget, false);
    say(widget.accessibleName(), widget, false);
    say(widget.accessibleDescription(), widget, false);
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) say(label->text(), widget);
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) say(button->text(), widget);
    if (const auto* group = qobject_cast<const QGroupBox*>(&widget)) say(group->title(), widget);
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) say(line->placeholderText(), widget);
    if (const auto* box = qobject_cast<const QSpinBox*>(&widget)) say(box->text(), widget);
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) addModel(*box->model(), {}, widget);
    if (const auto* bar = qobject_cast<const QMenuBar*>(&widget)) addMenu(bar->actions(), widget);
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget))
        for (int tab = 0; tab < tabs->count(); ++tab) {
            say(tabs->tabText(tab), widget);
            say(tabs->tabToolTip(tab), widget, false);
        }
    if (const auto* header = qobject_cast<const ViewHeader*>(&widget)) {
        say(header->firstLine(), widget);
        say(header->secondLine(), widget);
    }
    const auto* view = qobject_cast<const QAbstractItemView*>(&widget);
    if (!view || !view->model() || qobject_cast<const QHeaderView*>(view)) return;
    addModel(*view->model(), {}, widget);
    addHeaders(*view->model(), Qt::Horizontal, widget);
    if (qobject_cast<const QTableView*>(view)) addHeaders(*view->model(), Qt::Vertical, widget);
}

std::vector<const QWidget*> visibleWidgets(const QWidget& window) {
    std::vector<const QWidget*> visible{&window};
    for (const auto* widget : window.findChildren<QWidget*>())
        if (widget->isVisible() && widget->window() == &window) visible.push_back(widget);
    return visible;
}

/// Whether a parent cuts a widget off that the user cannot scroll into view.
bool cutOff(const QWidget& widget) {
    QRect place = widget.rect();
    for (const QWidget* child = &widget; child->parentWidget() && !child->isWindow(); child = child->parentWidget()) {
        place.translate(child->pos());
        if (qobject_cast<const QAbstractScrollArea*>(child->parentWidget()->parentWidget())) return false;
        if (!child->parentWidget()->rect().contains(place)) return true;
    }
    return false;
}

bool fits(const QLabel& label) {
    if (label.wordWrap()) return label.heightForWidth(label.width()) <= label.height();
    // The vertical margins may be smaller than the size hint asks for.
    return label.sizeHint().width() <= label.width() && label.sizeHint().height() - 2 * label.margin() <= label.height();
}

bool fits(const QAbstractButton& button) {
    const auto* tool = qobject_cast<const QToolButton*>(&button);
    if (button.text().isEmpty() || (tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly)) return true;
    if (tool) return QFontMetrics(button.font()).horizontalAdvance(button.text()) <= button.width();
    return button.sizeHint().width() <= button.width();
}

bool fits(const QComboBox& box) {
    QStyleOptionComboBox option;
    option.initFrom(&box);
    option.editable = box.isEditable();
    const QRect place = box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box);
    return QFontMetrics(box.font()).horizontalAdvance(box.currentText()) <= place.width();
}

/// Whether the bar shows all tabs, neither cut nor scrolled away.
bool fits(const QTabBar& tabs) {
    const QFontMetrics metrics(tabs.font());
    for (int tab = 0; tab < tabs.count(); ++tab)
        if (tabs.isTabVisible(tab) && (!tabs.rect().contains(tabs.tabRect(tab)) ||
                                       metrics.horizontalAdvance(tabs.tabText(tab)) > tabs.tabRect(tab).width()))
            return false;
    return true;
}

/// The width of the longest line in pixels.
int widthOf(const QString& text, const QFontMetrics& metrics) {
    int width = 0;
    for (const QString& line : text.split(QLatin1Char('\n'))) width = std::max(width, metrics.horizontalAdvance(line));
    return width;
}

/// Whether the texts of all cells and headers fit that the user has not hidden.
bool fits(const QTableView& table) {
    const QFontMetrics metrics(table.font());
    const QAbstractItemModel& model = *table.model();
    for (int column = 0; column < model.columnCount(); ++column) {
        if (table.isColumnHidden(column)) continue;
        if (widthOf(model.headerData(column, Qt::Horizontal).toString(), metrics) > table.columnWidth(column)) return false;
        for (int row = 0; row < model.rowCount(); ++row) {
            const QString text = model.index(row, column).data().toString();
            const int lines = 1 + int(text.count(QLatin1Char('\n')));
            if (widthOf(text, metrics) > table.columnWidth(column)) return false;
            if (lines > 1 && lines * metrics.lineSpacing() > table.rowHeight(row)) return false;
        }
    }
    if (!table.verticalHeader()->isVisible()) return true;
    for (int row = 0; row < model.rowCount(); ++row)
        if (metrics.horizontalAdvance(model.headerData(row, Qt::Vertical).toString()) > table.verticalHeader()->width())
            return false;
    return true;
}

bool allFits(const QWidget& widget) {
    if (const auto* label = qobject_cast<const QLabel*>(&widget))
        return label->text().isEmpty() || (fits(*label) && !cutOff(widget));
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return fits(*button) && !cutOff(widget);
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) return fits(*box) && !cutOff(widget);
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) return fits(*tabs) && !cutOff(widget);
    if (const auto* header = qobject_cast<const ViewHeader*>(&widget)) return !header->elided() && !cutOff(widget);
    if (const auto* table = qobject_cast<const QTableView*>(&widget)) return fits(*table);
    return true;
}

/// Whether the widget is the extension button of a toolbar that has no room for all of its buttons.
bool opensTheRest(const QWidget& widget) { return widget.objectName() == QLatin1String("qt_toolbar_ext_button"); }

}  // namespace

std::vector<ShownText> shownTexts(const QWidget& window) {
    Gatherer gatherer;
    for (const QWidget* widget : visibleWidgets(window)) gatherer.add(*widget);
    return gatherer.texts;
}

QStringList cutTexts(const QWidget& window) {
    QStringList cut;
    for (const QWidget* widget : visibleWidgets(window)) {
        if (allFits(*widget) && !opensTheRest(*widget)) continue;
        Gatherer gatherer;
        gatherer.add(*widget);
        QStringList texts;
        for (const ShownText& text : gatherer.texts)
            if (text.painted) texts << text.text;
        cut << QStringLiteral("%1 of %2 x %3 pixels (wants %4 x %5) cuts \"%6\"")
                   .arg(nameOf(*widget))
                   .arg(widget->width())
                   .arg(widget->height())
                   .arg(widget->sizeHint().width())
                   .arg(widget->sizeHint().height())
                   .arg(texts.join(QStringLiteral("\" \"")));
    }
    return cut;
}

QStringList textsWithMissingLetters(const std::vector<ShownText>& texts) {
    QStringList missing;
    for (const ShownText& text : texts) {
        QTextLayout layout(QString(text.text).replace(QLatin1Char('\n'), QLatin1Char(' ')), text.font);
        layout.beginLayout();
        layout.createLine();
        layout.endLayout();
        // Glyph 0 is the replacement box for a character that the font does not have.
        for (const QGlyphRun& run : layout.glyphRuns())
            if (run.glyphIndexes().contains(0)) {
                missing << QStringLiteral("%1: %2").arg(text.where, text.text);
                break;
            }
    }
    return missing;
}

QStringList englishSentences(const std::vector<ShownText>& texts, const QStringList& names) {
    static const QRegularExpression words(QStringLiteral("(?<![A-Za-z])[A-Za-z]{2,}([\\s,:;–-]+[A-Za-z]+){2,}"));
    QStringList sentences;
    for (const ShownText& text : texts) {
        QString rest = text.text;
        for (const QString& name : names) rest.replace(name, QStringLiteral("·"));
        const QRegularExpressionMatch match = words.match(rest);
        if (match.hasMatch()) sentences << QStringLiteral("%1: \"%2\" in \"%3\"").arg(text.where, match.captured(0), text.text);
    }
    sentences.removeDuplicates();
    return sentences;
}

}  // namespace cullscope::ui
