#pragma once

#include <QButtonGroup>
#include <QCheckBox>
#include <QDialog>
#include <QLabel>
#include <QSlider>

#include "ui/session/session.h"

namespace cullscope::ui {

/// Sets the plane that cuts the pictures of all views, while one looks at them: on or off, its axis, where it lies, which side is
/// kept. Follows the session, so that undo, another session or another scene show in it.
class SectionDialog : public QDialog {
    Q_OBJECT

public:
    explicit SectionDialog(Session& session, QWidget* parent = nullptr);

    /// Shows it; where no plane cuts yet, the last one does.
    void begin();

private:
    void follow();
    void apply();
    void retranslate();
    void changeEvent(QEvent* event) override;

    Session& m_session;
    Section m_last;  ///< the plane that is set, or was when it was taken away
    QCheckBox* m_cuts;
    QButtonGroup* m_axes;  ///< ids are Section::Axis
    QLabel *m_axisLabel, *m_placeLabel, *m_note;
    QSlider* m_place;
    QCheckBox* m_flipped;
};

}  // namespace cullscope::ui
