#pragma once

#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QSlider>
#include <QToolButton>
#include <array>

#include "ui/session/stepper.h"

namespace cullscope::ui {

/// The bar under the views while one of them is stepped: buttons, a slider over all steps, speed, breakpoints, and the sentence
/// of the entry in hand. Hidden while none is stepped.
class StepBar : public QWidget {
    Q_OBJECT

public:
    StepBar(Session& session, Stepper& stepper, QWidget* parent = nullptr);

    [[nodiscard]] QSlider& slider() { return *m_slider; }
    [[nodiscard]] QToolButton& playButton() { return *m_buttons[2]; }
    [[nodiscard]] QMenu& breakpoints() { return *m_breakpoints; }
    /// "12 of 345", with the size of the steps where they are coarser than single entries, and with what the frame's log itself
    /// leaves out (FrameLog::coarser), the first of it.
    [[nodiscard]] QString placeText() const;
    [[nodiscard]] QString sentence() const { return m_sentence->text(); }

protected:
    void changeEvent(QEvent* event) override;

private:
    void layOut();
    /// About the size of the steps; needs a place.
    [[nodiscard]] QString placeTip() const;
    void refresh();
    void retranslate();
    /// Lists the kinds that the frame's log contains.
    void fillBreakpoints();

    Session& m_session;
    Stepper& m_stepper;
    std::array<QToolButton*, 5> m_buttons{};  ///< first, back, play, forward, last
    QSlider* m_slider;
    QLabel* m_place;
    QLabel* m_speedName;
    QDoubleSpinBox* m_speed;
    QToolButton* m_breakpointsButton;
    QMenu* m_breakpoints;
    QToolButton* m_close;
    QLabel* m_sentence;
};

}  // namespace cullscope::ui
