#include "base/files/replace_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <random>

#include "base/files/descriptor.h"
#include "base/files/flush_to_disk.h"
#include "base/text/error.h"

namespace vantage {
namespace {

std::string reason() { return errno ? std::strerror(errno) : ""; }

}  // namespace

UnfinishedFile::UnfinishedFile(const std::filesystem::path& file, unsigned mode) : file_(file) {
    std::random_device random;  // not the process ID, which repeats in containers and on other machines
    do {
        part_ = file.string() + std::string(unfinished_mark) + std::to_string(random());
        const Descriptor fd(::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
        if (fd) return;
    } while (errno == EEXIST);
    fail(reason());
}

UnfinishedFile::~UnfinishedFile() {
    std::error_code error;
    std::filesystem::remove(part_, error);
}

void UnfinishedFile::finish() const { rename_file(part_, file_); }

void UnfinishedFile::fail(const std::string& why) const {
    throw Error(Exit::storage, file_.string() + ": cannot be written" + (why.empty() ? "" : ": ") + why);
}

void replace_file(const std::filesystem::path& file, std::string_view text, unsigned mode) {
    replace_file(
        file, [&](std::ostream& out) { out << text; }, mode);
}

void replace_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write,
                  unsigned mode) {
    const UnfinishedFile unfinished(file, mode);
    errno = 0;
    {
        std::ofstream out(unfinished.part(), std::ios::binary);
        write(out);
        if (!out.flush()) unfinished.fail(reason());
    }
    const Descriptor written(::open(unfinished.part().c_str(), O_RDONLY | O_CLOEXEC));
    if (!written || ::fsync(written.get()) != 0) unfinished.fail(reason());
    unfinished.finish();
    flush_to_disk(file.parent_path());
}

void rename_file(const std::filesystem::path& from, const std::filesystem::path& to) {
    std::error_code error;
    std::filesystem::rename(from, to, error);
    if (error)
        throw Error(Exit::storage, to.string() + ": cannot rename " + from.filename().string() +
                                       " to it: " + error.message());
}

}  // namespace vantage
