#include "tests/bench/measure/scratch_folder.h"

#include <cstdlib>
#include <system_error>

#include "base/text/error.h"

namespace vantage::bench {

ScratchFolder::ScratchFolder() {
    std::error_code none;
    std::string name = (std::filesystem::temp_directory_path(none) / "vantage-bench-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw Error(Exit::storage, name + ": cannot be created");
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace vantage::bench
