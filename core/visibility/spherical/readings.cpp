#include "core/visibility/spherical/readings.h"

#include "core/base/message.h"

namespace cullscope::spherical {

std::vector<ParameterDeclaration> readingParameters() {
    return {choiceParameter("branch", "text", CULLSCOPE_TR("Which objects contour bands decide about."),
                            {{"text", CULLSCOPE_TR("those in the frustum that no corner ray meets (section 2.3)")},
                             {"appendix", CULLSCOPE_TR("those whose sphere lies inside the frustum (Appendix 1)")}}),
            choiceParameter("missed", "nearest", CULLSCOPE_TR("What becomes of a corner ray that meets no triangle."),
                            {{"nearest", CULLSCOPE_TR("the point of the sphere or box nearest to it is a corner of the region")},
                             {"left-out", CULLSCOPE_TR("the region has no corner there")},
                             {"bands", CULLSCOPE_TR("contour bands decide about the object")}}),
            choiceParameter("rays", "sphere", CULLSCOPE_TR("Where corner rays begin, and where a missed one takes its point."),
                            {{"sphere", CULLSCOPE_TR("the bounding sphere (sections 2.2 and 2.3)")},
                             {"box", CULLSCOPE_TR("the bounding box (Appendix 1)")}}),
            choiceParameter("joined", "chart", CULLSCOPE_TR("How the hits are joined to the visible region."),
                            {{"chart", CULLSCOPE_TR("straight on the map, so that the extremes are the hits'")},
                             {"arcs", CULLSCOPE_TR("by great circles, whose extremes may lie between the hits")}}),
            choiceParameter("pole", "direction", CULLSCOPE_TR("When a pole lies in the visible region, which is case 1."),
                            {{"direction", CULLSCOPE_TR("when the surface in its direction is within the view")},
                             {"outline", CULLSCOPE_TR("when the outline winds around it")}}),
            choiceParameter("cut", "for-good", CULLSCOPE_TR("What a band hides whose S does not exceed the largest before it."),
                            {{"for-good", CULLSCOPE_TR("itself and all bands of its sector behind it")},
                             {"by-band", CULLSCOPE_TR("itself alone")}})};
}

Readings readingsOf(const ParameterSet& parameters) {
    Readings readings;
    if (parameters.choice("branch") == "appendix") readings.branch = Branch::Appendix;
    const std::string missed = std::string(parameters.choice("missed"));
    if (missed != "nearest") readings.missed = missed == "bands" ? Missed::Bands : Missed::LeftOut;
    if (parameters.choice("rays") == "box") readings.start = RayStart::Box;
    if (parameters.choice("joined") == "arcs") readings.join = Join::Arcs;
    if (parameters.choice("pole") == "outline") readings.pole = PoleRule::Outline;
    if (parameters.choice("cut") == "by-band") readings.cut = Cut::ByBand;
    return readings;
}

}  // namespace cullscope::spherical
