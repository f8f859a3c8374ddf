#include "ui/panels/parameter_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/look/wheel_guard.h"
#include "ui/panels/number_field.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr int kNarrowPage = 232;  // pixels that a row has in the panel beside the views
constexpr int kKeyColumn = 64;    // fields stand below each other, but for those of longer keys

bool sameDeclarations(const ParameterSet& a, const ParameterSet& b) {
    const auto key = [](const ParameterDeclaration& x, const ParameterDeclaration& y) {
        return x.key == y.key && x.type == y.type && x.description == y.description && x.minimum == y.minimum &&
               x.maximum == y.maximum && x.logarithmicFrom == y.logarithmicFrom;
    };
    return std::equal(a.declarations().begin(), a.declarations().end(), b.declarations().begin(), b.declarations().end(), key);
}

/// "-p rows=180", with the default value.
QString commandLineText(const ParameterDeclaration& declaration) {
    return QStringLiteral("-p %1=%2")
        .arg(QString::fromStdString(declaration.key), QString::fromStdString(toText(declaration.defaultValue)));
}

}  // namespace

ParameterForm::ParameterForm(QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
}

void ParameterForm::setParameters(const ParameterSet& parameters) {
    const bool same = m_fields && sameDeclarations(parameters, m_parameters);
    if (same && parameters == m_parameters) return;
    m_parameters = parameters;
    rebuild();
}

