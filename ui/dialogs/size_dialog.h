#pragma once

#include <QDialog>
#include <QSpinBox>

#include "core/scene/camera.h"

namespace cullscope::ui {

/// Asks for a picture's width and height.
class SizeDialog : public QDialog {
    Q_OBJECT

public:
    explicit SizeDialog(const Viewport& size, QWidget* parent = nullptr);

    [[nodiscard]] Viewport size() const { return {m_width->value(), m_height->value()}; }

private:
    QSpinBox* m_width;
    QSpinBox* m_height;
};

}  // namespace cullscope::ui
