#include "ui/dialogs/help_window.h"

#include <QFile>
#include <QVBoxLayout>

namespace cullscope::ui {

namespace {

constexpr QSize kUsualSize{760, 640};
constexpr int kImageWidth = 680;  // of pictures in the page

}  // namespace

HelpWindow::HelpWindow(const Language& language, QWidget* parent)
    : QDialog(parent), m_language(language), m_page(new QTextBrowser(this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_page);
    m_page->setFrameShape(QFrame::NoFrame);
    m_page->setOpenExternalLinks(true);
    m_page->setSearchPaths({QStringLiteral(":/help")});
    m_page->document()->setDocumentMargin(24.0);
    resize(kUsualSize);
    connect(&language, &Language::changed, this, &HelpWindow::load);
    load();
}

void HelpWindow::load() {
    setWindowTitle(tr("Help"));
    m_page->setAccessibleName(tr("Help"));
    QFile file(QStringLiteral(":/help/help.%1.md").arg(m_language.current()));
    if (!file.open(QIODevice::ReadOnly)) qFatal("there is no help page in %s", qPrintable(m_language.current()));
    m_page->setMarkdown(QString::fromUtf8(file.readAll()));
    // After the text, which takes all pictures with it.
    const QImage picture(QStringLiteral(":/help/first-window.png"));
    m_page->document()->addResource(QTextDocument::ImageResource, QUrl(QStringLiteral("first-window.png")),
                                    picture.scaledToWidth(kImageWidth, Qt::SmoothTransformation));
    m_page->moveCursor(QTextCursor::Start);
}

}  // namespace cullscope::ui
