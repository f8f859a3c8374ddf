#include "core/image/picture_formats_module.h"

#include <dlfcn.h>

#include <filesystem>

#include "core/base/error.h"
#include "core/base/filter_program.h"
#include "core/base/memory_limit.h"

namespace cullscope {
namespace {

const PictureFormats& opened() {
    const std::filesystem::path file = ownLibraryFile("picture_formats.so");
    void* const module = dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL);
    void* const function = module == nullptr ? nullptr : dlsym(module, kPictureFormatsFunction);
    if (function == nullptr && memoryIsShort())
        throwInput(
            CULLSCOPE_TR("Pictures cannot be written or read, for want of memory. Close other programs, or allow this one "
                         "more (ulimit -v)."));
    if (function == nullptr)
        throwUsage(CULLSCOPE_TR("%1, which writes and reads pictures, cannot be opened: %2. Install or build Cullscope again."),
                   {file.string(), dlerror()});
    return *reinterpret_cast<PictureFormatsFunction>(function)();
}

}  // namespace

const PictureFormats& pictureFormats() {
    static const PictureFormats& formats = opened();
    return formats;
}

}  // namespace cullscope
