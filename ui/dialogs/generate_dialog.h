#pragma once

#include <QDialog>
#include <QLineEdit>
#include <vector>

#include "core/scene/scene_source.h"

namespace cullscope::ui {

/// The parameters of one scene generator; what is entered becomes a scene specification.
class GenerateDialog : public QDialog {
    Q_OBJECT

public:
    explicit GenerateDialog(const GeneratorInfo& generator, QWidget* parent = nullptr);

    /// "sphere:triangles=1e6"; parameters left at their defaults are left out.
    [[nodiscard]] QString specification() const;

private:
    GeneratorInfo m_generator;
    std::vector<QLineEdit*> m_fields;
};

}  // namespace cullscope::ui
