#pragma once

#include <QObject>
#include <vector>

#include "ui/session/snapshot_reader.h"

namespace cullscope::ui {

/// What one family of strategies adds to the panel with the structure of the active view's strategy. Its widgets say themselves
/// when the present strategy has nothing for them.
class FamilyPages : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// A widget above the panel's tabs.
    [[nodiscard]] virtual QWidget* top() const = 0;
    /// The part of the object whose curve the panel shows now, from 1 (core/frame/curve.h); none: there is none.
    virtual void setPart(const std::optional<uint32_t>& part) = 0;
};

/// The pages of all families, with their widgets: children of `panel`.
[[nodiscard]] std::vector<FamilyPages*> makeFamilyPages(Session& session, SnapshotReader& reader, QWidget* panel);

}  // namespace cullscope::ui
