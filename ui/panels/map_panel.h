#pragma once

#include <QComboBox>
#include <QLabel>

#include "ui/plots/map_widget.h"
#include "ui/plots/picture_menu.h"
#include "ui/session/snapshot_reader.h"

namespace cullscope::ui {

/// The map of directions that the strategy of the reader's view declares: that of the picked object, else of the one that the
/// strategy shows by itself. A click on a cell picks one of its triangles, and the picked triangle's cells are marked.
class MapPanel : public QWidget {
    Q_OBJECT

public:
    MapPanel(Session& session, SnapshotReader& reader, QWidget* parent = nullptr);

    [[nodiscard]] MapWidget& map() { return *m_map; }
    [[nodiscard]] const MapWidget& map() const { return *m_map; }
    [[nodiscard]] QComboBox& colouring() { return *m_colouring; }
    [[nodiscard]] PictureMenu& pictures() { return *m_pictures; }
    /// The text in place of the map; empty: the map is shown.
    [[nodiscard]] QString sentence() const { return m_sentence->isHidden() ? QString() : m_sentence->text(); }
    /// Shows a map, whose objects are numbered as in the session's scene. An empty one shows a text instead.
    void showMap(const ShownMap& shown);
    /// Picks a triangle of a cell of the shown map: the farthest-out one that the cell owns. If one of the cell's triangles is
    /// picked already, picks the next nearer one; triangles that only touch the cell come after those that it owns.
    void pickIn(uint32_t cell);
    /// With one line over it and no legend, for a strip under a picture.
    void setBrief();
    /// Colours the map by one of its colourings; an unknown one changes nothing.
    void setColouring(const std::string& id);
    /// Marks a part, from 1, on maps that have it; none: marks no part.
    void setPart(const std::optional<uint32_t>& part);

signals:
    /// Another map, another part of it or another colouring is shown, and so other lines and colours.
    void shownChanged();

protected:
    void changeEvent(QEvent* event) override;

private:
    void layOut();
    void refresh();
    void retranslate();
    [[nodiscard]] QString noMapSentence() const;
    void showSentence();
    /// Lists the colourings that the map has. If the present one is not among them, changes to the first.
    void offerColourings(const CellMap& map);
    [[nodiscard]] std::shared_ptr<const TriangleStates> truth() const;
    /// The picked triangle, numbered within the shown map's mesh; none: no triangle of that object is picked.
    [[nodiscard]] std::optional<uint32_t> pickedTriangle(const ShownMap& shown) const;
    /// The lines around the subject in hand of a stepped view; none where it does not lie on the shown map.
    [[nodiscard]] std::vector<std::vector<Vec2>> inHand(const ShownMap& shown) const;
    [[nodiscard]] std::optional<uint32_t> partOf(const ShownMap& shown) const;

    Session& m_session;
    SnapshotReader& m_reader;
    QLabel* m_sentence;
    QWidget* m_choices;
    QLabel* m_colouringLabel;
    QComboBox* m_colouring;
    MapWidget* m_map;
    PictureMenu* m_pictures;
    std::optional<uint32_t> m_part;
    bool m_brief = false;
};

}  // namespace cullscope::ui
