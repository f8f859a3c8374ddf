#include "ui/dialogs/figures_dialog.h"

#include <QBuffer>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPointer>
#include <QScreen>
#include <QScrollArea>
#include <QVBoxLayout>
#include <array>

#include "core/base/error.h"
#include "core/experiments/han_hong_rows.h"
#include "core/gpu/context.h"
#include "core/scene/scene_source.h"
#include "ui/text/terms.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr QSize kFiguresSize{980, 860};
constexpr double kShownWidth = 900.0;  // of a figure, pixels of the desktop; files have more
constexpr int kPoses = 12;
constexpr int kPaperScene = 0, kOpenScene = 1;  // in the list of scenes

QString endingOf(FiguresDialog::File file) {
    const std::array<QString, FiguresDialog::kFileKinds> endings{QStringLiteral("png"), QStringLiteral("svg"),
                                                                 QStringLiteral("csv"), QStringLiteral("json")};
    return endings[size_t(file)];
}

/// Figures 1 and 3 show one case, Figure 4 all of them; the others all of the object.
bool ofOneCase(int number) { return number == 1 || number == 3; }
bool ofCases(int number) { return ofOneCase(number) || number == 4; }

QImage imageOf(const Picture& picture) {
    const QImage image(picture.rgba.data(), picture.size.width, picture.size.height, QImage::Format_RGBA8888);
    return image.mirrored();
}

}  // namespace

struct FiguresDialog::Page {
    std::shared_ptr<const han_hong::Figure> figure;
    QImage picture;
    ScenePointer bunny;  ///< null: the page is of the open scene
};

FiguresDialog::FiguresDialog(Session& session, QWidget* parent)
    : QDialog(parent),
      m_session(session),
      m_exporter(new ResultExporter(this)),
      m_figures(new QComboBox(this)),
      m_scenes(new QComboBox(this)),
      m_cases(new QComboBox(this)),
      m_pose(new QSpinBox(this)),
      m_shown(new QLabel),
      m_words(new QLabel(this)),
      m_save(new QPushButton(tr("&Save"), this)),
      m_close(new QPushButton(tr("C&lose"), this)),
      m_files(new QMenu(this)) {
    setWindowTitle(tr("Figures of Han & Hong 2008"));
    for (int number = 1; number <= han_hong::kFigures; ++number)
        m_figures->addItem(tr("Figure %1: %2").arg(number).arg(translated(han_hong::figureTitle(number))));
    m_figures->setAccessibleName(tr("Figure"));
    m_scenes->addItem(tr("the paper's bunny"));
    m_scenes->addItem(tr("the open scene"));
    m_scenes->setCurrentIndex(session.scene() ? kOpenScene : kPaperScene);
    m_scenes->setAccessibleName(tr("Scene"));
    for (int number = 1; number <= 3; ++number) m_cases->addItem(tr("case %1").arg(number));
    m_cases->setAccessibleName(tr("Case"));
    m_cases->setCurrentIndex(1);
    m_pose->setRange(1, kPoses);
    m_pose->setPrefix(tr("view "));
    m_pose->setAccessibleName(tr("View of the case"));
    m_shown->setAlignment(Qt::AlignCenter);
    m_words->setWordWrap(true);
    for (int kind = 0; kind < kFileKinds; ++kind)
        m_files->addAction(endingOf(File(kind)).toUpper() + QStringLiteral("…"), this, [this, kind] { askWhereTo(File(kind)); });
    m_save->setMenu(m_files);
    makeRows();
    for (QComboBox* box : {m_figures, m_scenes, m_cases})
        connect(box, &QComboBox::currentIndexChanged, this, &FiguresDialog::draw);
    connect(m_pose, &QSpinBox::valueChanged, this, &FiguresDialog::draw);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_exporter, &ResultExporter::written, &session, &Session::tellSaved);
    connect(m_exporter, &ResultExporter::failed, this,
            [this](const Message& message) { m_session.raise(Severity::Error, message); });
    resize(kFiguresSize.boundedTo(screen()->availableGeometry().size()));
    draw();
}

FiguresDialog::~FiguresDialog() { m_stop.request_stop(); }

void FiguresDialog::makeRows() {
    auto* top = new QHBoxLayout;
    top->addWidget(m_figures, 1);
    for (QWidget* each : std::initializer_list<QWidget*>{m_cases, m_pose, m_scenes}) top->addWidget(each);
    auto* area = new QScrollArea(this);
    area->setWidget(m_shown);
    area->setWidgetResizable(true);
    area->setAlignment(Qt::AlignHCenter);
    area->setAccessibleName(tr("The figure"));
    auto* bottom = new QHBoxLayout;
    bottom->addWidget(m_words, 1);
    for (QPushButton* button : {m_save, m_close}) {
        button->setAutoDefault(false);
        bottom->addWidget(button);
    }
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(top);
    layout->addWidget(area, 1);
    layout->addLayout(bottom);
}

