#pragma once

#include <QDialog>
#include <QLineEdit>
#include <vector>

#include "core/scene/scene_source.h"

namespace cullscope::ui {

/// Asks for the parameters of one scene generator and gives them as a scene specification.
class GenerateDialog : public QDialog {
    Q_OBJECT

public:
    explicit GenerateDialog(const GeneratorInfo& generator, QWidget* parent = nullptr);

    /// The specification, such as "sphere:triangles=1e6"; omits parameters that have their default values.
    [[nodiscard]] QString specification() const;

private:
    GeneratorInfo m_generator;
    std::vector<QLineEdit*> m_fields;
};

}  // namespace cullscope::ui
