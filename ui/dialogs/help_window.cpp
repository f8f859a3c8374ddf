#include "ui/dialogs/help_window.h"

#include <QAbstractTextDocumentLayout>
#include <QHBoxLayout>
#include <QImage>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTextBlock>
#include <QTreeWidgetItemIterator>
#include <QVBoxLayout>

namespace cullscope::ui {

namespace {

constexpr QSize kUsualSize{1060, 680};
constexpr int kContentsWidth = 260;
constexpr int kAboveHeading = 8;  // pixels
constexpr int kLeastMarked = 2;   // letters of a word that is marked
constexpr int kSectionRole = Qt::UserRole, kFoundRole = Qt::UserRole + 1;
constexpr int kImageWidth = 680;  // pixels; width of pictures in a page

/// Shows pages with pictures no wider than the window. Resource paths equal the paths in the source tree, so that links between
/// pages work in both.
class PageBrowser : public QTextBrowser {
public:
    using QTextBrowser::QTextBrowser;

    QVariant loadResource(int type, const QUrl& name) override {
        QVariant resource = QTextBrowser::loadResource(type, name);
        if (type != QTextDocument::ImageResource) return resource;
        const QImage picture = QImage::fromData(resource.toByteArray());
        if (picture.width() <= kImageWidth) return resource;
        return picture.scaledToWidth(kImageWidth, Qt::SmoothTransformation);
    }
};

}  // namespace

HelpWindow::HelpWindow(const Language& language, QWidget* parent)
    : QDialog(parent),
      m_language(language),
      m_page(new PageBrowser(this)),
      m_back(new QToolButton(this)),
      m_first(new QToolButton(this)),
      m_search(new QLineEdit(this)),
      m_contents(new QTreeWidget(this)),
      m_nothing(new QLabel(this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    auto* buttons = new QHBoxLayout;
    buttons->setContentsMargins(8, 4, 8, 4);
    for (QToolButton* button : {m_back, m_first}) {
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
        buttons->addWidget(button);
    }
    buttons->addStretch();
    auto* side = new QWidget(this);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(8, 0, 0, 8);
    column->addWidget(m_search);
    column->addWidget(m_nothing);
    column->addWidget(m_contents, 1);
    auto* split = new QSplitter(this);
    split->addWidget(side);
    split->addWidget(m_page);
    split->setSizes({kContentsWidth, kUsualSize.width() - kContentsWidth});
    split->setStretchFactor(1, 1);
    split->setChildrenCollapsible(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(buttons);
    layout->addWidget(split, 1);
    m_search->setClearButtonEnabled(true);
    m_nothing->setWordWrap(true);
    m_nothing->hide();
    m_contents->setHeaderHidden(true);
    m_contents->setFrameShape(QFrame::NoFrame);
    m_page->setFrameShape(QFrame::NoFrame);
    m_page->setOpenExternalLinks(true);
    m_page->document()->setDocumentMargin(24.0);
    resize(kUsualSize);
    m_back->setEnabled(false);
    connect(m_page, &QTextBrowser::backwardAvailable, m_back, &QWidget::setEnabled);
    connect(m_page, &QTextBrowser::sourceChanged, this, &HelpWindow::markWords);
    connect(m_back, &QToolButton::clicked, m_page, &QTextBrowser::backward);
    connect(m_first, &QToolButton::clicked, m_page, &QTextBrowser::home);
    connect(m_search, &QLineEdit::textChanged, this, &HelpWindow::showFound);
    connect(m_search, &QLineEdit::returnPressed, this, [this] {
        // The first section that has the words.
        for (QTreeWidgetItemIterator item(m_contents, QTreeWidgetItemIterator::NotHidden); *item; ++item)
            if ((*item)->data(0, kFoundRole).toBool()) return m_contents->setCurrentItem(*item);
    });
    connect(m_contents, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
        if (item) goTo(*item);
    });
    connect(&language, &Language::changed, this, &HelpWindow::load);
    load();
}

void HelpWindow::load() {
    setWindowTitle(tr("Help"));
    m_page->setAccessibleName(tr("Help"));
    m_back->setText(tr("◀ Back"));
    m_first->setText(tr("First page"));
    m_search->setPlaceholderText(tr("Search the help"));
    m_search->setAccessibleName(m_search->placeholderText());
    m_contents->setAccessibleName(tr("Contents of the help"));
    m_nothing->setText(tr("No section has all these words."));
    fillContents();
    m_page->setSource(QUrl(QStringLiteral("qrc:/resources/help/help.%1.md").arg(m_language.current())));
    // The first page in the former language must not remain in the history: the new page is the history's home.
    m_page->clearHistory();
}

void HelpWindow::fillContents() {
    const QSignalBlocker quiet(m_contents);
    m_contents->clear();
    m_sections = helpSections(m_language.current());
    QTreeWidgetItem* page = nullptr;
    for (size_t i = 0; i < m_sections.size(); ++i) {
        const HelpSection& section = m_sections[i];
        const bool first = page == nullptr || m_sections[size_t(page->data(0, kSectionRole).toInt())].page != section.page;
        auto* item = first ? new QTreeWidgetItem(m_contents) : new QTreeWidgetItem(page);
        if (first) page = item;
        item->setText(0, section.title);
        item->setToolTip(0, section.title);
        item->setData(0, kSectionRole, int(i));
    }
    m_contents->expandItem(m_contents->topLevelItem(0));
    showFound();
}

void HelpWindow::showFound() {
    const QString wanted = m_search->text().trimmed();
    bool any = false;
    for (int i = 0; i < m_contents->topLevelItemCount(); ++i) {
        QTreeWidgetItem& page = *m_contents->topLevelItem(i);
        const auto found = [&](QTreeWidgetItem& item) {
            const bool has = hasAllWords(m_sections[size_t(item.data(0, kSectionRole).toInt())], wanted);
            item.setData(0, kFoundRole, has && !wanted.isEmpty());
            return has;
        };
        bool inPage = found(page);
        for (int k = 0; k < page.childCount(); ++k) {
            const bool has = found(*page.child(k));
            page.child(k)->setHidden(!has);
            inPage = inPage || has;
        }
        page.setHidden(!inPage);
        page.setExpanded(wanted.isEmpty() ? i == 0 : inPage);
        any = any || inPage;
    }
    m_nothing->setVisible(!any);
    markWords();
}

void HelpWindow::goTo(const QTreeWidgetItem& item) {
    const HelpSection& section = m_sections[size_t(item.data(0, kSectionRole).toInt())];
    if (m_page->source() != section.page) m_page->setSource(section.page);
    for (QTextBlock block = m_page->document()->begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() != section.level || block.text().trimmed() != section.title) continue;
        const QRectF place = m_page->document()->documentLayout()->blockBoundingRect(block);
        return m_page->verticalScrollBar()->setValue(int(place.top()) - kAboveHeading);
    }
}

void HelpWindow::markWords() {
    QList<QTextEdit::ExtraSelection> marks;
    const QStringList words = m_search->text().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    for (const QString& word : words) {
        if (word.size() < kLeastMarked) continue;
        for (QTextCursor found = m_page->document()->find(word); !found.isNull(); found = m_page->document()->find(word, found)) {
            QTextEdit::ExtraSelection mark;
            mark.cursor = found;
            mark.format.setBackground(palette().color(QPalette::Highlight));
            mark.format.setForeground(palette().color(QPalette::HighlightedText));
            marks << mark;
        }
    }
    m_page->setExtraSelections(marks);
}

}  // namespace cullscope::ui
