#include "ui/plots/map_words.h"

#include <QCoreApplication>

#include "ui/text/terms.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

class MapWords {
    Q_DECLARE_TR_FUNCTIONS(cullscope::ui::MapWords)
};

/// The state of the triangles that the cell owns, or a text that it owns none.
QString stateOfCell(const ShownMap& shown, const TriangleStates* truth, uint32_t cell) {
    const uint8_t tone = stateTone(shown, truth, cell);
    for (size_t state = 0; tone > 0 && state < kTriangleStateCount; ++state)
        if (CellTones::toneOf(TriangleState(state)) == tone) return stateWords(TriangleState(state), truth != nullptr);
    return MapWords::tr("owns no triangle");
}

}  // namespace

QString cellWords(const ShownMap& shown, const TriangleStates* truth, uint32_t cell) {
    QStringList lines = translatedLines(shown.source().words(cell));
    lines << stateOfCell(shown, truth, cell);
    return lines.join(QLatin1Char('\n'));
}

QString stateWords(TriangleState state, bool truthKnown) {
    if (state == TriangleState::Visible && !truthKnown) return MapWords::tr("drawn");
    return translated(std::string_view(triangleStateName(state)));
}

QString pickedWords() { return MapWords::tr("picked"); }

}  // namespace cullscope::ui
