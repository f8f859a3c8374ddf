#pragma once

#include <QObject>
#include <QStringList>

#include "ui/session/lesson.h"

namespace cullscope::ui {

/// Walks through a lesson: opens a step's scene where it is not open yet, and shows in the session what the step says. Never
/// waits for measuring.
class LessonPlayer : public QObject {
    Q_OBJECT

public:
    explicit LessonPlayer(Session& session, QObject* parent = nullptr);

    /// The names of the program's own lessons, in their order.
    [[nodiscard]] static QStringList known();
    /// The title of one of them.
    [[nodiscard]] static LessonText titleOf(const QString& name);
    /// Reads one of them by its name, or a lesson's file. Throws Error(Usage) that lists the names where it is neither,
    /// Error(Input) naming file and line.
    [[nodiscard]] static Lesson read(const QString& nameOrFile);
    /// The step, from 0, of "NAME:STEP", where steps are counted from 1; `nameOrFile` keeps the name. Without a step 0.
    [[nodiscard]] static int cutStep(QString& nameOrFile);

    /// Begins with a step of it, or raises in the session why it cannot.
    void begin(const QString& nameOrFile, int step = 0);
    void begin(const Lesson& lesson, int step = 0);
    /// What is shown stays.
    void leave();
    [[nodiscard]] bool active() const { return !m_lesson.steps.empty(); }
    [[nodiscard]] const Lesson& lesson() const { return m_lesson; }
    /// The lesson's file; empty: it is none, or one of the program's own.
    [[nodiscard]] const QString& file() const { return m_file; }
    [[nodiscard]] int step() const { return m_step; }
    [[nodiscard]] int count() const { return int(m_lesson.steps.size()); }
    /// The step in hand; only while a lesson is on.
    [[nodiscard]] const LessonStep& current() const { return m_lesson.steps[size_t(m_step)]; }
    [[nodiscard]] bool opening() const { return m_awaited.has_value(); }

    /// Goes to a step; beyond the first or the last one nothing happens. The present one is shown anew.
    void go(int step);
    void forward() { go(m_step + 1); }
    void back() { go(m_step - 1); }

    /// Shows a step of no lesson, such as what the window begins with.
    void show(const LessonStep& step);
    /// What a start shows, in so many views with pictures of this size (none: they fit the window).
    [[nodiscard]] static LessonStep firstStep(int viewCount, const std::optional<Viewport>& size = kUsualPictureSize);

signals:
    /// Another step, or lesson, or none.
    void changed();
    /// The session shows the step.
    void shown(const cullscope::ui::LessonStep& step);

private:
    void apply(const LessonStep& step);

    Session& m_session;
    Lesson m_lesson;
    QString m_file;
    int m_step = 0;
    std::optional<LessonStep> m_awaited;  ///< the step whose scene is being opened
    bool m_starting = false;              ///< this object itself is starting a loading
};

}  // namespace cullscope::ui
