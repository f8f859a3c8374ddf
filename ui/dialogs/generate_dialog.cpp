#include "ui/dialogs/generate_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QMessageBox>
#include <QVBoxLayout>

#include "core/base/error.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr double kMegabyte = 1 << 20;

/// "about 1,000,000 triangles in 400 objects, some 40 MB of memory", as far as it is known.
QString sizeOf(const SceneEstimate& estimate) {
    const auto count = [](double number) { return countText(uint64_t(number + 0.5)); };
    const QString memory = count(std::max(1.0, estimate.bytes / kMegabyte));
    if (!estimate.triangles)
        return GenerateDialog::tr("objects: about %1; triangles: as the mesh has; memory beside the mesh: about %2 MB")
            .arg(count(estimate.objects), memory);
    return GenerateDialog::tr("triangles: about %1; objects: about %2; memory: about %3 MB")
        .arg(count(*estimate.triangles), count(estimate.objects), memory);
}

}  // namespace

GenerateDialog::GenerateDialog(const GeneratorInfo& generator, QWidget* parent)
    : QDialog(parent), m_generator(generator), m_size(new QLabel(this)) {
    setWindowTitle(tr("Generate a scene: %1").arg(QString::fromStdString(generator.id)));
    auto* layout = new QVBoxLayout(this);
    auto* description = new QLabel(translated(generator.description), this);
    description->setWordWrap(true);
    layout->addWidget(description);
    auto* form = new QFormLayout;
    for (const GeneratorParameter& parameter : generator.parameters) {
        auto* field = new QLineEdit(QString::fromStdString(parameter.defaultValue), this);
        const QString sentence = translated(parameter.description);
        field->setMinimumWidth(260);
        field->setToolTip(sentence);
        field->setAccessibleName(QString::fromStdString(parameter.key));
        field->setAccessibleDescription(sentence);
        connect(field, &QLineEdit::textChanged, this, &GenerateDialog::showSize);
        // The sentence in the user's language comes first; the key, as on the command line, stands in grey beside the field.
        auto* explanation = new QLabel(sentence, this);
        explanation->setWordWrap(true);
        explanation->setBuddy(field);
        form->addRow(explanation);
        auto* key = new QLabel(QString::fromStdString(parameter.key), this);
        key->setEnabled(false);
        form->addRow(key, field);
        m_fields.push_back(field);
    }
    layout->addLayout(form);
    m_size->setWordWrap(true);
    layout->addWidget(m_size);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_generate = buttons->button(QDialogButtonBox::Ok);
    m_generate->setText(tr("Generate"));
    connect(buttons, &QDialogButtonBox::accepted, this, &GenerateDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    showSize();
}

void GenerateDialog::showSize() {
    m_large = false;
    m_generate->setEnabled(true);
    try {
        const std::optional<SceneEstimate> estimate = estimateScene(specification().toStdString());
        m_size->setText(estimate ? tr("The scene will have: %1.", "sizes").arg(sizeOf(*estimate)) : QString());
        m_large = estimate && estimate->large();
    } catch (const Error& error) {
        m_size->setText(translated(error.message()));
        m_generate->setEnabled(false);
    }
}

void GenerateDialog::accept() {
    if (m_large) {
        QMessageBox question(QMessageBox::Warning, windowTitle(), m_size->text(), QMessageBox::Cancel, this);
        question.setInformativeText(
            tr("So large a scene takes time and memory. Above five million triangles nothing is measured unasked."));
        QPushButton* generate = question.addButton(tr("Generate it"), QMessageBox::AcceptRole);
        question.setDefaultButton(QMessageBox::Cancel);
        question.exec();
        if (question.clickedButton() != generate) return;
    }
    QDialog::accept();
}

QString GenerateDialog::specification() const {
    QStringList given;
    for (size_t i = 0; i < m_fields.size(); ++i) {
        const GeneratorParameter& parameter = m_generator.parameters[i];
        const QString value = m_fields[i]->text().trimmed();
        if (!value.isEmpty() && value != QString::fromStdString(parameter.defaultValue))
            given << QString::fromStdString(parameter.key) + QLatin1Char('=') + value;
    }
    const QString id = QString::fromStdString(m_generator.id);
    return given.isEmpty() ? id : id + QLatin1Char(':') + given.join(QLatin1Char(','));
}

}  // namespace cullscope::ui
