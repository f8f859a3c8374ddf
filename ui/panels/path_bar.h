#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QSlider>
#include <QToolButton>
#include <array>

#include "ui/session/path_desk.h"

namespace cullscope::ui {

/// The bar under the views while a camera path is recorded, made, played or stepped: whether it is being recorded and how many
/// poses it has, a slider over them, its name, and what can be changed of it. Hidden otherwise.
class PathBar : public QWidget {
    Q_OBJECT

public:
    explicit PathBar(PathDesk& desk, QWidget* parent = nullptr);

    [[nodiscard]] QSlider& slider() { return *m_slider; }
    [[nodiscard]] QLineEdit& name() { return *m_name; }
    /// "12 of 345", of a recording the number of poses so far.
    [[nodiscard]] QString placeText() const { return m_place->text(); }
    [[nodiscard]] QString chipText() const { return m_chip->text(); }

signals:
    void saveRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    enum Button { Back, Play, Forward, Begin, End, Smooth, Save, Close, ButtonCount };

    void layOut();
    void refresh();
    void retranslate();
    void press(Button button);

    PathDesk& m_desk;
    QLabel* m_chip;
    std::array<QToolButton*, ButtonCount> m_buttons{};
    QSlider* m_slider;
    QLabel* m_place;
    QLineEdit* m_name;
};

}  // namespace cullscope::ui
