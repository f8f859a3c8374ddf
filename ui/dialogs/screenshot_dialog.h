#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

#include "ui/screenshots/screenshot_plan.h"
#include "ui/screenshots/screenshot_settings.h"

namespace cullscope::ui {

/// Asks for the options of a screenshot and for its file. Shows the file's name, or why it cannot be written.
class ScreenshotDialog : public QDialog {
    Q_OBJECT

public:
    ScreenshotDialog(Session& session, ExtrasOf extras, const ScreenshotSettings& settings, QWidget* parent = nullptr);

    [[nodiscard]] ScreenshotSettings settings() const;
    /// The line below the options: the name of the file, or why it cannot be written.
    [[nodiscard]] QString verdict() const { return m_verdict->text(); }
    [[nodiscard]] QPushButton& saveButton() { return *m_save; }

private:
    void makeWidgets();
    void layOut();
    void choose(const ScreenshotSettings& settings);
    void refresh();
    void browse();
    [[nodiscard]] std::optional<Viewport> size() const;

    Session& m_session;
    ExtrasOf m_extras;
    QComboBox *m_what, *m_size, *m_background;
    QSpinBox *m_width, *m_height;
    QCheckBox *m_overlays, *m_legend, *m_caption;
    QLineEdit *m_captionText, *m_folder, *m_pattern;
    QPushButton *m_browse, *m_save;
    QLabel* m_verdict;
};

}  // namespace cullscope::ui
