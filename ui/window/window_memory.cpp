#include "ui/window/window_memory.h"

namespace cullscope::ui {

namespace {

/// Incremented when docks or toolbars change their names or their meaning.
constexpr int kVersion = 1;
constexpr const char* kGroup = "window";
constexpr const char* kVersionSetting = "window/version";
constexpr const char* kGeometry = "window/geometry";
constexpr const char* kDocks = "window/docks";
constexpr const char* kArrangement = "window/arrangement";
constexpr const char* kViewCount = "window/view_count";

}  // namespace

WindowMemory::WindowMemory(QMainWindow& window) : m_window(window), m_first(window.saveState(kVersion)) {}

void WindowMemory::save(const Layout& layout) {
    m_settings.setValue(QLatin1String(kVersionSetting), kVersion);
    m_settings.setValue(QLatin1String(kGeometry), m_window.saveGeometry());
    m_settings.setValue(QLatin1String(kDocks), m_window.saveState(kVersion));
    m_settings.setValue(QLatin1String(kArrangement), layout.arrangement);
    m_settings.setValue(QLatin1String(kViewCount), layout.viewCount);
}

std::optional<WindowMemory::Layout> WindowMemory::restore() {
    if (m_settings.value(QLatin1String(kVersionSetting)).toInt() != kVersion) return std::nullopt;
    if (!m_window.restoreGeometry(m_settings.value(QLatin1String(kGeometry)).toByteArray())) return std::nullopt;
    if (!m_window.restoreState(m_settings.value(QLatin1String(kDocks)).toByteArray(), kVersion))
        m_window.restoreState(m_first, kVersion);
    return Layout{m_settings.value(QLatin1String(kArrangement)).toString(), m_settings.value(QLatin1String(kViewCount)).toInt()};
}

void WindowMemory::reset() {
    m_settings.remove(QLatin1String(kGroup));
    m_window.restoreState(m_first, kVersion);
}

}  // namespace cullscope::ui
