#include "scene/package/mapped_package.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>

#include "base/files/descriptor.h"
#include "base/text/error.h"
#include "scene/package/lost_package.h"

namespace vantage {
namespace {

class MappedPackage : public PackageSource {
  public:
    explicit MappedPackage(const std::filesystem::path& file)
        : path_(file), fd_(::open(path_.c_str(), O_RDONLY | O_CLOEXEC)) {
        struct stat st {};
        if (!fd_ || ::fstat(fd_.get(), &st) != 0 || !S_ISREG(st.st_mode)) {
            const std::string why = fd_ ? "not a regular file" : std::strerror(errno);
            throw Error(Exit::input, path_.string() + ": cannot open: " + why);
        }
        ::flock(fd_.get(), LOCK_SH | LOCK_NB);  // fails only while a writer has the file open
        if (st.st_size > 0) map(std::size_t(st.st_size));
    }
    ~MappedPackage() override {
        if (bytes_.empty()) return;
        withdraw_mapping(bytes_);
        ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
    }

    const std::filesystem::path& name() const override { return path_; }
    Part bytes() const override { return bytes_; }
    int descriptor() const override { return fd_.get(); }
    Held hold(std::span<const Part>, std::stop_token) override { return {Held(), this}; }
    bool discard(std::span<const Part>) override { return false; }
    std::optional<SourceTraffic> traffic() const override { return {}; }

  private:
    void map(std::size_t size) {
        void* p = ::mmap(nullptr, size, PROT_READ, MAP_SHARED, fd_.get(), 0);
        if (p == MAP_FAILED)
            throw Error(errno == ENOMEM ? Exit::memory : Exit::input,
                        path_.string() + ": cannot map: " + std::strerror(errno));
        bytes_ = {static_cast<const std::byte*>(p), size};
        announce_mapping(bytes_, path_.c_str());
    }

    std::filesystem::path path_;
    Descriptor fd_;
    Part bytes_;
};

}  // namespace

std::unique_ptr<PackageSource> mapped_package(const std::filesystem::path& file) {
    return std::make_unique<MappedPackage>(file);
}

}  // namespace vantage
