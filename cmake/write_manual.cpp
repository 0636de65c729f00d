// Writes the manual pages and the bash and zsh completions of programs to the folders man1, bash and zsh in
// FOLDER. Each FILE contains the line that a program prints with --describe.
#include <fstream>
#include <iostream>

#include "base/cli/bash_completion.h"
#include "base/cli/man_page.h"
#include "base/cli/report_exception.h"
#include "base/cli/zsh_completion.h"
#include "base/files/make_folder.h"
#include "base/text/error.h"

namespace {

using namespace vantage;
namespace fs = std::filesystem;

DescribedCommand read_program(const fs::path& file) {
    std::ifstream in(file);
    std::string line;
    if (!std::getline(in, line)) throw Error(Exit::input, file.string() + ": describes no program");
    return from_line(line);
}

void write(const fs::path& file, const std::string& text) {
    make_folder(file.parent_path());
    if (!(std::ofstream(file) << text).flush())
        throw Error(Exit::storage, file.string() + ": cannot be written");
}

int run(int argc, char** argv) {
    if (argc < 4) throw Error(Exit::usage, "expected VERSION FOLDER FILE...");
    const fs::path folder = argv[2];
    std::vector<DescribedCommand> programs;
    for (int i = 3; i < argc; ++i) programs.push_back(read_program(argv[i]));
    for (const ManPage& page : man_pages(programs, argv[1]))
        write(folder / "man1" / (page.name + ".1"), page.text);
    for (const DescribedCommand& p : programs) {
        write(folder / "bash" / p.name, bash_completion(p));
        write(folder / "zsh" / ("_" + p.name), zsh_completion(p));
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (...) {
        return report_exception("vantage-manual");
    }
}
