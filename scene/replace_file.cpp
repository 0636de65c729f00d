#include "scene/replace_file.h"

#include <unistd.h>

#include <fstream>

#include "scene/flush_to_disk.h"

namespace vantage {

bool replace_file(const std::filesystem::path& file, const std::string& text) {
    // Of this process: another one may be writing the same file.
    const std::filesystem::path part = file.string() + ".part-" + std::to_string(::getpid());
    std::ofstream out(part, std::ios::binary);
    out << text;
    out.close();
    std::error_code error;
    if (out) {
        flush_to_disk(part);
        std::filesystem::rename(part, file, error);
        if (!error) {
            flush_to_disk(std::filesystem::absolute(file, error).parent_path());
            return true;
        }
    }
    std::filesystem::remove(part, error);
    return false;
}

}  // namespace vantage
