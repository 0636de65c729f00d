// Inputs as people have them: every row of the table is written to disk, given to the programs, and compared
// with its expected answer. VANTAGE_WRITE_DOCS=1 writes docs/real-inputs.md.
#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <array>
#include <atomic>
#include <chrono>
#include <cstring>
#include <fstream>
#include <map>
#include <mutex>
#include <sstream>
#include <thread>

#include "pipeline/input/file_name.h"
#include "scene/checksum.h"
#include "scene/package_reader.h"
#include "scene/stored_tile.h"
#include "tests/real_inputs/row.h"
#include "tests/temporary_folder.h"

using namespace vantage;
using namespace vantage::real_inputs;
namespace fs = std::filesystem;

namespace {

constexpr auto time_limit = std::chrono::seconds(120);  ///< a run takes a fraction of a second

struct Outcome {
    int status = 0;  ///< of waitpid
    bool hung = false;
    std::string text;  ///< stdout and stderr
    int code() const { return WIFEXITED(status) ? WEXITSTATUS(status) : -1; }
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at; (at = text.find(from)) != text.npos;) text.replace(at, from.size(), to);
    return text;
}

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, at);)
        if (!part.empty()) parts.push_back(part);
    return parts;
}

/// The programs' paths, and the folders of the row; blanks in them stay in one word.
std::vector<std::string> words_of(const std::string& command, const fs::path& folder) {
    std::vector<std::string> words = split(command, ' ');
    for (std::string& word : words) {
        word = replaced(word, "{scan}", (folder / "scan").string());
        word = replaced(word, "{out}", (folder / "out").string());
        if (word == "vantage") word = VANTAGE_PROGRAM;
        if (word == "vantage-player") word = VANTAGE_PLAYER;
    }
    return words;
}

/// Programs write no caches of the user's.
std::vector<std::string> environment_in(const fs::path& folder) {
    std::vector<std::string> all{"XDG_CACHE_HOME=" + (folder / "cache").string()};
    for (char** e = environ; *e; ++e)
        if (!std::string(*e).starts_with("XDG_CACHE_HOME=")) all.push_back(*e);
    return all;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
    std::vector<char*> out;
    for (std::string& w : words) out.push_back(w.data());
    out.push_back(nullptr);
    return out;
}

