#include "ui/models/scene_model.h"

#include <QLocale>
#include <algorithm>
#include <functional>

#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

void SceneModel::setScene(const ScenePointer& scene) {
    beginResetModel();
    m_scene = scene;
    m_kinds.clear();
    if (scene)
        for (const auto& [kind, count] : scene->partCounts()) m_kinds.emplace_back(kind, count);
    std::ranges::stable_sort(m_kinds, std::greater<>(), [](const auto& kind) { return kind.second; });
    endResetModel();
}

int SceneModel::rowCount(const QModelIndex& parent) const {
    if (parent.isValid() || !m_scene) return 0;
    return m_kinds.empty() ? Primitives : RowCount + int(m_kinds.size());
}

QString SceneModel::rowTitle(int row) const {
    //: A kind of primitive below the row of all of them, such as "box".
    return isKind(row) ? tr("– %1").arg(translated(m_kinds[size_t(row - RowCount)].first.c_str())) : title(row);
}

QString SceneModel::title(int row) {
    switch (row) {
        case Name:
            return tr("Name");
        case Triangles:
            return tr("Triangles");
        case Vertices:
            return tr("Vertices");
        case Objects:
            return tr("Objects");
        case Meshes:
            return tr("Different meshes");
        case Size:
            return tr("Size");
        case Memory:
            return tr("Memory");
        case Primitives:
            return tr("Primitives");
        default:
            return {};
    }
}

QString SceneModel::value(int row) const {
    if (isKind(row)) return countText(m_kinds[size_t(row - RowCount)].second);
    switch (row) {
        case Name:
            return QString::fromStdString(m_scene->name());
        case Triangles:
            return countText(m_scene->triangleCount());
        case Vertices: {
            uint64_t count = 0;
            for (const MeshPointer& mesh : m_scene->meshes()) count += mesh->vertexCount();
            return countText(count);
        }
        case Objects:
            return countText(m_scene->instances().size());
        case Meshes:
            return countText(m_scene->meshes().size());
        case Size: {
            if (m_scene->bounds().empty()) return QStringLiteral("0");
            const Vec3 extent = 2.0 * m_scene->bounds().halfExtent();
            const auto text = [](double length) { return QLocale().toString(length, 'g', 4); };
            return QStringLiteral("%1 × %2 × %3").arg(text(extent.x), text(extent.y), text(extent.z));
        }
        case Memory:
            return bytesText(m_scene->bytes());
        case Primitives: {
            uint64_t sum = 0;
            for (const auto& [kind, count] : m_kinds) sum += count;
            return countText(sum);
        }
        default:
            return {};
    }
}

QVariant SceneModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) return {};
    if (role == Qt::DisplayRole) return index.column() == 0 ? rowTitle(index.row()) : value(index.row());
    if (role == Qt::ToolTipRole) return QStringLiteral("%1: %2").arg(rowTitle(index.row()), value(index.row()));
    if (role == Qt::TextAlignmentRole)
        return int(index.column() == 0 ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

void SceneModel::retranslate() {
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, 1), {Qt::DisplayRole, Qt::ToolTipRole});
}

}  // namespace cullscope::ui
