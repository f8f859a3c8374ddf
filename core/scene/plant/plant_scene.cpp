#include "core/scene/plant/plant_scene.h"

#include <algorithm>
#include <cmath>

#include "core/scene/plant/equipment.h"
#include "core/scene/plant/pipeline.h"
#include "core/scene/plant/steel.h"

namespace cullscope {
namespace plant {
namespace {

constexpr uint32_t kPipelinesOfUnit = 20;
constexpr double kStreet = 36.0;   ///< from rack to rack
constexpr double kRowFront = 6.4;  ///< of equipment, from the rack's middle line

/// "L00042"; longer numbers take the places that they need.
std::string numbered(const char* letter, size_t number) {
    const std::string digits = std::to_string(number);
    return letter + std::string(digits.size() < 5 ? 5 - digits.size() : 0, '0') + digits;
}

class Plant {
public:
    explicit Plant(const PlantOptions& options)
        : m_options(options), m_random(options.seed), m_kit(options.chordError), m_fitter(m_kit) {}

    ScenePointer build(std::string name, const Progress& progress) {
        const size_t units = (m_options.pipelines + kPipelinesOfUnit - 1) / kPipelinesOfUnit;
        const auto along = size_t(std::max(1.0, std::nearbyint(std::sqrt(double(units) * kStreet / kUnitLength))));
        for (size_t unit = 0; unit < units; ++unit) {
            progress.check();
            progress.tell(double(unit) / double(units), CULLSCOPE_TR("Generating the plant"));
            addUnit(unit, {double(unit % along) * kUnitLength, double(unit / along) * kStreet, 0.0}, unit % along == 0,
                    std::min<size_t>(kPipelinesOfUnit, m_options.pipelines - unit * kPipelinesOfUnit));
        }
        progress.check();
        return m_kit.finish(std::move(name));
    }

private:
    void addUnit(size_t number, const Vec3& corner, bool first, size_t pipelines) {
        const uint32_t group = m_kit.beginGroup(numbered("U", number + 1));
        addRack(m_kit, corner, first);
        std::vector<Nozzle> nozzles;
        for (const double side : {-1.0, 1.0}) addRow(corner, side, group, nozzles);
        addPipelines(corner, group, nozzles, pipelines);
    }

    /// Fills one side of a rack with equipment. The two sides' nozzles are shifted against each other along x.
    void addRow(const Vec3& corner, double side, uint32_t group, std::vector<Nozzle>& nozzles) {
        uint32_t place = 0;
        while (place < kPlacesOfRow) {
            const EquipmentKind& kind = chosen(kPlacesOfRow - place);
            m_kit.beginGroup(numbered(kind.letter, ++m_items), group);
            const double x = kNozzlePitch * place - 0.25 + (side > 0.0 ? 0.5 : 0.0);
            kind.build(m_kit, m_random, corner + Vec3(x, side * kRowFront, 0.0), -side, nozzles);
            place += kind.places;
        }
    }

    const EquipmentKind& chosen(uint32_t room) {
        uint32_t sum = 0;
        for (const EquipmentKind& kind : equipmentKinds()) sum += kind.places <= room ? kind.chance : 0;
        uint32_t drawn = below(m_random, sum);
        for (const EquipmentKind& kind : equipmentKinds()) {
            if (kind.places > room) continue;
            if (drawn < kind.chance) return kind;
            drawn -= kind.chance;
        }
        return equipmentKinds().front();
    }

    template <typename Value>
    void shuffle(std::vector<Value>& values) {
        for (size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[below(m_random, uint32_t(i))]);
    }

    void addPipelines(const Vec3& corner, uint32_t group, std::vector<Nozzle>& nozzles, size_t pipelines) {
        shuffle(nozzles);
        std::vector<Lane> lanes = lanesOfRack();
        shuffle(lanes);
        for (size_t i = 0; i < pipelines; ++i) {
            const Nozzle one = nozzles.back();
            nozzles.pop_back();
            // The first of the others that is far enough along the rack, or else the farthest.
            constexpr double kFarEnough = 4.0;
            size_t other = 0;
            const auto away = [&](size_t index) { return std::abs(nozzles[index].face.x - one.face.x); };
            for (size_t index = 0; index < nozzles.size() && away(other) < kFarEnough; ++index)
                if (away(index) > away(other)) other = index;
            m_kit.beginGroup(numbered("L", ++m_pipelines), group);
            addPipeline(m_fitter, m_random, corner, one, nozzles[other], lanes);
            nozzles.erase(nozzles.begin() + std::ptrdiff_t(other));
        }
        // Nozzles that no pipeline reaches are left out.
    }

    PlantOptions m_options;
    Random m_random;
    Kit m_kit;
    PipeFitter m_fitter;
    size_t m_items = 0, m_pipelines = 0;
};

}  // namespace
}  // namespace plant

ScenePointer plantScene(std::string name, const PlantOptions& options, const Progress& progress) {
    return plant::Plant(options).build(std::move(name), progress);
}

}  // namespace cullscope
