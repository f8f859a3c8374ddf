#include "core/experiments/han_hong_readings.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/experiments/han_hong_random_views.h"
#include "core/experiments/han_hong_rows.h"
#include "core/visibility/spherical/map_coordinates.h"
#include "core/visibility/spherical/mapped_scene.h"
#include "core/visibility/spherical/readings.h"
#include "core/visibility/strategy_request.h"

namespace cullscope {
namespace {

using namespace han_hong;
using Origin = ResultColumn::Origin;

constexpr const char* kDistance = "distance_r";

/// Views of a whole object from directions spread evenly, at one distance in radii of its bounding sphere.
CameraPath viewsFrom(const Scene& scene, size_t directions, double distance, Angle field, std::string name) {
    CameraPath path = cameraPath(fmt::format("fibonacci:{}", directions), scene);
    const Sphere& around = scene.boundingSphere();
    path.name = std::move(name);
    path.fovy = field;
    path.nearDistance = std::max(0.5 * (distance - 1.0), 0.001) * around.radius;
    path.farDistance = (distance + 2.0) * around.radius;
    for (CameraPath::Pose& pose : path.poses) {
        const Vec3 direction = glm::normalize(pose.eye - around.centre);
        pose.eye = around.centre + distance * around.radius * direction;
        pose.target = around.centre;
    }
    return path;
}

/// From 1.6 to 2.7 radii with 45 degrees: around where an object of the usual proportions begins to be in view whole.
CameraPath viewsNearTheEdge(const Scene& scene) {
    CameraPath all;
    for (const double distance : {1.6, 1.8, 2.0, 2.2, 2.45, 2.7}) {
        CameraPath path = viewsFrom(scene, 6, distance, Angle::fromDegrees(45.0), "around-2r");
        if (all.poses.empty()) {
            all = path;
        } else {
            all.poses.insert(all.poses.end(), path.poses.begin(), path.poses.end());
        }
        all.nearDistance = std::min(all.nearDistance, path.nearDistance);
        all.farDistance = std::max(all.farDistance, path.farDistance);
    }
    return all;
}

/// Twelve random views with 45 degrees in which one to three corner rays hit the object.
CameraPath viewsWithSomeHits(const Scene& scene) {
    const Angle field = Angle::fromDegrees(45.0);
    std::vector<View> views;
    for (const FoundView& each : randomViews(scene, ConsideredFaces(scene), field, kRandomViews, 12,
                                             [](const Considered& found) { return found.hits >= 1 && found.hits <= 3; }))
        views.push_back(each.view);
    return pathThrough(views, field, "some-rays-hit");
}

/// `spherical` as it reads the paper by default, and with each other reading alone.
std::vector<std::string> readings() {
    std::vector<std::string> result{"spherical"};
    std::vector<ParameterDeclaration> parameters = spherical::readingParameters();
    std::ranges::move(spherical::coordinateParameters(), std::back_inserter(parameters));
    parameters.push_back(spherical::storageParameter());
    for (const ParameterDeclaration& parameter : parameters)
        for (const ParameterDeclaration::Choice& choice : parameter.choices)
            if (choice.id != std::get<std::string>(parameter.defaultValue))
                result.push_back(fmt::format("spherical:{}={}", parameter.key, choice.id));
    return result;
}

/// The share of the frames in which the region between corner rays was drawn; in the others bands decided, or all was drawn.
double shareWithRegion(const RunMeasurement& run) {
    const auto drawn = std::ranges::count_if(run.frames, [](const FrameMeasurement& frame) {
        return std::ranges::any_of(frame.figures, [](const NamedFigure& figure) { return figure.name == "case"; });
    });
    return double(drawn) / double(run.frames.size());
}

}  // namespace

Experiment sphericalReadings() {
    Experiment experiment;
    experiment.id = "spherical-readings";
    experiment.title = CULLSCOPE_TR("What the paper leaves open, reading by reading");
    experiment.source = std::string(kSource) + ", text and Appendix 1";
    experiment.notes = {
        note(CULLSCOPE_TR("Section 2.3 sends objects that no corner ray meets to the contour bands; Appendix 1 only those whose "
                          "bounding sphere lies inside the frustum. What becomes of one to three rays that miss, how hits are "
                          "joined, and whether a band that is hidden ends its sector, the paper does not say.")),
        note(CULLSCOPE_TR("Each row but the first differs from spherical by one reading. Views are the three cases of Table 2, "
                          "36 views from 1.6 to 2.7 radii with 45 degrees, 12 random ones with 45 degrees in which one to three "
                          "corner rays hit, and 12 views of the whole object.")),
        lossNote()};
    Axis paths{"path", CULLSCOPE_TR("views"), Axis::Kind::Path, {}};
    std::vector<Setting> settings{bunnySetting("case-1", kSmall),        bunnySetting("case-2", kSmall),
                                  bunnySetting("case-3", kSmall),        bunnySetting("around-2r", kLarge),
                                  bunnySetting("some-rays-hit", kLarge), bunnySetting("fibonacci:12", kLarge)};
    settings[3].views = viewsNearTheEdge;
    settings[4].views = viewsWithSomeHits;
    for (const Setting& setting : settings) paths.values.emplace_back(setting.path);
    experiment.axes = {paths, strategiesAxis(readings())};
    for (Setting& setting : settings) {
        setting.labels = {{"path", setting.path}};
        addTimed(experiment, setting);
    }
    experiment.columns = timedColumns(experiment.axes, {});
    const std::vector<ResultColumn> costs{{"cull_ms", CULLSCOPE_TR("culling, ms"), Origin::Measured, 2},
                                          {"build_ms", CULLSCOPE_TR("build, ms"), Origin::Measured, 1},
                                          {"structure_bytes", CULLSCOPE_TR("bytes"), Origin::Measured}};
    experiment.columns.insert(experiment.columns.end(), costs.begin(), costs.end());
    experiment.rowsOfRuns = sphericalRows;
    return withOtherScenes(std::move(experiment));
}

Experiment sphericalDomain() {
    Experiment experiment;
    experiment.id = "spherical-domain";
    experiment.title = CULLSCOPE_TR("Where the spherical method works");
    experiment.source = kSource;
    experiment.notes = {
        note(CULLSCOPE_TR(
            "Eight directions spread evenly; the distance of the eye is in radii of the bounding sphere, the field of "
            "view is vertical, the picture 640 × 480. Of four corner rays that hit, the region between them is drawn; "
            "of none, contour bands decide.")),
        lossNote()};
    Axis distances{kDistance, CULLSCOPE_TR("distance, radii"), Axis::Kind::Label,
                   axisValues(std::array{1.05, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0})};
    Axis fields{kField, CULLSCOPE_TR("field of view, °"), Axis::Kind::Label,
                axisValues(std::array{10.0, 20.0, 35.0, 45.0, 65.0, 90.0})};
    experiment.axes = {fields, distances, strategiesAxis({"spherical"})};
    experiment.settings = settingsOf(experiment.axes, bunnySetting("", kLarge));
    for (Setting& setting : experiment.settings) {
        const double distance = setting.number(kDistance), field = setting.number(kField);
        setting.path = fmt::format("{:g} radii, {:g} degrees", distance, field);
        setting.views = [distance, field, name = setting.path](const Scene& scene) {
            return viewsFrom(scene, 8, distance, Angle::fromDegrees(field), name);
        };
    }
    experiment.columns = timedColumns(experiment.axes, {});
    experiment.rowsOfRuns = [](const Setting& setting, const MeasureResult& result) {
        Rows rows = sphericalRows(setting, result);
        for (size_t i = 0; i < rows.size(); ++i) {
            Row& row = rows[i];
            row["considered_share"] =
                std::get<double>(row.at("considered_triangles")) / double(result.request.scene->triangleCount());
            if (row.contains("rays_hit") || row["strategy"] == CellValue(std::string("spherical")))
                row["region_share"] = shareWithRegion(result.runs[i]);
            if (!row.contains("rays_hit") && row.contains("region_share")) row["rays_hit"] = 0.0;
        }
        return rows;
    };
    for (ResultColumn& column : experiment.columns)
        if (column.key == kDistance) column.decimals = 2;
    experiment.columns.insert(experiment.columns.begin() + 4,
                              {{"region_share", CULLSCOPE_TR("region between rays, share of the views"), Origin::Measured, 2},
                               {"considered_share", CULLSCOPE_TR("share of the faces"), Origin::Measured, 3}});
    const auto map = [](const char* title, const char* column, double scale, int decimals) {
        RowPlot plot;
        plot.plot.title = title;
        plot.plot.x = {CULLSCOPE_TR("distance, radii"), PlotScale::Linear};
        plot.plot.y = {CULLSCOPE_TR("field of view, °"), PlotScale::Linear};
        plot.x = kDistance;
        plot.cellsOver = kField;
        plot.y = {{column}};
        plot.rows = {{"strategy", {CellValue(std::string("spherical"))}}};
        plot.scale = scale;
        plot.decimals = decimals;
        return plot;
    };
    experiment.plots = {map(CULLSCOPE_TR("Views in which the region between rays is drawn, %"), "region_share", 100.0, 0),
                        map(CULLSCOPE_TR("Corner rays that hit, of 4"), "rays_hit", 1.0, 1),
                        map(CULLSCOPE_TR("Faces considered, %"), "considered_share", 100.0, 0),
                        map(CULLSCOPE_TR("Lost pixels, %"), "missed_pixel_rate", 100.0, 1),
                        map(CULLSCOPE_TR("Speed, × all"), "ratio_to_all", 1.0, 2)};
    return withOtherScenes(std::move(experiment));
}

}  // namespace cullscope
