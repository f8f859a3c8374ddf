#include "core/gpu/context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/base/memory_limit.h"

namespace cullscope {
namespace {

std::string text(GLenum name) {
    const GLubyte* string = glGetString(name);
    return string == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(string));
}

bool isSoftware(const std::string& renderer) {
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "SWR", "Software"})
        if (renderer.find(name) != std::string::npos) return true;
    return false;
}

/// How many contexts of this process use a display. EGL has one display of a kind a process, and its end is the end of all of its
/// contexts, on whatever thread they are: it comes with the last of them.
class Displays {
public:
    bool begin(EGLDisplay display) {
        const std::lock_guard lock(m_mutex);
        if (!eglInitialize(display, nullptr, nullptr)) return false;
        ++m_users[display];
        return true;
    }
    void end(EGLDisplay display) {
        const std::lock_guard lock(m_mutex);
        if (--m_users[display] == 0) eglTerminate(display);
    }

private:
    std::mutex m_mutex;
    std::map<EGLDisplay, int> m_users;
};

Displays& displays() {
    static Displays all;
    return all;
}

/// One display with its context; destroys both.
struct EglContext {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    std::string platform;

    EglContext() = default;
    EglContext(EglContext&& other) noexcept { swap(other); }
    EglContext& operator=(EglContext&& other) noexcept {
        swap(other);
        return *this;
    }
    ~EglContext() {
        if (display == EGL_NO_DISPLAY) return;
        if (context != EGL_NO_CONTEXT) {
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            eglDestroyContext(display, context);
        }
        displays().end(display);
    }
    void swap(EglContext& other) {
        std::swap(display, other.display);
        std::swap(context, other.context);
        std::swap(platform, other.platform);
    }
};

EGLContext createContext(EGLDisplay display, EGLConfig config) {
    for (const EGLint profile : {EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT}) {
        const std::array<EGLint, 7> attributes{
            EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK, profile, EGL_NONE};
        if (const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
            context != EGL_NO_CONTEXT)
            return context;
    }
    // Any version at all: requireOpenGl45 then reports the version that was found.
    return eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
}

/// Makes a context on a display and makes it current.
std::optional<EglContext> contextOn(EGLDisplay display, const char* platform) {
    EglContext made;
    if (display == EGL_NO_DISPLAY || !displays().begin(display)) return std::nullopt;
    made.display = display;
    made.platform = platform;
    const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(display, wanted.data(), &config, 1, &count) || count < 1)
        return std::nullopt;
    made.context = createContext(display, config);
    if (made.context == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, made.context))
        return std::nullopt;
    return made;
}

std::vector<EGLDeviceEXT> devices() {
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") &&
        !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_base"))
        return {};
    EGLint count = 0;
    if (!eglQueryDevicesEXT(0, nullptr, &count) || count < 1) return {};
    std::vector<EGLDeviceEXT> found(static_cast<size_t>(count));
    eglQueryDevicesEXT(count, found.data(), &count);
    found.resize(static_cast<size_t>(count));
    return found;
}

/// A context on a GPU if one of the platforms has it, else a software one.
std::optional<EglContext> bestContext() {
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base")) return std::nullopt;
    std::optional<EglContext> software;
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        auto made =
            contextOn(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr), "surfaceless");
        if (made && !isSoftware(text(GL_RENDERER))) return made;
        software = std::move(made);
    }
    for (const EGLDeviceEXT device : devices()) {
        auto made = contextOn(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr), "device");
        if (!made) continue;
        if (!isSoftware(text(GL_RENDERER))) return made;
        if (!software) software = std::move(made);
    }
    if (software) eglMakeCurrent(software->display, EGL_NO_SURFACE, EGL_NO_SURFACE, software->context);
    return software;
}

}  // namespace

GlInfo requireOpenGl45() {
    GlInfo info;
    info.version = text(GL_VERSION);
    if (info.version.empty())
        throwOpenGl(CULLSCOPE_TR("There is no OpenGL context here: install a graphics driver with OpenGL 4.5, or Mesa."));
    info.renderer = text(GL_RENDERER);
    glGetIntegerv(GL_MAJOR_VERSION, &info.major);
    glGetIntegerv(GL_MINOR_VERSION, &info.minor);
    if (info.major * 10 + info.minor < 45)
        throwOpenGl(CULLSCOPE_TR("OpenGL 4.5 is needed and this machine has %1 (%2): update the graphics driver, or use Mesa's "
                                 "software OpenGL with LIBGL_ALWAYS_SOFTWARE=1."),
                    {info.version, info.renderer});
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    info.compatibilityProfile = (profile & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) != 0;
    info.software = isSoftware(info.renderer);
    return info;
}

bool hasCurrentContext() { return eglGetCurrentContext() != EGL_NO_CONTEXT; }

bool contextLost() { return glGetGraphicsResetStatus() != GL_NO_ERROR; }

struct HeadlessContext::Implementation {
    EglContext egl;
    GlInfo info;
};

HeadlessContext::HeadlessContext() {
    if (tooFewThreadsForOpenGl())
        throwInput(
            CULLSCOPE_TR("OpenGL cannot be started, for want of threads. Close other programs, or allow this one more "
                         "(ulimit -u)."));
    std::optional<EglContext> made = bestContext();
    if (!made && memoryIsShort())
        throwInput(
            CULLSCOPE_TR("OpenGL cannot be started, for want of memory. Close other programs, or allow this one more "
                         "(ulimit -v)."));
    if (!made)
        throwOpenGl(
            CULLSCOPE_TR("No OpenGL 4.5 context without a display: EGL's surfaceless and device platforms were both tried. "
                         "Install libegl1 with Mesa (libgl1-mesa-dri) or the GPU's driver."));
    m_implementation = std::make_unique<Implementation>();
    m_implementation->egl = std::move(*made);
    m_implementation->info = requireOpenGl45();
}

HeadlessContext::~HeadlessContext() = default;

const GlInfo& HeadlessContext::info() const { return m_implementation->info; }
const std::string& HeadlessContext::platform() const { return m_implementation->egl.platform; }

}  // namespace cullscope
