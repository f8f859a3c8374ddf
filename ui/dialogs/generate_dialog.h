#pragma once

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <vector>

#include "core/scene/scene_source.h"

namespace cullscope::ui {

/// Asks for the parameters of one scene generator and gives them as a scene specification. Says how large the scene will be while
/// they are typed, and asks once more before a large one is made (SceneEstimate::large).
class GenerateDialog : public QDialog {
    Q_OBJECT

public:
    explicit GenerateDialog(const GeneratorInfo& generator, QWidget* parent = nullptr);

    /// The specification, such as "sphere:triangles=1e6"; omits parameters that have their default values.
    [[nodiscard]] QString specification() const;
    /// How large the scene will be, or what is wrong with a parameter.
    [[nodiscard]] QString sizeSentence() const { return m_size->text(); }
    /// Not while a parameter's value is wrong.
    [[nodiscard]] bool canGenerate() const { return m_generate->isEnabled(); }

public slots:
    void accept() override;

private:
    void showSize();

    GeneratorInfo m_generator;
    std::vector<QLineEdit*> m_fields;
    QLabel* m_size;
    QPushButton* m_generate = nullptr;
    bool m_large = false;
};

}  // namespace cullscope::ui