std::string slurp(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Gives a package the next format version, with a checksum that matches.
void make_newer(const fs::path& file) {
    std::string bytes = slurp(file);
    package::Header header;
    std::memcpy(&header, bytes.data(), sizeof header);
    ++header.version;
    header.header_checksum =
        checksum(std::as_bytes(std::span(&header, 1)).first(offsetof(package::Header, header_checksum)));
    std::memcpy(bytes.data(), &header, sizeof header);
    std::ofstream(file, std::ios::binary) << bytes;
}

Outcome run(const std::string& command, const fs::path& folder) {
    std::vector<std::string> words = words_of(command, folder), environment = environment_in(folder);
    if (words.front() == "vantage-newer") {
        make_newer(words.at(1));
        return {};
    }
    const fs::path log = folder / "log.txt";
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_CREAT | O_WRONLY | O_TRUNC | O_APPEND, 0644);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    pid_t child = 0;
    Outcome outcome;
    const int error = ::posix_spawnp(&child, words.front().c_str(), &actions, nullptr, pointers(words).data(),
                                     pointers(environment).data());
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) return {.status = -1, .hung = false, .text = "cannot start " + words.front()};
    const auto end = std::chrono::steady_clock::now() + time_limit;
    while (::waitpid(child, &outcome.status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() > end) {
            outcome.hung = true;
            ::kill(child, SIGKILL);
            ::waitpid(child, &outcome.status, 0);
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    outcome.text = slurp(log);
    return outcome;
}

/// The name of the strongest channel; "gray(128)" if they are alike; "white".
std::string color_name(const std::array<double, 3>& mean) {
    const auto [least, most] = std::minmax_element(mean.begin(), mean.end());
    if (*least > 250) return "white";
    if (*most - *least < 20) return fmt::format("gray({:.0f})", mean[1]);
    return std::array{"red", "green", "blue"}[std::size_t(most - mean.begin())];
}

std::array<double, 3> mean_color(std::span<const std::byte> rgba) {
    std::array<double, 3> sum{};
    for (std::size_t i = 0; i < rgba.size(); ++i)
        if (i % 4 < 3) sum[i % 4] += 4.0 * std::to_integer<int>(rgba[i]) / double(rgba.size());
    return sum;
}

double surface_area(const PackageReader& package) {
    const auto positions = package.records<Eigen::Vector3f>(package::Type::positions);
    double area = 0;
    for (const auto& t : package.records<std::array<std::uint32_t, 3>>(package::Type::indices)) {
        const Eigen::Vector3f &a = positions[t[0]], &b = positions[t[1]], &c = positions[t[2]];
        area += 0.5 * double((b - a).cross(c - a).norm());
    }
    return area;
}

/// "A.jpg=red -B.jpg; 2 x 2 x 2, area 24, vertices green (51,179,51)": photos with their colors, those
/// without pixels with a minus, the mesh.
std::string describe_package(const fs::path& file) {
    const PackageReader package(file);
    std::string text;
    const auto photos = package.photos();
    for (std::uint32_t i = 0; i < photos.size(); ++i) {
        text += text.empty() ? "" : " ";
        if (photos[i].levels == 0) {
            text += std::string("-") + photos[i].name;
            continue;
        }
        std::vector<std::byte> thumbnail(4 * std::size_t(photos[i].thumbnail_width) *
                                         photos[i].thumbnail_height);
        if (!read_thumbnail(package, i, thumbnail)) return "a thumbnail is damaged";
        const auto mean = mean_color(thumbnail);
        text += fmt::format("{}={}", photos[i].name, color_name(mean));
    }
    const package::SceneRecord& scene = package.scene();
    text += fmt::format("; {:.4g} x {:.4g} x {:.4g}, area {:.4g}", scene.bounds_max[0] - scene.bounds_min[0],
                        scene.bounds_max[1] - scene.bounds_min[1], scene.bounds_max[2] - scene.bounds_min[2],
                        surface_area(package));
    if (const auto* colors = package.find(package::Type::colors)) {
        const auto mean = mean_color(package.bytes(colors));
        text +=
            fmt::format(", vertices {} ({:.0f},{:.0f},{:.0f})", color_name(mean), mean[0], mean[1], mean[2]);
    }
    return text;
}

bool has_package(const Row& row) {
    return (row.exit == Exit::ok || row.exit == Exit::incomplete) && !row.holds.empty();
}

/// What is wrong with a row's outcome, one line each.
std::string flaws_of(const Row& row, const fs::path& folder) {
    Scan scan = standard_scan();
    row.make(scan);
    scan.write(folder / "scan");
    Outcome last;
    for (const std::string& command : split(row.command.words, ';')) {
        last = run(command, folder);
        if (last.hung) return "hangs: " + command;
        if (!WIFEXITED(last.status))
            return fmt::format("ended by signal {}: {}", WTERMSIG(last.status), command);
    }
    std::string flaws;
    if (last.code() != int(row.exit))
        flaws += fmt::format("exit code {}, expected {}\n", last.code(), int(row.exit));
    for (const std::string& part : row.says)
        if (last.text.find(part) == last.text.npos) flaws += fmt::format("does not say '{}'\n", part);
    Parts never{"internal error", "terminate called", "json.exception", "std::", "basic_string"};
    never.insert(never.end(), row.never.begin(), row.never.end());
    for (const std::string& part : never)
        if (last.text.find(part) != last.text.npos) flaws += fmt::format("says '{}'\n", part);
    if (last.text.empty()) flaws += "silent\n";
    if (has_package(row) && last.code() == int(row.exit)) {
        const std::string package = describe_package(folder / "out.vantage");
        for (const std::string& part : row.holds)
            if (package.find(part) == package.npos)
                flaws += fmt::format("the package has '{}', expected '{}'\n", package, part);
    }
    return flaws.empty() ? "" : flaws + "it printed: " + last.text;
}

std::vector<Row> rows_of(const std::string& family) {
    std::vector<Row> rows;
    for (const Row& row : table())
        if (row.family == family) rows.push_back(row);
    return rows;
}

std::vector<std::string> families() {
    std::vector<std::string> names;
    for (const Row& row : table())
        if (names.empty() || names.back() != row.family) names.push_back(row.family);
    return names;
}

class RealInputs : public TemporaryFolder, public ::testing::WithParamInterface<std::string> {};

}  // namespace

