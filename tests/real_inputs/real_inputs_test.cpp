// Tests realistic inputs: writes each row of the table to disk, runs the programs on it, and compares the
// outcome with the expected one. `vantage` runs in a fork of this process, which saves its startup time. For
// every twentieth row of a family (every fifth in the full set), the program itself is run. Of the rows that
// make a package, every fourth is run; the full set runs all of them. ROW=TEXT runs only the rows whose name
// contains this text. VANTAGE_WRITE_DOCS=1 writes the table to README.md next to this file; the rules are in
// docs/real-inputs.md.
#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <array>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

#include "base/files/checksum.h"
#include "base/text/file_name.h"
#include "pipeline/commands/shared/run_program.h"
#include "pipeline/photos/image_files.h"
#include "scene/package/contents/stored_tile.h"
#include "scene/package/package_reader.h"
#include "tests/real_inputs/row.h"
#include "tests/temporary_folder.h"

using namespace vantage;
using namespace vantage::real_inputs;
namespace fs = std::filesystem;

namespace {

constexpr unsigned seconds_limit = 120;  ///< limit per run; a run normally takes a fraction of a second

/// How `vantage` is run.
enum class Vantage { forked, program };

struct Outcome {
    int status = 0;    ///< of waitpid
    std::string text;  ///< stdout and stderr
    bool hung() const { return WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM; }
    int code() const { return WIFEXITED(status) ? WEXITSTATUS(status) : -1; }
};

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, at);)
        if (!part.empty()) parts.push_back(part);
    return parts;
}

/// Splits a command into words and inserts the paths of programs and of the row's folders. Spaces in these
/// paths do not split words.
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

std::vector<char*> pointers(std::vector<std::string>& words) {
    std::vector<char*> out;
    for (std::string& w : words) out.push_back(w.data());
    out.push_back(nullptr);
    return out;
}

/// Raises a package's format version by one and updates the checksum.
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

/// Runs a command in a child process. Its output goes to the log, the user's caches are not used, and its
/// time is limited.
[[noreturn]] void run_child(std::vector<std::string> words, const fs::path& folder, Vantage how) {
    ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
    ::dup2(::open((folder / "log.txt").c_str(), O_CREAT | O_WRONLY | O_TRUNC | O_APPEND, 0644),
           STDOUT_FILENO);
    ::dup2(STDOUT_FILENO, STDERR_FILENO);
    ::setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
    ::alarm(seconds_limit);
    std::vector<char*> arguments = pointers(words);
    if (how == Vantage::forked && words.front() == VANTAGE_PROGRAM) {
        const int code = run_program(int(words.size()), arguments.data());
        std::fflush(nullptr);
        ::_exit(code);
    }
    ::execvp(arguments.front(), arguments.data());
    std::perror(arguments.front());
    ::_exit(127);
}

Outcome run(const std::string& command, const fs::path& folder, Vantage how) {
    const std::vector<std::string> words = words_of(command, folder);
    if (words.front() == "vantage-newer") {
        make_newer(words.at(1));
        return {};
    }
    const pid_t child = ::fork();
    if (child == 0) run_child(words, folder, how);
    Outcome outcome;
    ::waitpid(child, &outcome.status, 0);
    outcome.text = slurp(folder / "log.txt");
    return outcome;
}

/// The name of the strongest channel; "white", or for example "gray(128)", if all channels are about equal.
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

/// "A.jpg=red -B.jpg; 2 x 2 x 2, area 24, vertices green (51,179,51)": the photos with their colors, or with
/// a minus if they have no pixels, followed by the mesh.
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

