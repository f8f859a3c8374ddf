#include "ui/dialogs/screenshot_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "core/base/error.h"
#include "core/image/picture_file.h"
#include "core/scene/camera.h"
#include "core/visibility/registry.h"
#include "ui/screenshots/screenshot_words.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

using Behind = ScreenshotOptions::Background;

constexpr std::array kSizes{Viewport{1280, 720}, Viewport{1920, 1080}, Viewport{3840, 2160}};
/// Item data of the sizes that are not in kSizes.
constexpr int kAsShown = -1;
constexpr int kCustom = -2;

QSpinBox* pixelBox(int value, QWidget* parent) {
    auto* box = new QSpinBox(parent);
    box->setRange(1, kMostPixels);
    box->setValue(value);
    box->setGroupSeparatorShown(false);
    return box;
}

QWidget* row(std::initializer_list<QWidget*> widgets, QWidget* parent) {
    auto* holder = new QWidget(parent);
    auto* layout = new QHBoxLayout(holder);
    layout->setContentsMargins(0, 0, 0, 0);
    for (QWidget* widget : widgets) layout->addWidget(widget);
    return holder;
}

/// The overlays that strategies declare, beside those that all have: too many for one line of the dialog.
QString declaredOverlays() {
    QStringList declared;
    for (const Show* show : declaredShows(Show::Kind::Overlay)) {
        const QString title = translated(show->title);
        declared << title.left(1).toLower() + title.mid(1);
    }
    return ScreenshotDialog::tr("Of the strategies that have them: %1", "names of overlays")
        .arg(declared.join(ScreenshotDialog::tr(", ", "between names of overlays")));
}

}  // namespace

ScreenshotDialog::ScreenshotDialog(Session& session, ExtrasOf extras, const ScreenshotSettings& settings, QWidget* parent)
    : QDialog(parent), m_session(session), m_extras(std::move(extras)) {
    setWindowTitle(tr("Screenshot"));
    makeWidgets();
    layOut();
    choose(settings);
    for (QComboBox* box : {m_what, m_size, m_background})
        connect(box, &QComboBox::currentIndexChanged, this, &ScreenshotDialog::refresh);
    for (QSpinBox* box : {m_width, m_height}) connect(box, &QSpinBox::valueChanged, this, &ScreenshotDialog::refresh);
    for (QCheckBox* box : {m_overlays, m_legend, m_caption}) connect(box, &QCheckBox::toggled, this, &ScreenshotDialog::refresh);
    for (QLineEdit* line : {m_captionText, m_folder, m_pattern})
        connect(line, &QLineEdit::textChanged, this, &ScreenshotDialog::refresh);
    connect(m_browse, &QPushButton::clicked, this, &ScreenshotDialog::browse);
    refresh();
}

void ScreenshotDialog::makeWidgets() {
    m_what = new QComboBox(this);
    m_what->addItem(tr("View %1 alone").arg(viewLetter(m_session.activeView())), false);
    m_what->addItem(tr("All views, as they are arranged"), true);
    m_size = new QComboBox(this);
    m_size->addItem(tr("As in the window"), kAsShown);
    for (size_t i = 0; i < kSizes.size(); ++i)
        m_size->addItem(tr("%1 × %2 pixels").arg(kSizes[i].width).arg(kSizes[i].height), int(i));
    m_size->addItem(tr("Another size"), kCustom);
    m_width = pixelBox(kSizes[1].width, this);
    m_height = pixelBox(kSizes[1].height, this);
    m_background = new QComboBox(this);
    m_background->addItem(tr("As in the window"), int(Behind::AsShown));
    m_background->addItem(tr("White"), int(Behind::White));
    m_background->addItem(tr("Black"), int(Behind::Black));
    m_background->addItem(tr("Transparent"), int(Behind::Transparent));
    m_overlays = new QCheckBox(tr("&Overlays: frustum, boxes, wipe, marks, the strategy's own"), this);
    m_overlays->setToolTip(declaredOverlays());
    m_legend = new QCheckBox(tr("&Legend of the colours, with counts"), this);
    m_caption = new QCheckBox(tr("&Caption"), this);
    m_captionText = new QLineEdit(this);
    m_folder = new QLineEdit(this);
    m_browse = new QPushButton(tr("&Browse…"), this);
    m_pattern = new QLineEdit(this);
    m_pattern->setObjectName(QStringLiteral("pattern"));
    m_verdict = new QLabel(this);
    m_verdict->setWordWrap(true);
    m_verdict->setTextFormat(Qt::PlainText);
    m_verdict->setMinimumHeight(3 * fontMetrics().lineSpacing());
    m_verdict->setAlignment(Qt::AlignTop);
    m_what->setAccessibleName(tr("What is saved"));
    m_size->setAccessibleName(tr("Size"));
    m_width->setAccessibleName(tr("Width in pixels"));
    m_height->setAccessibleName(tr("Height in pixels"));
    m_background->setAccessibleName(tr("Background"));
    m_captionText->setAccessibleName(tr("Text of the caption"));
    m_folder->setAccessibleName(tr("Folder"));
    m_pattern->setAccessibleName(tr("File name"));
    m_pattern->setToolTip(
        tr("{scene}, {strategy} and {n}, a number that no file has yet, are filled in; {n:03} has three digits. "
           "The ending chooses the format: .png, .jpg, .tif or .exr."));
    m_pattern->setAccessibleDescription(m_pattern->toolTip());
}

