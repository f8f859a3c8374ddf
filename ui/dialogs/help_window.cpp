#include "ui/dialogs/help_window.h"

#include <QHBoxLayout>
#include <QImage>
#include <QVBoxLayout>

namespace cullscope::ui {

namespace {

constexpr QSize kUsualSize{760, 640};
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
      m_first(new QToolButton(this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    auto* buttons = new QHBoxLayout;
    buttons->setContentsMargins(8, 4, 8, 4);
    for (QToolButton* button : {m_back, m_first}) {
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
        buttons->addWidget(button);
    }
    buttons->addStretch();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(buttons);
    layout->addWidget(m_page);
    m_page->setFrameShape(QFrame::NoFrame);
    m_page->setOpenExternalLinks(true);
    m_page->document()->setDocumentMargin(24.0);
    resize(kUsualSize);
    m_back->setEnabled(false);
    connect(m_page, &QTextBrowser::backwardAvailable, m_back, &QWidget::setEnabled);
    connect(m_back, &QToolButton::clicked, m_page, &QTextBrowser::backward);
    connect(m_first, &QToolButton::clicked, m_page, &QTextBrowser::home);
    connect(&language, &Language::changed, this, &HelpWindow::load);
    load();
}

void HelpWindow::load() {
    setWindowTitle(tr("Help"));
    m_page->setAccessibleName(tr("Help"));
    m_back->setText(tr("◀ Back"));
    m_first->setText(tr("First page"));
    m_page->setSource(QUrl(QStringLiteral("qrc:/resources/help/help.%1.md").arg(m_language.current())));
    // The first page in the former language must not remain in the history: the new page is the history's home.
    m_page->clearHistory();
}

}  // namespace cullscope::ui
