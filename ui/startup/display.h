#pragma once

#include <QApplication>
#include <memory>

#include "core/base/error.h"
#include "core/gpu/context.h"

namespace cullscope::ui {

/// What has to be true before a window can be made. All of these throw Error(OpenGl) with one sentence where it is not.

/// Refuses platforms that have no screen or no OpenGL, and a missing display, before Qt would abort over them.
void requireDisplay();

/// The OpenGL that every window and context of the program asks for: 4.5, compatibility profile. Before the application is made.
void setDefaultSurfaceFormat();

/// Makes the application; where the display cannot be reached, Qt would end the process with a crash:
/// this ends it with a sentence on standard error and exit status 4 instead.
[[nodiscard]] std::unique_ptr<QApplication> makeApplication(int& argc, char** argv);

/// Tries an OpenGL context on an off-screen surface.
[[nodiscard]] GlInfo requireOpenGl();

/// Shows a sentence to somebody who started the program from a desktop and sees no terminal; goes away by itself.
void showWithoutTerminal(const Error& error);

}  // namespace cullscope::ui