TEST_P(RealInputs, GiveTheirExpectedAnswers) {
    const std::vector<Row> rows = rows_of(GetParam());
    const char* only = std::getenv("ROW");
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    const auto work = [&] {
        for (std::size_t i; (i = next++) < rows.size();) {
            if (only && std::string(rows[i].what).find(only) == std::string::npos) continue;
            const fs::path folder = dir / std::to_string(i);
            std::string flaws;
            try {
                flaws = flaws_of(rows[i], folder);
            } catch (const std::exception& e) {
                flaws = e.what();
            }
            std::error_code error;
            fs::remove_all(folder, error);
            const std::scoped_lock lock(mutex);
            if (!flaws.empty()) ADD_FAILURE() << rows[i].family << ": " << rows[i].what << ": " << flaws;
        }
    };
    {
        std::vector<std::jthread> threads;
        for (unsigned t = 0; t < std::max(2u, std::thread::hardware_concurrency()); ++t)
            threads.emplace_back(work);
    }
    std::printf("%s: %zu rows\n", GetParam().c_str(), rows.size());
}

INSTANTIATE_TEST_SUITE_P(Family, RealInputs, ::testing::ValuesIn(families()),
                         [](const auto& family) { return replaced(family.param, " ", "_"); });

namespace {

std::string joined(const Parts& parts) {
    std::string text;
    for (const std::string& p : parts)
        text += fmt::format("{}<code>{}</code>", text.empty() ? "" : " ", utf8_name(p));
    return text;
}

std::string command_text(const Row& row) {
    const std::string full = utf8_name(row.command.words), usual = prepare_command;
    if (full == usual) return "";
    if (full.starts_with(usual)) return "<code>" + full.substr(usual.size() + 1) + "</code>";
    return "<code>" + full + "</code>";
}

std::string document() {
    std::string text = slurp(VANTAGE_SOURCE_DIR "/docs/real-inputs.md");
    constexpr const char* start = "<!-- table -->\n";
    text.erase(text.find(start) + std::string(start).size());
    text += "\n| family | rows |\n|---|---|\n";
    for (const std::string& f : families()) text += fmt::format("| {} | {} |\n", f, rows_of(f).size());
    text += fmt::format("| all | {} |\n", table().size());
    for (const std::string& f : families()) {
        text += fmt::format(
            "\n## {}\n\n| input | command or options | exit | says | package |\n|---|---|---|---|---|\n", f);
        for (const Row& row : rows_of(f))
            text += fmt::format("| {} | {} | {} | {} | {} |\n", row.what, command_text(row), int(row.exit),
                                joined(row.says),
                                !has_package(row)                              ? ""
                                : joined(row.holds) == joined({whole_package}) ? "all"
                                                                               : joined(row.holds));
    }
    return text;
}

}  // namespace

TEST(RealInputsTable, IsDocumented) {
    const fs::path file = VANTAGE_SOURCE_DIR "/docs/real-inputs.md";
    const std::string now = document();
    if (std::getenv("VANTAGE_WRITE_DOCS")) std::ofstream(file, std::ios::binary) << now;
    EXPECT_TRUE(now == slurp(file)) << "VANTAGE_WRITE_DOCS=1 build/tests/real_inputs_tests "
                                       "--gtest_filter=RealInputsTable.* writes it again";
}

TEST(RealInputsTable, HasEachCaseOnce) {
    std::map<std::string, int> count;
    for (const Row& row : table())
        EXPECT_EQ(++count[std::string(row.family) + ": " + row.what], 1) << row.what;
}
