#pragma once

#include <QDialog>

#include "core/gpu/context.h"

namespace cullscope::ui {

/// What the program is, its version, the OpenGL it runs on, and the licences of what it is made of.
class AboutDialog : public QDialog {
    Q_OBJECT

public:
    explicit AboutDialog(const GlInfo& gl, QWidget* parent = nullptr);
};

}  // namespace cullscope::ui