/// The flaws in a row's outcome, one per line.
std::string flaws_of(const Row& row, const fs::path& folder, Vantage how) {
    Scan scan = standard_scan();
    row.make(scan);
    scan.write(folder / "scan");
    Outcome last;
    for (const std::string& command : split(row.command.words, ';')) {
        last = run(command, folder, how);
        if (last.hung()) return "hangs: " + command;
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

/// A row that runs in its own process. The process writes the row's flaws to a file.
struct Judged {
    const Row* row;
    fs::path folder;
    pid_t process;

    fs::path flaws_file() const { return fs::path(folder).concat(".flaws"); }
};

Judged begin_row(const Row& row, const fs::path& folder, Vantage how) {
    Judged validated{&row, folder, ::fork()};
    if (validated.process != 0) return validated;
    std::string flaws;
    try {
        flaws = flaws_of(row, folder, how);
    } catch (const std::exception& e) {
        flaws = e.what();
    }
    std::ofstream(validated.flaws_file()) << flaws;
    ::_exit(0);
}

void end_row(const Judged& validated, int status) {
    const std::string flaws =
        status != 0 ? "the test's own process ended abnormally" : slurp(validated.flaws_file());
    EXPECT_EQ(flaws, "") << validated.row->family << ": " << validated.row->what;
    std::error_code error;
    fs::remove_all(validated.folder, error);
}

class RealInputs : public TemporaryFolder, public ::testing::WithParamInterface<std::string> {
  protected:
    /// Makes the resources shared by all rows once, before forking. This must not start threads other than
    /// those of loaded libraries, because they would be missing in the forks.
    static void SetUpTestSuite() {
        const auto threads = [] { return std::distance(fs::directory_iterator("/proc/self/task"), {}); };
        image_files();
        const auto of_libraries = threads();
        standard_scan();
        ASSERT_EQ(threads(), of_libraries);
    }
    /// Runs the rows of a family. One in `whole` rows runs the program itself. Of the rows that make a
    /// package, one in `packages` is run.
    void validate(std::size_t whole, std::size_t packages) const {
        const char* only = std::getenv("ROW");
        std::vector<Row> rows = rows_of(GetParam());
        std::erase_if(rows, [&, i = std::size_t(0)](const Row& row) mutable {
            return only ? row.what.find(only) == std::string::npos : has_package(row) && i++ % packages != 0;
        });
        std::map<pid_t, Judged> running;
        const auto end_one = [&] {
            int status = 0;
            const pid_t ended = ::wait(&status);
            end_row(running.at(ended), status);
            running.erase(ended);
        };
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (running.size() >= std::max(2u, std::thread::hardware_concurrency())) end_one();
            const Judged row = begin_row(rows[i], dir / std::to_string(i),
                                         i % whole == 0 ? Vantage::program : Vantage::forked);
            running.emplace(row.process, row);
        }
        while (!running.empty()) end_one();
        std::printf("%s: %zu rows\n", GetParam().c_str(), rows.size());
    }
};
class RealInputsAtLength : public RealInputs {};

}  // namespace

TEST_P(RealInputs, GiveTheirExpectedAnswers) { validate(20, 4); }
TEST_P(RealInputsAtLength, GiveTheirExpectedAnswers) { validate(5, 1); }

const auto family_name = [](const auto& family) { return replaced(family.param, " ", "_"); };
INSTANTIATE_TEST_SUITE_P(Family, RealInputs, ::testing::ValuesIn(families()), family_name);
INSTANTIATE_TEST_SUITE_P(Family, RealInputsAtLength, ::testing::ValuesIn(families()), family_name);

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
    if (full == usual + " " + row.what) return "";  // the case's name contains the options
    if (full.starts_with(usual)) return "<code>" + full.substr(usual.size() + 1) + "</code>";
    return "<code>" + full + "</code>";
}

std::string document() {
    std::string text = slurp(VANTAGE_SOURCE_DIR "/tests/real_inputs/README.md");
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
    const fs::path file = VANTAGE_SOURCE_DIR "/tests/real_inputs/README.md";
    const std::string now = document();
    if (std::getenv("VANTAGE_WRITE_DOCS")) std::ofstream(file, std::ios::binary) << now;
    EXPECT_TRUE(now == slurp(file)) << "to update the table, run VANTAGE_WRITE_DOCS=1 "
                                       "build/tests/real_inputs_tests --gtest_filter=RealInputsTable.*";
}

TEST(RealInputsTable, HasEachCaseOnce) {
    std::map<std::string, int> count;
    for (const Row& row : table())
        EXPECT_EQ(++count[std::string(row.family) + ": " + row.what], 1) << row.what;
}
