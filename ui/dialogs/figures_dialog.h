#pragma once

#include <QComboBox>
#include <QDialog>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSpinBox>
#include <filesystem>
#include <memory>

#include "core/experiments/han_hong_figures.h"
#include "ui/jobs/background.h"
#include "ui/plots/result_exporter.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// The figures of Han & Hong 2008 as pages, as `cullbench figure` draws them, of the open scene or of the paper's bunny. A page
/// is drawn on a thread and an OpenGL context of its own at once when it is chosen, and saved as a picture or as its numbers.
class FiguresDialog : public QDialog {
    Q_OBJECT

public:
    enum class File { Png, Svg, Csv, Json };
    static constexpr int kFileKinds = 4;

    explicit FiguresDialog(Session& session, QWidget* parent = nullptr);
    ~FiguresDialog() override;

    [[nodiscard]] QComboBox& figures() { return *m_figures; }
    [[nodiscard]] QComboBox& scenes() { return *m_scenes; }
    [[nodiscard]] QComboBox& cases() { return *m_cases; }
    [[nodiscard]] QSpinBox& pose() { return *m_pose; }
    [[nodiscard]] QPushButton& saveButton() { return *m_save; }
    [[nodiscard]] bool drawing() const { return m_work.busy(); }
    /// The newest page; null while there is none.
    [[nodiscard]] const QImage& picture() const { return m_picture; }
    /// Writes the shown page in the background. Reports success or failure through the session.
    void saveTo(File file, const std::filesystem::path& path);

signals:
    /// A page was drawn, or cannot be.
    void drawn();

private:
    struct Page;

    void makeRows();
    void draw();
    void showPage(Page page);
    void refuse(const Message& failure);
    void showState();
    void askWhereTo(File file);

    Session& m_session;
    ResultExporter* m_exporter;
    QComboBox *m_figures, *m_scenes, *m_cases;
    QSpinBox* m_pose;
    QLabel *m_shown, *m_words;
    QPushButton *m_save, *m_close;
    QMenu* m_files;
    ScenePointer m_bunny;  ///< the paper's, once it was opened
    std::shared_ptr<const han_hong::Figure> m_figure;
    QImage m_picture;
    std::stop_source m_stop;
    Background m_work;
};

}  // namespace cullscope::ui
