#include "pipeline/costs/cost_programs.h"

#include <fmt/format.h>

#include <fstream>

#include "base/files/make_folder.h"
#include "base/files/run_child.h"
#include "base/text/error.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

void append(std::vector<std::string>& to, const std::vector<std::string>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

}  // namespace

CostPrograms::CostPrograms(fs::path folder) : folder_(std::move(folder)), player_("vantage-player") {
    make_folder(folder_);
    std::error_code error;
    vantage_ = fs::read_symlink("/proc/self/exe", error);
    for (const fs::path& beside : {vantage_.parent_path(), vantage_.parent_path().parent_path() / "player"})
        if (fs::is_regular_file(beside / "vantage-player")) {
            player_ = beside / "vantage-player";
            break;
        }
}

nlohmann::json CostPrograms::results_of(std::vector<std::string> words) const {
    words.emplace_back("--json");
    const fs::path out = folder_ / "results.json", err = folder_ / "messages.txt";
    const int status = run_child(words, out, err);
    if (status == 127)
        throw Error(Exit::input, words[0] +
                                     ": cannot be started; 'vantage costs' needs vantage-player "
                                     "beside vantage, or in the PATH");
    nlohmann::json found = nlohmann::json::parse(std::ifstream(out), nullptr, false);
    if (status == int(Exit::ok) || status == int(Exit::incomplete)) return found;
    const std::string command = fs::path(words[0]).filename().string() + " " + words[1];
    if (found.is_object() && found.value("error", nlohmann::json()).is_object())
        throw Error(Exit(status), fmt::format("{}: {}", command, found["error"].value("message", "")));
    throw Error(Exit::internal, fmt::format("{} failed with exit code {}", command, status));
}

CostPrograms::Prepared CostPrograms::prepare(const std::string& scan, const fs::path& package,
                                             const std::vector<std::string>& options) const {
    fs::remove(package);
    std::vector<std::string> words{vantage_, "prepare", scan, "-o", package, "--no-report"};
    append(words, options);
    const nlohmann::json found = results_of(words);
    return {found.at("seconds"), found.at("memory_bytes"), found.at("bytes")};
}

std::vector<fs::path> CostPrograms::render(const std::string& package, std::span<const PhotoView> views,
                                           const std::vector<std::string>& options,
                                           const fs::path& folder) const {
    std::vector<fs::path> out;
    make_folder(folder);
    while (!views.empty()) {  // one run for consecutive views of the same size
        const PhotoView& first = views.front();
        std::vector<std::string> words{player_, "render", package, "--photo"};
        std::size_t count = 0;
        for (;
             count < views.size() && views[count].width == first.width && views[count].height == first.height;
             ++count)
            words.push_back(views[count].photo);
        views = views.subspan(count);
        const fs::path to = count == 1 ? folder / (std::to_string(out.size()) + ".png") : folder;
        append(words, {"--size", fmt::format("{}x{}", first.width, first.height), "-o", to, "--force"});
        append(words, options);
        const nlohmann::json found = results_of(words);
        for (const nlohmann::json& picture : found.at("pictures"))
            out.emplace_back(picture.at("file").get<std::string>());
    }
    return out;
}

double CostPrograms::frame_ms(const std::string& package, const std::vector<std::string>& options) const {
    std::vector<std::string> words{player_,    "bench",     package,    "--paths",
                                   "still",    "--modes",   "resident", "--path-frames",
                                   "6",        "--repeats", "1",        "--size",
                                   "1280x720", "--force",   "-o",       (folder_ / "flight").string()};
    append(words, options);
    return results_of(words).at("flights").at(0).at("ms").at("median");
}

}  // namespace vantage
