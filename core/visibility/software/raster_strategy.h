#pragma once

#include <array>
#include <vector>

#include "core/raster/depth_buffer.h"
#include "core/visibility/displaced_surfaces.h"
#include "core/visibility/registry.h"
#include "core/visibility/subject_place.h"

// What the strategies share that make their picture on the processor.

namespace cullscope::software {

struct NoStructure : Structure {
    using Structure::Structure;
};

/// A decision with three operands.
[[nodiscard]] Decision said(const Subject& subject, Decision::Outcome outcome, const char* sentence,
                            const std::array<double, Decision::kOperands>& operands);
[[nodiscard]] inline Subject ofRows(uint32_t first) { return {Subject::Kind::Rows, first, Subject::kNoObject}; }
/// A rectangle of the picture, as decisions name it (Decision::places): rows [firstRow, endRow), columns [begin, end).
[[nodiscard]] PlaceRun pixelsOf(const FrameContext& frame, int firstRow, int endRow, int begin, int end);
/// Sums of an operand over the decisions about such subjects that fell at a line.
[[nodiscard]] uint64_t sumAtLine(const FrameLog& log, Subject::Kind kind, uint8_t line, size_t operand);
[[nodiscard]] ParameterDeclaration parallelParameter();

/// The subjects of such a frame: several rows or triangles are called by the first and the last one.
class RasterSubjects : public SubjectPlaces {
public:
    RasterSubjects(ScenePointer scene, const FrameLog& log) : m_scene(std::move(scene)), m_width(uint32_t(log.size.width)) {}

    [[nodiscard]] std::optional<SubjectPlace> of(const Scene& /*scene*/, const Decision& /*decision*/) const override {
        return std::nullopt;
    }
    [[nodiscard]] EntryNames names(const StructureSnapshot& snapshot, const Decision& decision, size_t number) const override;

private:
    ScenePointer m_scene;
    uint32_t m_width;
};

/// A strategy that makes its picture on the processor from all triangles of the scene.
class RasterStrategy : public StrategyWith<NoStructure> {
public:
    /// Mesa's software OpenGL rounds in the same order; a graphics card's does not.
    [[nodiscard]] Promise promiseAt(const Structure& structure, const ParameterSet& parameters, Facing facing,
                                    const View& view) const override {
        return promiseWhereSurfacesStandStill(promise(structure, parameters, facing), structure.scene(), view);
    }
    void addWhySteps(const Structure& structure, const FrameLog& log, uint32_t instance, uint32_t triangle,
                     std::vector<WhyStep>& steps) const override;

protected:
    void fill(NoStructure& structure, const ParameterSet& parameters, const Progress& progress) const override;
    void decide(FrameContext& frame, const NoStructure& structure, ViewState& state,
                const ParameterSet& parameters) const override;
    [[nodiscard]] Promise promiseOf(const NoStructure& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Exact;
    }
    [[nodiscard]] StructureSnapshot snapshotOf(const NoStructure& structure, const FrameLog& log) const override;

    /// Makes the picture, and says how where the frame is recorded.
    [[nodiscard]] virtual RasterPicture rasterise(FrameContext& frame, const SceneOnRaster& raster, bool parallel,
                                                  const Progress& progress) const = 0;
    /// The lines of the listing at which an object's triangles come to the raster, and at which they are shown.
    struct ObjectLines {
        uint8_t triangles, shown;
    };
    [[nodiscard]] virtual ObjectLines objectLines() const = 0;

private:
    void sayTriangles(FrameContext& frame, const std::vector<uint8_t>& fates) const;
    void end(FrameContext& frame, const std::vector<uint8_t>& fates) const;
};

}  // namespace cullscope::software
