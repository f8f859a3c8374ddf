#pragma once

#include <QDialog>

#include "core/gpu/context.h"

namespace cullscope::ui {

/// Shows what the program is, its version, the OpenGL that it runs on, and the licences of the parts that it is made of.
class AboutDialog : public QDialog {
    Q_OBJECT

public:
    explicit AboutDialog(const GlInfo& gl, QWidget* parent = nullptr);
};

}  // namespace cullscope::ui
