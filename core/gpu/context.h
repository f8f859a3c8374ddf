#pragma once

#include <memory>
#include <string>

namespace cullscope {

/// What the current OpenGL context reports about itself.
struct GlInfo {
    std::string renderer;
    std::string version;
    int major = 0;
    int minor = 0;
    bool compatibilityProfile = false;  ///< client vertex arrays and GL_SELECT exist only there
    bool software = false;              ///< llvmpipe, softpipe, SWR, …: its times do not represent a GPU
};

/// Reads and checks the current context. Throws Error(OpenGl) where none is current or its version is below 4.5.
[[nodiscard]] GlInfo requireOpenGl45();

/// Whether a HeadlessContext is current on this thread.
[[nodiscard]] bool hasCurrentContext();

/// Whether the current context was lost, as by a driver's reset. OpenGL reports that only for contexts made with reset
/// notification. Needs a current context of OpenGL 4.5.
[[nodiscard]] bool contextLost();

/// An OpenGL 4.5 context on EGL without a display: the surfaceless platform (Mesa), else the first device that gives one
/// (NVIDIA). Compatibility profile where the driver has one. Current on the creating thread from construction on. Throws
/// Error(OpenGl) saying what was tried.
class HeadlessContext {
public:
    HeadlessContext();
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

    [[nodiscard]] const GlInfo& info() const;
    /// "surfaceless" or "device".
    [[nodiscard]] const std::string& platform() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> m_implementation;
};

}  // namespace cullscope
