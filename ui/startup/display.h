#pragma once

#include <memory>

#include "core/base/error.h"
#include "core/gpu/context.h"
#include "ui/startup/application.h"

namespace cullscope::ui {

/// Requirements that are checked before a window is made. The functions throw Error(OpenGl) with one sentence if they are not
/// met.

/// Refuses platforms without a screen or without OpenGL, and a missing display: Qt would abort the process for them.
void requireDisplay();

/// Sets the OpenGL format of all windows and contexts: 4.5, compatibility profile. Call it before the application is made.
void setDefaultSurfaceFormat();

/// Makes the application. If the display cannot be reached, Qt would abort the process; this function ends it with a sentence on
/// standard error and exit status 4 instead.
[[nodiscard]] std::unique_ptr<Application> makeApplication(int& argc, char** argv);

/// Creates a context on an off-screen surface and returns its properties. Throws Error(OpenGl) if that fails.
[[nodiscard]] GlInfo requireOpenGl();

/// Shows a sentence in a message box if standard error is no terminal, as after a start from a desktop menu. The box closes by
/// itself.
void showWithoutTerminal(const Error& error);

}  // namespace cullscope::ui
