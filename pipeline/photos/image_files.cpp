#include "pipeline/photos/image_files.h"

#include <dlfcn.h>

#include "base/text/error.h"

namespace vantage {
namespace {

const ImageFiles& load() {
    std::error_code error;
    const std::filesystem::path program =
        std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    for (const std::filesystem::path& file :
         {program / "libvantage_images.so", program / "../lib/vantage/libvantage_images.so",
          std::filesystem::path(VANTAGE_IMAGES)})
        if (void* library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL))
            if (const void* table = ::dlsym(library, "vantage_image_files"))
                return *static_cast<const ImageFiles*>(table);
    const char* reason = ::dlerror();
    throw Error(Exit::usage, std::string("cannot load libvantage_images.so: ") +
                                 (reason ? reason : "a symbol is missing"));
}

}  // namespace

const ImageFiles& image_files() {
    static const ImageFiles& files = load();
    return files;
}

}  // namespace vantage
