#include "base/files/replace_file.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <fstream>
#include <iterator>

#include "base/text/error.h"
#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

/// Limits the size of files, so that further writes fail, as on a full disk.
class SizeLimit {
  public:
    explicit SizeLimit(rlim_t bytes) : handler_(::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limited{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limited);
    }
    ~SizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        ::signal(SIGXFSZ, handler_);
    }
    SizeLimit(const SizeLimit&) = delete;

  private:
    void (*handler_)(int);
    rlimit before_{};
};

class ReplaceFile : public TemporaryFolder {
  protected:
    const std::filesystem::path file = dir / "report.html";
};

}  // namespace

TEST_F(ReplaceFile, KeepsTheOldFileIfTheDiskIsFull) {
    replace_file(file, "old");
    // The first size exceeds the buffer of a stream, so the data is written immediately. The second is
    // smaller, so the data is written when the stream is flushed.
    for (const std::size_t size : {std::size_t(1) << 20, std::size_t(6000)}) {
        const SizeLimit limit(4096);
        EXPECT_THROW(replace_file(file, std::string(size, 'x')), Error) << size;
        EXPECT_EQ(slurp(file), "old") << size;
        EXPECT_EQ(std::distance(std::filesystem::directory_iterator(dir), {}), 1) << "leftovers of " << size;
    }
    replace_file(file, std::string(6000, 'x'));
    EXPECT_EQ(slurp(file).size(), 6000u);
}
