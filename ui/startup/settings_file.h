#pragma once

namespace cullscope::ui {

/// Call it before the first QSettings. Throws Error(Input) where a file of the settings is a pipe or a device: reading it would
/// wait for a writer that may never come, or never end, and an administrator's settings would take a device's place.
void requireReadableSettings();

}  // namespace cullscope::ui
