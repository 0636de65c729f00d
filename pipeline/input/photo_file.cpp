#include "pipeline/input/photo_file.h"

#include <tuple>

#include "base/text/error.h"

namespace vantage {

PhotoFile::PhotoFile(IdentityCache& identities, const std::filesystem::path& file)
    : identities_(identities), file_(file) {
    if (const auto known = identities.known(file))
        identity_ = *known;
    else
        read();
}

std::span<const std::byte> PhotoFile::bytes() {
    const FileIdentity before = identity_;
    if (bytes_.empty()) read();
    if (!(identity_ == before))
        throw Error(Exit::input, file_.string() + ": changed while it was being prepared; run again");
    return bytes_;
}

void PhotoFile::read() { std::tie(bytes_, identity_) = identities_.read(file_); }

}  // namespace vantage
