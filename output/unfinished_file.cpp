#include "output/unfinished_file.h"

#include <unistd.h>

#include <system_error>

#include "scene/error.h"

namespace vantage {

UnfinishedFile::UnfinishedFile(const std::filesystem::path& file)
    : file_(file), part_(file.string() + ".part-" + std::to_string(::getpid())) {}

UnfinishedFile::~UnfinishedFile() {
    std::error_code error;
    std::filesystem::remove(part_, error);
}

void UnfinishedFile::finish() const {
    std::error_code error;
    std::filesystem::rename(part_, file_, error);
    if (error) fail(error.message());
}

void UnfinishedFile::fail(const std::string& why) const {
    throw Error(Exit::storage, file_.string() + ": cannot be written" + (why.empty() ? "" : ": ") + why);
}

}  // namespace vantage