void ParameterForm::rebuild() {
    if (m_fields) {
        layout()->removeWidget(m_fields);
        m_fields->hide();
        m_fields->deleteLater();
    }
    m_stops.clear();
    m_fields = new QWidget(this);
    // A QFormLayout states the height that wrapped sentences had at its last width, and they are cut at the next one.
    auto* form = new QVBoxLayout(m_fields);
    form->setContentsMargins(0, 0, 0, 0);
    std::vector<QLabel*> keys;
    int column = 0;
    for (const ParameterDeclaration& declaration : m_parameters.declarations()) {
        QWidget* editor = field(declaration);
        const QString sentence = translated(declaration.description);
        // The sentence in the user's language comes first; the key, as on the command line, stands in grey beside the field.
        auto* explanation = new QLabel(sentence);
        explanation->setWordWrap(true);
        explanation->setBuddy(editor);
        form->addWidget(explanation);
        auto* key = new QLabel(QString::fromStdString(declaration.key));
        key->setEnabled(false);
        key->setToolTip(tr("As on the command line: %1").arg(commandLineText(declaration)));
        editor->setToolTip(sentence);
        // A row has both where a narrow page has room for them; else the field comes below its key.
        const int wide = key->sizeHint().width();
        const bool beside = wide + editor->minimumSizeHint().width() + form->spacing() <= kNarrowPage;
        auto* row = new QBoxLayout(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
        row->addWidget(key);
        row->addWidget(editor, 1);
        form->addLayout(row);
        if (beside) {
            keys.push_back(key);
            column = std::max(column, std::min(wide, kKeyColumn));
        }
        if (auto* choices = qobject_cast<QComboBox*>(editor)) form->addWidget(meaningOfChoice(*choices));
    }
    for (QLabel* key : keys) key->setMinimumWidth(column);
    if (m_parameters.declarations().empty()) {
        auto* none = new QLabel(tr("This strategy has no parameters."));
        none->setWordWrap(true);
        form->addWidget(none);
    }
    layout()->addWidget(m_fields);
    orderTabs();
}

QLabel* ParameterForm::meaningOfChoice(QComboBox& box) {
    auto* meaning = new QLabel;
    meaning->setWordWrap(true);
    const auto say = [&box, meaning] { meaning->setText(box.currentData(Qt::ToolTipRole).toString()); };
    QObject::connect(&box, &QComboBox::currentIndexChanged, meaning, say);
    say();
    return meaning;
}

void ParameterForm::setTabPredecessor(QWidget* widget) {
    m_tabPredecessor = widget;
    orderTabs();
}

void ParameterForm::orderTabs() {
    QWidget* last = m_tabPredecessor;
    for (QWidget* stop : m_stops) {
        if (last) setTabOrder(last, stop);
        last = stop;
    }
}

QWidget* ParameterForm::field(const ParameterDeclaration& declaration) {
    QWidget* editor = nullptr;
    switch (declaration.type) {
        case ParameterType::Boolean:
            editor = checkBox(declaration);
            break;
        case ParameterType::Integer:
        case ParameterType::Real:
            editor = number(declaration);
            break;
        case ParameterType::Choice:
            editor = list(declaration);
            break;
        case ParameterType::File:
            editor = fileName(declaration);
            break;
    }
    editor->setObjectName(QString::fromStdString(declaration.key));
    editor->setAccessibleName(QString::fromStdString(declaration.key));
    editor->setAccessibleDescription(translated(declaration.description));
    return editor;
}

QWidget* ParameterForm::checkBox(const ParameterDeclaration& declaration) {
    auto* box = new QCheckBox;
    m_stops.push_back(box);
    box->setChecked(m_parameters.boolean(declaration.key));
    connect(box, &QCheckBox::toggled, this, [this, key = declaration.key](bool on) { take(key, on); });
    return box;
}

QWidget* ParameterForm::number(const ParameterDeclaration& declaration) {
    auto* field = new NumberField(declaration, m_parameters.value(declaration.key));
    m_stops.insert(m_stops.end(), {&field->slider(), &field->number()});
    connect(field, &NumberField::changed, this, [this, key = declaration.key](const ParameterValue& value) { take(key, value); });
    return field;
}

QWidget* ParameterForm::list(const ParameterDeclaration& declaration) {
    auto* box = new QComboBox;
    m_stops.push_back(box);
    leaveWheelUnlessFocused(*box);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(8);
    for (const ParameterDeclaration::Choice& choice : declaration.choices) {
        const QString id = QString::fromStdString(choice.id);
        box->addItem(id, id);
        box->setItemData(box->count() - 1, translated(choice.description), Qt::ToolTipRole);
    }
    box->setCurrentIndex(box->findData(QString::fromStdString(m_parameters.choice(declaration.key))));
    connect(box, &QComboBox::currentIndexChanged, this,
            [this, box, key = declaration.key] { take(key, box->currentData().toString().toStdString()); });
    return box;
}

QWidget* ParameterForm::fileName(const ParameterDeclaration& declaration) {
    auto* both = new QWidget;
    auto* row = new QHBoxLayout(both);
    row->setContentsMargins(0, 0, 0, 0);
    auto* name = new QLineEdit(QString::fromStdString(m_parameters.choice(declaration.key)));
    name->setPlaceholderText(tr("no file"));
    name->setAccessibleName(QString::fromStdString(declaration.key));
    auto* choose = new QToolButton;
    choose->setText(QStringLiteral("…"));
    choose->setToolTip(tr("Choose a file"));
    choose->setAccessibleName(tr("Choose a file"));
    row->addWidget(name, 1);
    row->addWidget(choose);
    m_stops.insert(m_stops.end(), {name, choose});
    connect(name, &QLineEdit::editingFinished, this,
            [this, name, key = declaration.key] { take(key, name->text().toStdString()); });
    connect(choose, &QToolButton::clicked, this, [this, name] {
        const QString chosen = QFileDialog::getOpenFileName(this, tr("Choose a file"), name->text());
        if (chosen.isEmpty()) return;
        name->setText(chosen);
        emit name->editingFinished();
    });
    return both;
}

void ParameterForm::take(const std::string& key, const ParameterValue& value) {
    if (m_parameters.value(key) == value) return;
    m_parameters.set(key, value);
    emit edited(m_parameters);
}

void ParameterForm::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange && m_fields) rebuild();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
