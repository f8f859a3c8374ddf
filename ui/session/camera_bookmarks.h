#pragma once

#include <QObject>
#include <array>
#include <optional>

#include "ui/session/session.h"

namespace cullscope::ui {

/// A camera that the user stored, and the name that was given to it; empty: none.
struct CameraBookmark : Camera {
    CameraBookmark() = default;
    CameraBookmark(const Camera& camera, std::string called = {}) : Camera(camera), name(std::move(called)) {}

    std::string name;

    bool operator==(const CameraBookmark&) const = default;
};

/// Cameras that the user stores, numbered from 0. They are kept when another scene is opened, so that variants of a model can be
/// compared from the same cameras.
class CameraBookmarks : public QObject {
    Q_OBJECT

public:
    static constexpr int kCount = 4;
    using Places = std::array<std::optional<CameraBookmark>, kCount>;

    using QObject::QObject;

    [[nodiscard]] const Places& places() const { return m_places; }
    void setPlaces(const Places& places);

    /// Stores the viewing camera of the active view.
    void store(int place, const Session& session);
    /// Names a stored camera; does nothing where the place is empty.
    void name(int place, const std::string& name);
    /// Sets the viewing camera of the active view. Returns false if the place is empty or no scene is open.
    bool recall(int place, Session& session) const;

signals:
    void changed();

private:
    Places m_places;
};

}  // namespace cullscope::ui
