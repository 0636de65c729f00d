#include "base/files/make_folder.h"

#include "base/text/error.h"

namespace vantage {

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error || !std::filesystem::is_directory(folder, error))
        throw Error(Exit::storage, folder.string() + ": cannot create the folder");
}

}  // namespace vantage
