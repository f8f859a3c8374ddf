#include "core/experiments/han_hong_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

#include "core/experiments/han_hong_rows.h"
#include "core/experiments/han_hong_views.h"
#include "core/spatial/spherical_maps.h"

namespace cullscope {
namespace {

using Origin = ResultColumn::Origin;
using namespace han_hong;

constexpr double kMegabyte = 1e6;

// ---- What the paper prints

struct FramesPerSecond {
    double fpsAll, fpsProposed;
};
using Cases = std::array<FramesPerSecond, 3>;

constexpr double kFacesOfTable2 = 144'078;
constexpr std::array kConsideredOfTable2{13'508.0, 16'434.0, 26'308.0};
/// Degrees: with this field of view there are views of each case that consider the paper's number of the bunny's faces.
constexpr double kNarrow = 10.0;
constexpr std::array kFields{kNarrow, 35.0, 50.0, 65.0};
constexpr Cases kTable2{{{295, 486}, {300, 432}, {295, 389}}};
constexpr Cases kTable3Small{{{80, 376}, {84, 421}, {80, 202}}};
constexpr Cases kTable3Large{{{63, 153}, {65, 174}, {63, 136}}};
constexpr Cases kTable4Four{{{70, 206}, {70, 286}, {71, 161}}};
constexpr Cases kTable4Eight{{{21, 95}, {21, 32}, {21, 75}}};

struct Range {
    double most, least, mean;
};
constexpr Range kTable5ArraysAll{134, 134, 134}, kTable5ArraysProposed{199, 137, 170};
constexpr Range kTable5VboAll{700, 700, 700}, kTable5VboProposed{828, 738, 780};

// ---- Notes

Message consideredNote() {
    return note(CULLSCOPE_TR(
        "The paper's column is the faces considered. Views are chosen so that spherical considers as many here, in the "
        "stated case; faces in the frustum, those on the far side too, and the rays that hit are results. Where a "
        "lens has no such view, the nearest one is measured, and its row shows it."));
}
Message pathsNote() {
    return note(CULLSCOPE_TR("The built-in paths case-1 to case-3 have the paper's number of faces in the frustum instead."));
}

Message baselineNote() {
    return note(
        CULLSCOPE_TR("The paper compares with drawing every face, back faces too. Against OpenGL's own back-face culling the "
                     "gain is smaller: both ratios are given."));
}
Message machineNote() {
    return note(
        CULLSCOPE_TR("The paper's machine was a Xeon at 2.33 GHz with a Quadro FX 5500: compare the ratios, not the frames per "
                     "second."));
}
Message disagreementNote() {
    return note(CULLSCOPE_TR(
        "Four windows of 320 × 240 are in Table 3 and in Table 4, with different numbers: 376, 421, 202 against 206, "
        "286, 161 frames per second."));
}

// ---- Table 1

/// A label of settings of several windows, and its values.
constexpr const char* kWindowViews = "window_views";
constexpr const char *kOneView = CULLSCOPE_TR("one"), *kDifferent = CULLSCOPE_TR("different");

constexpr const char* kModel = CULLSCOPE_TR("model");
constexpr std::array kMaps{CULLSCOPE_TR("centroid map"), CULLSCOPE_TR("triangle index map"), CULLSCOPE_TR("memory access map")};
constexpr const char* kThreeMaps = CULLSCOPE_TR("the three maps");

/// What one of the maps takes.
struct MapCost {
    uint64_t bytes = 0;
    double milliseconds = 0.0;
};

/// Of the three maps and of all of them.
std::array<MapCost, 4> costsOf(const SphericalMaps& maps) {
    const SphericalMaps::Bytes bytes = maps.bytes();
    const SphericalMaps::BuildTimes& times = maps.buildTimes();
    return {{{bytes.centroidMap, times.centroidMap},
             {bytes.indexMap, times.indexMap},
             {bytes.accessMap, times.accessMap},
             {bytes.all(), times.centroidMap + times.indexMap + times.accessMap}}};
}

Rows structureRows(const Setting& /*setting*/, const ScenePointer& scene, const Progress& progress) {
    constexpr double kCells = double(SphericalGrid::kColumns) * SphericalGrid::kRows;
    const auto faces = double(scene->triangleCount());
    const MeshPointer& mesh = scene->meshes().front();
    const auto costs = [&](MapStorage storage, const Progress& part) {
        return costsOf(SphericalMaps(mesh, SphericalGrid(), {mesh->localSphere()}, storage, part));
    };
    const std::array<MapCost, 4> cells = costs(MapStorage::Cells, progress.part(0.0, 0.5)),
                                 entries = costs(MapStorage::Entries, progress.part(0.5, 1.0));
    // float × 4 × faces; float × 2 × 360 × 180 × faces; unsigned int × 4 × 360 × 180
    const double centroid = 4 * 4 * faces, index = 4 * 2 * kCells * faces, access = 4 * 4 * kCells;
    const std::array<double, 4> stated{4.3, 6.7, 0.51, 4.3 + 6.7 + 0.51},
        formulas{centroid, index, access, centroid + index + access};
    const auto bytes = double(scene->bytes());
    Rows rows{
        {{"structure", std::string(kModel)}, {"paper_megabytes", 10.0}, {"bytes", bytes}, {"megabytes", bytes / kMegabyte}}};
    for (size_t i = 0; i < cells.size(); ++i)
        rows.push_back({{"structure", std::string(i < kMaps.size() ? kMaps[i] : kThreeMaps)},
                        {"paper_megabytes", stated[i]},
                        {"paper_formula_megabytes", formulas[i] / kMegabyte},
                        {"bytes", double(cells[i].bytes)},
                        {"megabytes", double(cells[i].bytes) / kMegabyte},
                        {"build_ms", cells[i].milliseconds},
                        {"entries_megabytes", double(entries[i].bytes) / kMegabyte},
                        {"entries_build_ms", entries[i].milliseconds}});
    return rows;
}

Experiment table1() {
    Experiment experiment;
    experiment.id = "table-1";
    experiment.title = CULLSCOPE_TR("Sizes of the three structures");
    experiment.source = std::string(kSource) + ", Table 1";
    experiment.notes = {
        facesNote(),
        note(CULLSCOPE_TR("The paper's formulas (4 floats a face; 2 floats a cell and face; 4 integers a cell) do not give its "
                          "sizes: its index map would take 74.7 GB.")),
        note(CULLSCOPE_TR("In the paper's table the contents stand in the wrong columns: count, start and reference belong to "
                          "the memory access map.")),
        note(CULLSCOPE_TR(
            "Here a cell has its nearest and farthest R. With storage=entries of spherical, R stands with each entry "
            "of the index map, and the centroid map has R, θ, φ, as in the paper's formulas.")),
        note(CULLSCOPE_TR("All at 360 × 180 cells; 1 MB is 1,000,000 bytes."))};
    Axis structures{"structure", CULLSCOPE_TR("structure"), Axis::Kind::InTurns, {std::string(kModel)}};
    for (const char* map : kMaps) structures.values.emplace_back(std::string(map));
    structures.values.emplace_back(std::string(kThreeMaps));
    experiment.axes = {structures};
    experiment.columns = {{"structure", CULLSCOPE_TR("structure"), Origin::Axis},
                          {"paper_megabytes", CULLSCOPE_TR("paper: MB"), Origin::Stated, 2},
                          {"paper_formula_megabytes", CULLSCOPE_TR("paper's formula: MB"), Origin::Stated, 2},
                          {"megabytes", CULLSCOPE_TR("here: MB"), Origin::Measured, 2},
                          {"bytes", CULLSCOPE_TR("bytes"), Origin::Measured},
                          {"build_ms", CULLSCOPE_TR("build, ms"), Origin::Measured, 1},
                          {"entries_megabytes", CULLSCOPE_TR("storage=entries: MB"), Origin::Measured, 2},
                          {"entries_build_ms", CULLSCOPE_TR("its build, ms"), Origin::Measured, 1}};
    Setting setting;
    setting.scene = kBunny;
    experiment.settings = {setting};
    experiment.measured = structureRows;
    return experiment;
}

// ---- Tables 2 to 5

const std::vector<ResultColumn>& paperFpsColumns() {
    static const std::vector<ResultColumn> kColumns{{"paper_fps", CULLSCOPE_TR("paper: fps"), Origin::Stated},
                                                    {"paper_speedup_vs_all", CULLSCOPE_TR("paper: × all"), Origin::Stated, 2}};
    return kColumns;
}

// ---- Tables 2 to 4: the frustum cuts the object

std::string sizeText(Viewport size) { return std::to_string(size.width) + "×" + std::to_string(size.height); }

const char* uploadId(Upload upload) { return upload == Upload::Vbo ? "vbo" : "vertex-array"; }

Setting timedSetting(const std::string& path, Viewport size, int windows, Upload upload) {
    Setting setting = bunnySetting(path, size);
    setting.windows = windows;
    setting.upload = upload;
    setting.labels = {{"size", sizeText(size)}, {"windows", double(windows)}, {"upload", std::string(uploadId(upload))}};
    return setting;
}

/// `different`: the windows show different views of a case's path; of one window nothing else can be.
void addCases(Experiment& experiment, const Cases& rows, Viewport size, int windows, double field = kNarrow,
              bool different = false) {
    for (size_t i = 0; i < rows.size(); ++i) {
        Setting setting = timedSetting("", size, windows, Upload::Vbo);
        setting.path = fmt::format("considered-{}, {:g}°", i + 1, field);
        setting.views = [i, field](const Scene& scene) { return viewsOfCase(scene, tableCases()[i], Angle::fromDegrees(field)); };
        setting.labels["case"] = double(i + 1);
        setting.differentViews = different;
        if (windows > 1) setting.labels[kWindowViews] = std::string(different ? kDifferent : kOneView);
        setting.labels[kField] = field;
        setting.stated["all"] = {{"paper_fps", rows[i].fpsAll}};
        setting.stated["spherical"] = {{"paper_fps", rows[i].fpsProposed},
                                       {"paper_speedup_vs_all", rows[i].fpsProposed / rows[i].fpsAll}};
        addTimed(experiment, setting);
    }
}

Experiment casesExperiment(const char* id, const char* title, const char* table) {
    Experiment experiment;
    experiment.id = id;
    experiment.title = title;
    experiment.source = std::string(kSource) + ", " + table;
    experiment.notes = {facesNote(), consideredNote(), pathsNote(), baselineNote(), lossNote(), machineNote()};
    experiment.rowsOfRuns = sphericalRows;
    return experiment;
}

/// Of several windows: the paper does not say whether they show the same.
Axis windowViewsAxis() {
    return {
        kWindowViews, CULLSCOPE_TR("views of the windows"), Axis::Kind::Label, {std::string(kOneView), std::string(kDifferent)}};
}
Message windowViewsNote() {
    return note(
        CULLSCOPE_TR("The paper does not say whether its windows show one view or different ones: both are measured. "
                     "Different ones are spread evenly over a case's twelve views."));
}
/// One view, then different ones.
void addWindowCases(Experiment& experiment, const Cases& rows, Viewport size, int windows) {
    for (const bool different : {false, true}) addCases(experiment, rows, size, windows, kNarrow, different);
}

Axis caseAxis() { return {"case", CULLSCOPE_TR("case"), Axis::Kind::Label, {1.0, 2.0, 3.0}}; }

Experiment table2() {
    Experiment experiment =
        casesExperiment("table-2", CULLSCOPE_TR("One window of 320 × 240, the object cut by the frustum"), "Table 2");
    std::vector<ResultColumn> paper = paperFpsColumns();
    paper.insert(paper.begin(), {"paper_faces", CULLSCOPE_TR("paper: faces"), Origin::Stated});
    experiment.axes = {{kField, CULLSCOPE_TR("field of view, °"), Axis::Kind::Label, axisValues(kFields)},
                       caseAxis(),
                       strategiesAxis({"spherical"})};
    experiment.columns = timedColumns(experiment.axes, paper);
    for (const double field : kFields) addCases(experiment, kTable2, kSmall, 1, field);
    for (size_t i = 0; i < experiment.settings.size(); ++i) {
        experiment.settings[i].stated["all"]["paper_faces"] = kFacesOfTable2;
        experiment.settings[i].stated["spherical"]["paper_faces"] = kConsideredOfTable2[i % kConsideredOfTable2.size()];
    }
    return experiment;
}

Experiment table3() {
    Experiment experiment = casesExperiment("table-3", CULLSCOPE_TR("Four windows, of two sizes"), "Table 3");
    experiment.axes = {{"size", CULLSCOPE_TR("size"), Axis::Kind::Label, {sizeText(kSmall), sizeText(kLarge)}},
                       windowViewsAxis(),
                       caseAxis(),
                       strategiesAxis({"spherical"})};
    experiment.columns = timedColumns(experiment.axes, paperFpsColumns());
    experiment.notes.insert(experiment.notes.begin() + 1, disagreementNote());
    experiment.notes.insert(experiment.notes.begin() + 2, windowViewsNote());
    addWindowCases(experiment, kTable3Small, kSmall, 4);
    addWindowCases(experiment, kTable3Large, kLarge, 4);
    return experiment;
}

Experiment table4() {
    Experiment experiment = casesExperiment("table-4", CULLSCOPE_TR("Four and eight windows of 320 × 240"), "Table 4");
    experiment.axes = {{"windows", CULLSCOPE_TR("windows"), Axis::Kind::Label, {4.0, 8.0}},
                       windowViewsAxis(),
                       caseAxis(),
                       strategiesAxis({"spherical"})};
    experiment.columns = timedColumns(experiment.axes, paperFpsColumns());
    experiment.notes.insert(experiment.notes.begin() + 1, disagreementNote());
    experiment.notes.insert(experiment.notes.begin() + 2, windowViewsNote());
    addWindowCases(experiment, kTable4Four, kSmall, 4);
    addWindowCases(experiment, kTable4Eight, kSmall, 8);
    return experiment;
}

// ---- Table 5: the object inside the frustum

Row rangeCells(const Range& range) {
    return {{"paper_fps_max", range.most}, {"paper_fps_min", range.least}, {"paper_fps_mean", range.mean}};
}

void addInside(Experiment& experiment, Upload upload, const Range& all, const Range& proposed) {
    Setting setting = timedSetting("fibonacci:12", kLarge, 1, upload);
    setting.stated["all"] = rangeCells(all);
    setting.stated["spherical"] = rangeCells(proposed);
    setting.stated["spherical"]["paper_speedup_vs_all"] = proposed.mean / all.mean;
    addTimed(experiment, setting);
}

Experiment table5() {
    Experiment experiment =
        casesExperiment("table-5", CULLSCOPE_TR("One window of 640 × 480, the object inside the frustum"), "Table 5");
    experiment.axes = {{"upload",
                        CULLSCOPE_TR("upload"),
                        Axis::Kind::Label,
                        {std::string(uploadId(Upload::VertexArray)), std::string(uploadId(Upload::Vbo))}},
                       strategiesAxis({"spherical", "spherical-horizon"})};
    experiment.columns = timedColumns(experiment.axes, {{"paper_fps_max", CULLSCOPE_TR("paper: fps max"), Origin::Stated},
                                                        {"paper_fps_min", CULLSCOPE_TR("paper: fps min"), Origin::Stated},
                                                        {"paper_fps_mean", CULLSCOPE_TR("paper: fps mean"), Origin::Stated},
                                                        paperFpsColumns().back()});
    experiment.notes.push_back(note(CULLSCOPE_TR(
        "The paper has \"10 or more\" views and does not say which: here 12, evenly around the object at three radii, all "
        "of it in view. spherical-horizon is not the paper's: it is the same idea made right.")));
    addInside(experiment, Upload::VertexArray, kTable5ArraysAll, kTable5ArraysProposed);
    addInside(experiment, Upload::Vbo, kTable5VboAll, kTable5VboProposed);
    return experiment;
}

}  // namespace

std::vector<Experiment> hanHongTables() {
    std::vector<Experiment> tables{table1(), table2(), table3(), table4(), table5()};
    for (Experiment& table : tables) table = withOtherScenes(std::move(table));
    return tables;
}

}  // namespace cullscope
