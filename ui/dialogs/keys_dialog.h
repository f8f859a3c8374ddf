#pragma once

#include <QDialog>

namespace cullscope::ui {

/// Lists all mouse moves and keys on one page.
class KeysDialog : public QDialog {
    Q_OBJECT

public:
    explicit KeysDialog(QWidget* parent = nullptr);
};

}  // namespace cullscope::ui
