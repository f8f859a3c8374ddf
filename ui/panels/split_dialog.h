#pragma once

#include <QDialog>
#include <QRadioButton>
#include <QSpinBox>

namespace cullscope::ui {

/// GlRequirement how the object of a scene is to be split, and gives the result as a scene specification.
class SplitDialog : public QDialog {
    Q_OBJECT

public:
    /// `specification` and `triangles`: those of the scene to split.
    SplitDialog(const QString& specification, uint64_t triangles, QWidget* parent = nullptr);

    [[nodiscard]] QRadioButton& components() { return *m_components; }
    [[nodiscard]] QRadioButton& clusters() { return *m_clusters; }
    [[nodiscard]] QSpinBox& triangles() { return *m_triangles; }
    /// The specification of the split scene, such as "split:by=clusters,triangles=5000,mesh=bunny".
    [[nodiscard]] QString specification() const;

private:
    QString m_mesh;
    QRadioButton* m_components;
    QRadioButton* m_clusters;
    QSpinBox* m_triangles;
};

}  // namespace cullscope::ui