void ScreenshotDialog::layOut() {
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(tr("&What"), m_what);
    form->addRow(tr("&Size"), m_size);
    auto* times = new QLabel(QStringLiteral("×"), this);
    times->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    for (QSpinBox* box : {m_width, m_height}) box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    form->addRow(QString(), row({m_width, times, m_height}, this));
    form->addRow(tr("Back&ground"), m_background);
    form->addRow(QString(), m_overlays);
    form->addRow(QString(), m_legend);
    form->addRow(QString(), m_caption);
    form->addRow(QString(), m_captionText);
    QWidget* folder = row({m_folder, m_browse}, this);
    form->addRow(tr("&Folder"), folder);
    if (auto* label = qobject_cast<QLabel*>(form->labelForField(folder))) label->setBuddy(m_folder);
    form->addRow(tr("File &name"), m_pattern);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this);
    m_save = buttons->button(QDialogButtonBox::Save);
    m_save->setText(tr("Save"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(m_verdict);
    layout->addWidget(buttons);
    setMinimumWidth(480);
}

void ScreenshotDialog::choose(const ScreenshotSettings& settings) {
    const ScreenshotOptions& options = settings.options;
    m_what->setCurrentIndex(m_what->findData(options.grid));
    int size = options.size ? kCustom : kAsShown;
    for (size_t i = 0; i < kSizes.size(); ++i)
        if (options.size == kSizes[i]) size = int(i);
    m_size->setCurrentIndex(m_size->findData(size));
    if (options.size) {
        m_width->setValue(options.size->width);
        m_height->setValue(options.size->height);
    }
    m_background->setCurrentIndex(m_background->findData(int(options.background)));
    m_overlays->setChecked(options.overlays);
    m_legend->setChecked(options.legend);
    m_caption->setChecked(options.caption);
    m_captionText->setText(options.captionText);
    m_folder->setText(settings.folder);
    m_pattern->setText(settings.pattern);
}

std::optional<Viewport> ScreenshotDialog::size() const {
    const int chosen = m_size->currentData().toInt();
    if (chosen == kAsShown) return std::nullopt;
    return chosen == kCustom ? Viewport{m_width->value(), m_height->value()} : kSizes[size_t(chosen)];
}

ScreenshotSettings ScreenshotDialog::settings() const {
    ScreenshotSettings settings;
    settings.options.grid = m_what->currentData().toBool();
    settings.options.size = size();
    settings.options.overlays = m_overlays->isChecked();
    settings.options.legend = m_legend->isChecked();
    settings.options.caption = m_caption->isChecked();
    settings.options.captionText = m_captionText->text().trimmed();
    settings.options.background = Behind(m_background->currentData().toInt());
    settings.folder = m_folder->text();
    settings.pattern = m_pattern->text();
    return settings;
}

void ScreenshotDialog::refresh() {
    const ScreenshotSettings chosen = settings();
    const bool custom = m_size->currentData().toInt() == kCustom;
    m_width->setEnabled(custom);
    m_height->setEnabled(custom);
    m_captionText->setEnabled(chosen.options.caption);
    m_captionText->setPlaceholderText(madeCaption(m_session, chosen.options.grid));
    try {
        const std::filesystem::path path = screenshotPath(m_session, chosen);
        const ScreenshotPlan plan = planScreenshot(m_session, chosen.options, m_extras, keepsDepth(path));
        // A name that has folders is shown with them.
        const bool whole = chosen.pattern.contains(QLatin1Char('/'));
        QString text = tr("Will be saved as %1, %2 × %3 pixels.")
                           .arg(QString::fromStdString(whole ? path.string() : path.filename().string()))
                           .arg(plan.size.width)
                           .arg(plan.size.height);
        if (keepsDepth(path) && chosen.options.grid)
            text += QLatin1Char(' ') + tr("Depth and triangle numbers are kept for one view alone.");
        if (!keepsAlpha(path) && chosen.options.background == Behind::Transparent)
            text += QLatin1Char(' ') + tr("This format keeps no transparency: the window's background takes its place.");
        m_verdict->setText(text);
        m_save->setEnabled(true);
    } catch (const Error& error) {
        m_verdict->setText(translated(error.message()));
        m_save->setEnabled(false);
    }
    m_save->setToolTip(m_save->isEnabled() ? QString() : m_verdict->text());
    m_save->setAccessibleDescription(m_verdict->text());
}

void ScreenshotDialog::browse() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for screenshots"), m_folder->text());
    if (!folder.isEmpty()) m_folder->setText(folder);
}

}  // namespace cullscope::ui
