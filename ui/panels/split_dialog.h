#pragma once

#include <QDialog>
#include <QRadioButton>
#include <QSpinBox>

namespace cullscope::ui {

/// GlRequirement into what a scene's object is to be split; the answer is a scene specification.
class SplitDialog : public QDialog {
    Q_OBJECT

public:
    /// `specification`: of the scene that is split; `triangles`: how many it has.
    SplitDialog(const QString& specification, uint64_t triangles, QWidget* parent = nullptr);

    [[nodiscard]] QRadioButton& components() { return *m_components; }
    [[nodiscard]] QRadioButton& clusters() { return *m_clusters; }
    [[nodiscard]] QSpinBox& triangles() { return *m_triangles; }
    /// "split:by=clusters,triangles=5000,mesh=bunny".
    [[nodiscard]] QString specification() const;

private:
    QString m_mesh;
    QRadioButton* m_components;
    QRadioButton* m_clusters;
    QSpinBox* m_triangles;
};

}  // namespace cullscope::ui
