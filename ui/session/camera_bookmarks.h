#pragma once

#include <QObject>
#include <array>
#include <optional>

#include "ui/session/session.h"

namespace cullscope::ui {

/// Cameras that the user keeps, numbered from 0. They outlive the scene: variants of a model are compared from the same places.
class CameraBookmarks : public QObject {
    Q_OBJECT

public:
    static constexpr int kCount = 4;
    using Places = std::array<std::optional<Camera>, kCount>;

    using QObject::QObject;

    [[nodiscard]] const Places& places() const { return m_places; }
    void setPlaces(const Places& places);

    /// Keeps the camera that the active view looks through.
    void store(int place, const Session& session);
    /// Gives it to the active view. Returns false where the place is empty or no scene is open.
    bool recall(int place, Session& session) const;

signals:
    void changed();

private:
    Places m_places;
};

}  // namespace cullscope::ui
