#pragma once

#include <QImage>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <vector>

#include "ui/session/lesson_player.h"
#include "ui/session/snapshot_reader.h"
#include "ui/text/language.h"
#include "ui/views/view_grid.h"

namespace cullscope::ui {

/// Makes a handout of a lesson: goes through all steps, waits for each one's pictures and figures, and writes them with the
/// sentences and notes as one PDF or HTML file, as a whole or not at all. Then the step that was in hand is shown again.
class LessonHandout : public QObject {
    Q_OBJECT

public:
    LessonHandout(Session& session, LessonPlayer& lessons, ViewGrid& views, const Language& language, QObject* parent = nullptr);

    /// The panel beside one view, or beside a view and its observer, whose maps and listings the sentences speak of; and the
    /// reader that says when it shows the step.
    void setStructure(QWidget& panel, const SnapshotReader& reader) {
        m_structure = &panel;
        m_reader = &reader;
    }
    /// Throws Error(Usage) unless the file's name ends in .pdf or .html.
    static void requireFormat(const QString& file);
    /// Only while a lesson is on. What fails is reported by `failed`.
    void make(const QString& file);
    [[nodiscard]] bool busy() const { return m_poll.isActive(); }
    void cancel();

signals:
    /// `step` of `count` is being shown.
    void progressed(int step, int count);
    void done(const QString& file);
    void failed(const cullscope::Message& message);

private:
    struct Page {
        QString sentence, notes;
        QStringList figures;
        QImage picture;
    };

    void look();
    [[nodiscard]] bool settled() const;
    /// Whether the panel is seen, and the step has no more views than two.
    [[nodiscard]] bool showsStructure() const;
    [[nodiscard]] Page page() const;
    void end();
    /// `embedded`: pictures are part of the text; else it names them.
    [[nodiscard]] QString html(bool embedded) const;
    void write() const;

    Session& m_session;
    LessonPlayer& m_lessons;
    ViewGrid& m_views;
    const Language& m_language;
    QWidget* m_structure = nullptr;
    const SnapshotReader* m_reader = nullptr;
    QString m_file;
    int m_before = 0;  ///< the step that was in hand
    std::vector<Page> m_pages;
    QTimer m_poll;
};

}  // namespace cullscope::ui
