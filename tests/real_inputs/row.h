#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/text/error.h"
#include "tests/real_inputs/scan.h"

namespace vantage::real_inputs {

/// The command of most rows. {scan} is the scan's folder, {out} a path in an empty folder; commands are
/// separated by ';' and words by blanks.
inline constexpr const char* prepare_command = "vantage prepare {scan} -o {out}.vantage --no-report";
/// The content of most rows' packages: each photo with its color, and the mesh.
inline constexpr const char* whole_package = "A.jpg=red B.jpg=green C.jpg=blue; 2 x 2 x 2, area 24";

using Parts = std::vector<std::string>;
struct Says : Parts {  ///< parts of what the last command prints
    using Parts::Parts;
};
struct Never : Parts {  ///< parts that the last command must not print
    using Parts::Parts;
};
struct Holds : Parts {  ///< parts of the package's description; empty: the package is not checked
    using Parts::Parts;
};
struct Command {
    std::string words;
};

/// One realistic input, with the expected outcome. The parts after `make` are an Exit, Says, Holds, a Command
/// and Never, in any order; absent parts are those of a scan that is prepared successfully.
struct Row {
    std::string family;
    std::string what;  ///< the case in words, unique in its family
    std::function<void(Scan&)> make;
    Exit exit = Exit::ok;  ///< of the last command
    Says says{};
    Holds holds{whole_package};
    Command command{prepare_command};
    Never never{};

    template <class... Part>
    Row(const char* of, const char* name, std::function<void(Scan&)> change, Part... parts)
        : family(of), what(name), make(std::move(change)) {
        (set(std::move(parts)), ...);
    }

  private:
    void set(Exit e) { exit = e; }
    void set(Says s) { says = std::move(s); }
    void set(Holds h) { holds = std::move(h); }
    void set(Command c) { command = std::move(c); }
    void set(Never n) { never = std::move(n); }
};

// Rows by family: add a row for a new case.
std::vector<Row> scan_rows();
std::vector<Row> photo_rows();
std::vector<Row> command_rows();

/// All rows, family by family.
std::span<const Row> table();

}  // namespace vantage::real_inputs
