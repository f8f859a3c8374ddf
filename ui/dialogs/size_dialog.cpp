#include "ui/dialogs/size_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>

namespace cullscope::ui {

namespace {

constexpr int kSmallest = 16;
constexpr int kLargest = 8192;

}  // namespace

SizeDialog::SizeDialog(const Viewport& size, QWidget* parent)
    : QDialog(parent), m_width(new QSpinBox(this)), m_height(new QSpinBox(this)) {
    setWindowTitle(tr("Picture size"));
    for (QSpinBox* box : {m_width, m_height}) {
        box->setRange(kSmallest, kLargest);
        box->setSuffix(tr(" px"));
    }
    m_width->setValue(size.width);
    m_height->setValue(size.height);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* form = new QFormLayout(this);
    form->addRow(tr("Width"), m_width);
    form->addRow(tr("Height"), m_height);
    form->addRow(buttons);
}

}  // namespace cullscope::ui
