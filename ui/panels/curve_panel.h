#pragma once

#include <QLabel>
#include <QSpinBox>

#include "ui/plots/curve_plot.h"
#include "ui/plots/picture_menu.h"
#include "ui/session/shown_reading.h"

namespace cullscope::ui {

/// One of the curves that strategies declare, of the picked object or of the one that the strategy shows by itself. Where an
/// object has parts, one of them can be chosen, or all together.
class CurvePanel : public QWidget {
    Q_OBJECT

public:
    /// Gives the curve of a part (core/frame/curve.h); null, or a result of none: there is none.
    using Curves = std::function<std::optional<Curve>(const std::optional<uint32_t>& part)>;

    /// `show` declares the curve.
    CurvePanel(Session& session, SnapshotReader& reader, Show show, QWidget* parent = nullptr);

    [[nodiscard]] const Show& declared() const { return m_show; }
    [[nodiscard]] CurvePlot& plot() { return *m_plot; }
    /// The field for the part. Before the user chooses one, it is the one that the strategy shows by itself.
    [[nodiscard]] QSpinBox& part() { return *m_part; }
    [[nodiscard]] PictureMenu& pictures() { return *m_pictures; }
    /// The shown part, from 1; none: all together, or there are none. While a view is stepped, it is the part in hand.
    [[nodiscard]] std::optional<uint32_t> shownPart() const;
    /// For an audience: the areas' colours are explained elsewhere.
    void setBrief() { m_plot->setBrief(); }
    /// The states whose colours the shown curve has.
    [[nodiscard]] std::vector<TriangleState> states() const;
    /// The height in which all of it is shown, at that width.
    [[nodiscard]] int neededHeight(int width) const;
    void show(Curves curves);
    using QWidget::show;

signals:
    /// The shown part, or the curve that it belongs to, changed.
    void partChanged();

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void choose(int part);
    void showCurve();
    void showAbsence();
    /// The interval in hand of a stepped view, where it lies on this curve; none else.
    [[nodiscard]] std::optional<SubjectPlace::OnCurve> inHand() const;
    void retranslate();

    Session& m_session;
    SnapshotReader& m_reader;
    Show m_show;
    QWidget* m_choices;
    QLabel* m_name;
    QSpinBox* m_part;
    QLabel* m_words;
    CurvePlot* m_plot;
    PictureMenu* m_pictures;
    Curves m_curves;
    std::optional<uint32_t> m_chosen;  ///< by the user
};

}  // namespace cullscope::ui