void FiguresDialog::draw() {
    const int number = m_figures->currentIndex() + 1;
    const bool open = m_scenes->currentIndex() == kOpenScene;
    m_stop.request_stop();
    m_stop = std::stop_source();
    m_figure.reset();
    if (open && !m_session.scene()) {
        m_work.cancel();
        return refuse({QT_TRANSLATE_NOOP("core", "No scene is open."), {}});
    }
    han_hong::FigureRequest request = han_hong::figureRequest(number, open ? m_session.scene() : m_bunny);
    request.pose = size_t(m_pose->value() - 1);
    if (ofOneCase(number)) request.onlyCase = m_cases->currentIndex() + 1;
    const std::string specification = open && m_session.opened() ? m_session.opened()->specification : han_hong::kBunny;
    const QPointer<FiguresDialog> dialog(this);
    m_work.start(
        [dialog, request, open, specification, source = m_session.sceneSource(),
         stop = m_stop.get_token()](const std::stop_token&) mutable -> Background::Delivery {
            const Progress progress{nullptr, stop};
            if (!request.scene) request.scene = openScene(specification, source, progress).scene;
            // An OpenGL context belongs to the thread that made it.
            const HeadlessContext gl;
            const Letters letters(request.scale * kPlotLetters);
            PageLook look{pageStyle(letters, request.scale), [](const Words& words) { return translated(words).toStdString(); }};
            han_hong::Figure figure = han_hong::figure(request, look, progress);
            figure.data.scene = specification;
            figure.data.gl = gl.info();
            Page page;
            page.picture = imageOf(pagePicture(figure.page, letters));
            page.figure = std::make_shared<const han_hong::Figure>(std::move(figure));
            if (!open) page.bunny = request.scene;
            return [dialog, page] {
                if (dialog) dialog->showPage(page);
            };
        },
        [dialog](const std::exception& failure) -> Background::Delivery {
            const auto* error = dynamic_cast<const Error*>(&failure);
            const bool stopped = error != nullptr && error->kind() == ErrorKind::Interrupted;
            const Message message = stopped ? Message{}
                                    : error != nullptr
                                        ? error->message()
                                        : sentenceOf(failure, QT_TRANSLATE_NOOP("core", "The figure cannot be drawn: %1"));
            return [dialog, message] {
                if (dialog) dialog->refuse(message);
            };
        });
    showState();
}

void FiguresDialog::showPage(Page page) {
    if (page.bunny) m_bunny = std::move(page.bunny);
    m_figure = std::move(page.figure);
    m_picture = std::move(page.picture);
    QPixmap shown = QPixmap::fromImage(m_picture);
    shown.setDevicePixelRatio(m_picture.width() / kShownWidth);
    m_shown->setPixmap(shown);
    showState();
    emit drawn();
}

void FiguresDialog::refuse(const Message& failure) {
    m_picture = {};
    m_shown->clear();
    showState();
    m_words->setText(translated(failure));
    emit drawn();
}

void FiguresDialog::showState() {
    const int number = m_figures->currentIndex() + 1;
    m_cases->setEnabled(ofOneCase(number));
    m_pose->setEnabled(ofCases(number));
    m_save->setEnabled(m_figure != nullptr);
    m_words->setText(m_work.busy() && !m_figure ? tr("Drawing…")
                     : m_figure                 ? QString::fromStdString(m_figure->data.source)
                                                : QString());
}

void FiguresDialog::askWhereTo(File file) {
    const QString ending = endingOf(file);
    QFileDialog chooser(this, tr("Save the figure"), QStringLiteral("figure-%1").arg(m_figures->currentIndex() + 1),
                        QStringLiteral("%1 (*.%2)").arg(ending.toUpper(), ending));
    chooser.setAcceptMode(QFileDialog::AcceptSave);
    chooser.setDefaultSuffix(ending);
    if (chooser.exec() == QDialog::Accepted) saveTo(file, chooser.selectedFiles().front().toStdString());
}

void FiguresDialog::saveTo(File file, const std::filesystem::path& path) {
    if (!m_figure) return;
    m_exporter->write(path, [figure = m_figure, picture = m_picture, file] {
        if (file == File::Svg) return QByteArray::fromStdString(pageSvg(figure->page));
        if (file == File::Csv) return QByteArray::fromStdString(rowsCsv(figure->data));
        if (file == File::Json) return QByteArray::fromStdString(tablesJson({figure->data}));
        QByteArray bytes;
        QBuffer buffer(&bytes);
        QImage named = picture;
        named.setText(QStringLiteral("cullscope:figure"), QString::fromStdString(figure->data.source));
        named.setText(QStringLiteral("cullscope:scene"), QString::fromStdString(figure->data.scene));
        named.save(&buffer, "PNG");
        return bytes;
    });
}

}  // namespace cullscope::ui
