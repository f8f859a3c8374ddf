#include "ui/dialogs/generate_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/text/translated.h"

namespace cullscope::ui {

GenerateDialog::GenerateDialog(const GeneratorInfo& generator, QWidget* parent) : QDialog(parent), m_generator(generator) {
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
        form->addRow(QString::fromStdString(parameter.key), field);
        auto* explanation = new QLabel(sentence, this);
        explanation->setWordWrap(true);
        explanation->setEnabled(false);
        form->addRow(QString(), explanation);
        m_fields.push_back(field);
    }
    layout->addLayout(form);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Generate"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
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
