#pragma once

#include <QWidget>
#include <vector>

#include "ui/session/session.h"

namespace cullscope::ui {

/// The meaning of the colours in several views, in one row where there is room; empty where no view is coloured.
class LegendStrip : public QWidget {
    Q_OBJECT

public:
    explicit LegendStrip(Session& session, QWidget* parent = nullptr);

    /// Explains the colours of these views in letters of so many pixels; `bars`: and those of the bars below their pictures.
    void explain(const std::vector<int>& views, int letters, bool bars = false);
    [[nodiscard]] bool empty() const { return m_entries.empty(); }
    /// The words, for tests.
    [[nodiscard]] QStringList words() const;

private:
    struct Entry {
        QString words;
        std::optional<TriangleState> state;  ///< painted as in pictures
        QColor colour;                       ///< without a state

        bool operator==(const Entry&) const = default;
    };
    [[nodiscard]] std::vector<Entry> entriesOf(const std::vector<int>& views, bool bars) const;

    Session& m_session;
    std::vector<Entry> m_entries;
    int m_letters = 0;
};

}  // namespace cullscope::ui
