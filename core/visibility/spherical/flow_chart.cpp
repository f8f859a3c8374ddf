#include "core/visibility/spherical/flow_chart.h"

#include "core/base/message.h"
#include "core/visibility/spherical/listings.h"

namespace cullscope::spherical {
FlowChart flowChart() {
    // Here, so that no name hides a type elsewhere where several sources are compiled as one.
    enum Box : size_t {
        Vertices,
        Maps,
        Sphere,
        Outside,
        Around,
        Inside,
        Rays,
        Search,
        Hit,
        Region,
        Boxes,
        Bands,
        Draw,
        Pipeline
    };
    using Kind = FlowBox::Kind;
    const auto line = [](BandsLine each) { return uint8_t(each); };
    FlowChart chart;
    chart.boxes = {
        {Kind::Action, CULLSCOPE_TR("Vertices to spherical coordinates R, θ, φ"), 1.0, 0.0},
        {Kind::Structure, CULLSCOPE_TR("Centroid map, triangle index map, memory access map"), 1.0, 1.0},
        {Kind::Question,
         CULLSCOPE_TR("Bounding sphere and frustum"),
         1.0,
         2.0,
         {line(BandsLine::Objects), line(BandsLine::Sphere)}},
        {Kind::Action, CULLSCOPE_TR("Nothing is drawn"), 0.0, 2.0, {line(BandsLine::Outside)}},
        {Kind::Action, CULLSCOPE_TR("All of it goes to the pipeline"), 2.0, 2.0, {line(BandsLine::Whole)}},
        {Kind::Question, CULLSCOPE_TR("Inside the frustum?"), 1.0, 3.0},
        {Kind::Action, CULLSCOPE_TR("Four corner rays, from where they enter the sphere"), 1.0, 4.0, {line(BandsLine::Rays)}},
        {Kind::Action,
         CULLSCOPE_TR("Search of the triangle index map for the triangles hit"),
         1.0,
         5.0,
         {line(BandsLine::Cells)}},
        {Kind::Question, CULLSCOPE_TR("Does a ray meet the object?"), 1.0, 6.0},
        {Kind::Action, CULLSCOPE_TR("Visible region on the map: case 1, 2 or 3"), 0.0, 7.0, {line(BandsLine::Region)}},
        {Kind::Action, CULLSCOPE_TR("Boxes around it, ranges of the memory access map"), 0.0, 8.0, {line(BandsLine::Boxes)}},
        {Kind::Action, CULLSCOPE_TR("Contour bands on the maps, S by sector"), 2.0, 7.0, {line(BandsLine::Bands)}},
        {Kind::Action,
         CULLSCOPE_TR("Near half, and what no larger S hides: ranges of the memory access map"),
         2.0,
         8.0,
         {line(BandsLine::Draw)}},
        {Kind::Structure, CULLSCOPE_TR("Graphics pipeline"), 1.0, 9.0}};
    using Way = FlowArrow::Way;
    chart.arrows = {{Vertices, Maps},
                    {Maps, Sphere},
                    {Sphere, Outside, CULLSCOPE_TR("outside")},
                    {Sphere, Around, CULLSCOPE_TR("around the eye")},
                    {Sphere, Inside, CULLSCOPE_TR("inside, or cut by a plane")},
                    {Inside, Bands, CULLSCOPE_TR("yes"), Way::Across},
                    {Inside, Rays, CULLSCOPE_TR("no")},
                    {Rays, Search},
                    {Search, Hit},
                    {Hit, Region, CULLSCOPE_TR("yes"), Way::Across},
                    {Hit, Bands, CULLSCOPE_TR("no"), Way::Across},
                    {Region, Boxes},
                    {Bands, Draw},
                    {Boxes, Pipeline, {}, Way::Across},
                    {Draw, Pipeline, {}, Way::Across}};
    chart.parts = {{0, CULLSCOPE_TR("Once for each mesh")}, {2, CULLSCOPE_TR("For each object, in every frame")}};
    return chart;
}

}  // namespace cullscope::spherical
