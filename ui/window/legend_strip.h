#pragma once

#include <QWidget>
#include <vector>

#include "ui/plots/map_symbols.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// The meaning of the colours in several views, in one row where there is room; empty where no view is coloured.
class LegendStrip : public QWidget {
    Q_OBJECT

public:
    explicit LegendStrip(Session& session, QWidget* parent = nullptr);

    /// What is explained besides the pictures of views.
    struct More {
        bool bars = false;                      ///< the bars below pictures
        std::vector<TriangleState> states{};    ///< of a map's cells or a curve's areas
        std::vector<MapLegend::Entry> lines{};  ///< of maps
        QStringList scales{};                   ///< what the tones of maps mean
    };
    /// Explains the colours of these views in letters of so many pixels, and more. Returns whether anything is new.
    bool explain(const std::vector<int>& views, int letters, const More& more);
    /// Whether explain() would change the strip.
    [[nodiscard]] bool outdated(const std::vector<int>& views, const More& more) const {
        return entriesOf(views, more) != m_entries;
    }
    [[nodiscard]] bool empty() const { return m_entries.empty(); }
    /// The words, for tests.
    [[nodiscard]] QStringList words() const;

private:
    struct Entry {
        QString words;
        std::optional<TriangleState> state;  ///< painted as in pictures
        QColor colour{};                     ///< without a state or symbol
        std::optional<MapSymbol> symbol{};   ///< painted as on maps
        bool inHand = false;                 ///< painted as what a step has in hand
        bool line = false;                   ///< painted as a line in the colour
        bool tones = false;                  ///< painted as the tones of a map

        bool operator==(const Entry&) const = default;
    };
    [[nodiscard]] std::vector<Entry> entriesOf(const std::vector<int>& views, const More& more) const;

    Session& m_session;
    std::vector<Entry> m_entries;
    int m_letters = 0;
};

}  // namespace cullscope::ui
