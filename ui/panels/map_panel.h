#pragma once

#include <QComboBox>
#include <QLabel>

#include "ui/panels/map_widget.h"
#include "ui/panels/picture_menu.h"

namespace cullscope::ui {

/// The map of directions of the active view's strategy: of the picked object, else of the first one that is not outside the
/// frustum. A click on a cell picks a triangle of it, and what is picked is marked.
class MapPanel : public QWidget {
    Q_OBJECT

public:
    MapPanel(Session& session, SnapshotReader& reader, QWidget* parent = nullptr);

    [[nodiscard]] MapWidget& map() { return *m_map; }
    [[nodiscard]] QComboBox& colouring() { return *m_colouring; }
    [[nodiscard]] PictureMenu& pictures() { return *m_pictures; }
    /// What stands in the place of the map; empty: the map does.
    [[nodiscard]] QString sentence() const { return m_sentence->isHidden() ? QString() : m_sentence->text(); }
    /// Shows a map, which numbers the objects of the session's scene; empty: a sentence.
    void showMap(const ShownMap& shown);
    /// Picks the farthest-out triangle that a cell of the shown map owns; where one of the cell's is picked already, the next one
    /// nearer, the triangles that only touch the cell after those that it owns.
    void pickIn(uint32_t cell);
    /// Marks a sector of the bands on maps that have it; none: none.
    void setSector(const std::optional<uint32_t>& sector);

protected:
    void changeEvent(QEvent* event) override;

private:
    void layOut();
    void refresh();
    void retranslate();
    void showSentence();
    /// The colourings that the map has; where it does not have the present one, its entries.
    void offerColourings(const ShownMap& shown);
    [[nodiscard]] std::shared_ptr<const TriangleStates> truth() const;
    /// Of the shown map's mesh; none: nothing of it is picked.
    [[nodiscard]] std::optional<uint32_t> pickedTriangle(const ShownMap& shown) const;

    [[nodiscard]] std::optional<uint32_t> sectorOf(const ShownMap& shown) const;

    Session& m_session;
    SnapshotReader& m_reader;
    QLabel* m_sentence;
    QWidget* m_choices;
    QLabel* m_colouringLabel;
    QComboBox* m_colouring;
    MapWidget* m_map;
    PictureMenu* m_pictures;
    std::optional<uint32_t> m_sector;
};

}  // namespace cullscope::ui
