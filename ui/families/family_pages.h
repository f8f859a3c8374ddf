#pragma once

#include <QObject>
#include <QTabWidget>
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
    /// A tab, and its name in the present language.
    [[nodiscard]] virtual QWidget* page() const = 0;
    [[nodiscard]] virtual QString pageName() const = 0;
    /// The tab that the panel shows now.
    virtual void setCurrent(const QWidget* page) = 0;
};

/// The pages of all families, with their widgets: those above the tabs are children of `panel`, the tabs children of `tabs`.
[[nodiscard]] std::vector<FamilyPages*> makeFamilyPages(Session& session, SnapshotReader& reader, QWidget* panel,
                                                        QTabWidget* tabs);

}  // namespace cullscope::ui
