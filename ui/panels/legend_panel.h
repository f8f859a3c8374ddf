#pragma once

#include <QLabel>
#include <QWidget>
#include <array>

#include "core/visibility/triangle_states.h"
#include "ui/panels/plane_legend.h"
#include "ui/session/session.h"

class QGridLayout;

namespace cullscope::ui {

/// Explains the colours and marks of the views, with the active view's counts, and suggests one next action.
class LegendPanel : public QWidget {
    Q_OBJECT

public:
    explicit LegendPanel(Session& session, QWidget* parent = nullptr);

    /// Shows only the legend, in one column with room for large letters.
    void showToAudience();
    /// The suggested next action; changes with the user's progress.
    [[nodiscard]] QString nextAction() const;
    /// What the line over each picture says; of several views how fast they are beside each other, and whether their speeds are
    /// against other baselines, because they draw other sides.
    [[nodiscard]] QString figuresWords() const;
    /// Suggests the first action again.
    void startAnew();
    /// What lines of a strategy's shows mean in the active view; hidden where it has none.
    [[nodiscard]] const QWidget& meanings() const { return *m_meanings; }

signals:
    /// The user follows the suggestion to begin with the first lesson.
    void lessonRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    enum class Progress { Lesson, Turn, Look, Pick, Choose, Done };

    QWidget* makeStates();
    void placeStates(int rows);
    QWidget* makeMeanings();
    QWidget* makePromises();
    void wire();
    void refresh();
    void showCounts();
    void showPlanes();
    void showMeanings();
    void showUndecided();
    void advance(Progress to);
    [[nodiscard]] QString turnAction() const;

    Session& m_session;
    Progress m_progress = Progress::Lesson;
    int m_cameraMoves = 0;
    QLabel* m_figures;
    QLabel* m_heading;  ///< whose triangles the colours count
    QWidget* m_states;
    QGridLayout* m_grid = nullptr;
    std::array<QWidget*, kTriangleStateCount> m_swatches{};
    std::array<QLabel*, kTriangleStateCount> m_words{};
    std::array<QLabel*, kTriangleStateCount> m_counts{};
    QWidget* m_meanings = nullptr;
    QStringList m_meaningWords;
    PlaneLegend* m_planes;
    QList<QLabel*> m_promises;
    QLabel* m_next;
};

}  // namespace cullscope::ui
