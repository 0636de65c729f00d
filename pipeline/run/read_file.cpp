#include "pipeline/run/read_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>

#include "base/text/error.h"

namespace vantage {
namespace {

template <class Content>
Content read(const std::filesystem::path& file, std::size_t max_bytes) {
    std::ifstream in(file, std::ios::binary | std::ios::ate);
    if (!in) throw UnreadableFile(file.string() + ": cannot open: " + std::strerror(errno));
    if (std::filesystem::is_directory(file))
        throw Error(Exit::input, file.string() + ": expected a file, found a folder");
    Content content;
    content.resize(std::min(std::size_t(in.tellg()), max_bytes));
    in.seekg(0);
    if (!in.read(reinterpret_cast<char*>(content.data()), std::streamsize(content.size())))
        throw UnreadableFile(file.string() + ": cannot read" +
                             (in.bad() ? std::string(": ") + std::strerror(errno) : ""));
    return content;
}

}  // namespace

std::vector<std::byte> read_file(const std::filesystem::path& file, std::size_t max_bytes) {
    return read<std::vector<std::byte>>(file, max_bytes);
}

std::string read_text(const std::filesystem::path& file) {
    return read<std::string>(file, std::numeric_limits<std::size_t>::max());
}

std::string read_plain_text(const std::filesystem::path& file) {
    std::string text = read_text(file);
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        throw Error(Exit::input, file.string() + ": is UTF-16, expected UTF-8; save it as UTF-8");
    if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
    if (text.find('\n') == text.npos) std::ranges::replace(text, '\r', '\n');  // Mac OS 9 line ends
    return text;
}

}  // namespace vantage
