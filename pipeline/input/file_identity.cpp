#include "pipeline/input/file_identity.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include "base/text/error.h"
#include "pipeline/run/read_file.h"

namespace vantage {

FileIdentity identify(const std::filesystem::path& file) { return identify(read_file(file)); }

std::string stamp_of(const std::filesystem::path& file) {
    struct stat st {};
    if (::stat(file.c_str(), &st) != 0) return {};
    return fmt::format("{:x}:{:x}:{:x}:{:x}.{:x}:{:x}.{:x}", st.st_dev, st.st_ino, st.st_size,
                       st.st_mtim.tv_sec, st.st_mtim.tv_nsec, st.st_ctim.tv_sec, st.st_ctim.tv_nsec);
}

StampedFile stamped(const std::filesystem::path& file) { return {file, stamp_of(file)}; }

void expect_unchanged(const StampedFile& file) {
    if (!file.stamp.empty() && stamp_of(file.file) != file.stamp)
        throw Error(Exit::input, file.file.string() + ": changed while it was being prepared; run again");
}

}  // namespace vantage
