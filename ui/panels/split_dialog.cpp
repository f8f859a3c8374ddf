#include "ui/panels/split_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <limits>

#include "core/mesh/split.h"
#include "core/scene/split_scene.h"

namespace cullscope::ui {

SplitDialog::SplitDialog(const QString& specification, uint64_t triangles, QWidget* parent)
    : QDialog(parent),
      m_mesh(specification),
      m_components(new QRadioButton(this)),
      m_clusters(new QRadioButton(this)),
      m_triangles(new QSpinBox(this)) {
    setWindowTitle(tr("Split the object"));
    auto* text =
        new QLabel(tr("Strategies that decide by objects have nothing to leave out in a scene of one object. What is drawn "
                      "stays the same."),
                   this);
    text->setWordWrap(true);
    m_components->setText(tr("Components: what hangs together becomes an object"));
    m_clusters->setText(tr("Clusters: compact pieces with at most this many triangles:"));
    m_clusters->setChecked(true);
    const auto most = int(std::min<uint64_t>(std::max<uint64_t>(triangles, 1), uint64_t(std::numeric_limits<int>::max())));
    // The minimum keeps the number of parts within its limit.
    m_triangles->setRange(std::max(1, int((triangles + kMostParts - 1) / kMostParts)), most);
    m_triangles->setValue(int(SplitRule().triangles));
    m_triangles->setGroupSeparatorShown(true);
    m_triangles->setAccessibleName(tr("Triangles a cluster"));
    m_triangles->setMinimumWidth(120);
    connect(m_clusters, &QRadioButton::toggled, m_triangles, &QWidget::setEnabled);
    auto* number = new QHBoxLayout;
    number->addSpacing(24);
    number->addWidget(m_triangles);
    number->addStretch();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Split"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    for (QWidget* row : std::initializer_list<QWidget*>{text, m_components, m_clusters}) layout->addWidget(row);
    layout->addLayout(number);
    layout->addWidget(buttons);
}

QString SplitDialog::specification() const {
    // The mesh is the last parameter: all text after "mesh=" belongs to its specification.
    const QString by = m_components->isChecked() ? QStringLiteral("by=components")
                                                 : QStringLiteral("by=clusters,triangles=%1").arg(m_triangles->value());
    return QStringLiteral("split:") + by + QStringLiteral(",mesh=") + m_mesh;
}

}  // namespace cullscope::ui
