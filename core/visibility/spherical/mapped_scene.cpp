#include "core/visibility/spherical/mapped_scene.h"

#include <algorithm>
#include <cmath>

#include "core/base/message.h"
#include "core/visibility/spherical/map_coordinates.h"

namespace cullscope::spherical {
namespace {

ParameterDeclaration wholeNumber(std::string key, int64_t value, double least, double most, std::string description) {
    return {std::move(key), ParameterType::Integer, value, least, most, "", std::move(description), {}};
}

SphericalGrid gridFor(const TriangleMesh& mesh, const ParameterSet& parameters) {
    const auto rows = uint32_t(parameters.integer("rows"));
    if (rows == 0) return SphericalGrid::forTriangles(mesh.triangleCount());
    // With more cells than triangles most cells would be empty; the limit saves memory in a scene of many small meshes.
    const auto most = uint32_t(std::ceil(std::sqrt(double(mesh.triangleCount()) / 2.0)));
    const uint32_t taken = std::max(std::min(rows, most), 2u);
    return SphericalGrid(2 * taken, taken);
}

TriangleOrderPointer orderOfAll(const std::vector<MappedMesh>& meshes) {
    auto order = std::make_shared<TriangleOrder>();
    auto owner = std::make_shared<std::vector<SphericalMapsPointer>>();
    for (const MappedMesh& mesh : meshes) {
        owner->push_back(mesh.maps);
        order->meshes.push_back(mesh.maps ? TriangleOrder::OfMesh{mesh.maps->indices(), mesh.maps->triangleOrder()}
                                          : TriangleOrder::OfMesh{});
    }
    order->owner = std::move(owner);
    return order;
}

void fillReport(MappedScene& structure) {
    double cells = 0, entries = 0, centroid = 0, index = 0, access = 0, bands = 0, rows = 0;
    SphericalMaps::BuildTimes times;
    for (const MappedMesh& mesh : structure.meshes) {
        if (!mesh.maps) continue;
        const SphericalMaps::Bytes bytes = mesh.maps->bytes();
        cells += mesh.maps->grid().cellCount();
        rows = std::max(rows, double(mesh.maps->grid().rows()));
        entries += double(mesh.maps->indexEntries());
        centroid += double(bytes.centroidMap);
        index += double(bytes.indexMap);
        access += double(bytes.accessMap);
        bands += double(mesh.bandCells->bytes() + (mesh.horizonCells ? mesh.horizonCells->bytes() : 0));
        times.centroidMap += mesh.maps->buildTimes().centroidMap;
        times.indexMap += mesh.maps->buildTimes().indexMap;
        times.accessMap += mesh.maps->buildTimes().accessMap;
    }
    structure.report.bytes = uint64_t(centroid + index + access + bands);
    structure.report.figures = {{"objects", double(structure.scene().instances().size())},
                                {"rows", rows},
                                {"cells", cells},
                                {"index map entries", entries},
                                {"centroid map bytes", centroid},
                                {"index map bytes", index},
                                {"memory access map bytes", access},
                                {"band cell bytes", bands},
                                {"centroid map ms", times.centroidMap},
                                {"index map ms", times.indexMap},
                                {"memory access map ms", times.accessMap}};
}

}  // namespace

SphericalMapsPointer makeMaps(const MeshPointer& mesh, const ParameterSet& parameters, const Progress& progress) {
    const auto has = [&](std::string_view key) {
        return std::ranges::any_of(parameters.declarations(), [&](const ParameterDeclaration& each) { return each.key == key; });
    };
    const MapFrame frame = has("axis") ? mapFrame(*mesh, coordinatesOf(parameters)) : MapFrame{mesh->localSphere()};
    const MapStorage storage =
        has("storage") && parameters.choice("storage") == "entries" ? MapStorage::Entries : MapStorage::Cells;
    return std::make_shared<SphericalMaps>(mesh, gridFor(*mesh, parameters), frame, storage, progress);
}

void finish(MappedScene& structure) {
    structure.order = orderOfAll(structure.meshes);
    fillReport(structure);
}

ParameterDeclaration rowsParameter() {
    return readWhenBuilding(
        wholeNumber("rows", SphericalGrid::kRows, 0, 4096,
                    CULLSCOPE_TR("Rows of the maps, 2 at least; columns are twice as many. A mesh has no more cells than "
                                 "triangles. 0: as many cells a triangle as in the paper.")));
}

ParameterDeclaration storageParameter() {
    return readWhenBuilding(
        choiceParameter("storage", "cells", CULLSCOPE_TR("What the maps keep of R."),
                        {{"cells", CULLSCOPE_TR("of each cell its nearest and farthest surface")},
                         {"entries", CULLSCOPE_TR("with each entry of the index map its centroid's (Table 1)")}}));
}

std::vector<ParameterDeclaration> bandParameters(double width, int64_t sectors) {
    return {
        {"band", ParameterType::Real, width, 0.25, 45.0, "°", CULLSCOPE_TR("Width of a contour band, seen from the centre."), {}},
        wholeNumber("sectors", sectors, 1, 1440, CULLSCOPE_TR("Sectors into which a contour band is divided."))};
}

ContourBands bandsFor(const Vec3& eye, const ParameterSet& parameters) {
    return makeBands(eye, Angle::fromDegrees(parameters.real("band")).radians(), uint32_t(parameters.integer("sectors")));
}

}  // namespace cullscope::spherical
