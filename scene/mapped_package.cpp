#include "scene/mapped_package.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "scene/damaged_package.h"
#include "scene/lost_package.h"
#include "scene/package_format.h"

namespace vantage {
namespace {

class MappedPackage : public PackageSource {
  public:
    explicit MappedPackage(const std::filesystem::path& file) : path_(file) {
        fd_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
        try {
            map();
        } catch (...) {
            if (fd_ >= 0) ::close(fd_);
            throw;
        }
    }
    ~MappedPackage() override {
        withdraw_mapping(bytes_);
        ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
        ::close(fd_);
    }

    const std::filesystem::path& name() const override { return path_; }
    Part bytes() const override { return bytes_; }
    int descriptor() const override { return fd_; }
    Held hold(std::span<const Part>, std::stop_token) override { return {Held(), this}; }
    bool discard(std::span<const Part>) override { return false; }
    std::optional<SourceTraffic> traffic() const override { return {}; }

  private:
    void map() {
        struct stat st {};
        if (fd_ < 0 || ::fstat(fd_, &st) != 0 || !S_ISREG(st.st_mode)) {
            const std::string why = fd_ < 0 ? std::strerror(errno) : "not a regular file";
            throw Error(Exit::input, path_.string() + ": cannot open: " + why);
        }
        ::flock(fd_, LOCK_SH | LOCK_NB);  // fails only while a writer has the file open
        const auto size = std::uint64_t(st.st_size);
        if (size < sizeof(package::Header))
            throw DamagedPackage(Defect::not_a_package, path_.string() + ": not a Vantage package: " +
                                                            std::to_string(size) + " bytes, a header has 64");
        void* p = ::mmap(nullptr, size, PROT_READ, MAP_SHARED, fd_, 0);
        if (p == MAP_FAILED)
            throw Error(errno == ENOMEM ? Exit::memory : Exit::input,
                        path_.string() + ": cannot map: " + std::strerror(errno));
        bytes_ = {static_cast<const std::byte*>(p), size};
        announce_mapping(bytes_, path_.c_str());
    }

    std::filesystem::path path_;
    int fd_ = -1;
    Part bytes_;
};

}  // namespace

std::unique_ptr<PackageSource> mapped_package(const std::filesystem::path& file) {
    return std::make_unique<MappedPackage>(file);
}

}  // namespace vantage
