#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/text/error.h"
#include "tests/real_inputs/scan.h"

namespace vantage::real_inputs {

/// The command of most rows. {scan} is the scan's folder, and {out} is a path in an empty folder. Commands
/// are separated by ';' and words by spaces.
inline constexpr const char* prepare_command = "vantage prepare {scan} -o {out}.vantage --no-report";
/// The content of the packages of most rows: each photo with its color, and the mesh.
inline constexpr const char* whole_package = "A.jpg=red B.jpg=green C.jpg=blue; 2 x 2 x 2, area 24";

using Parts = std::vector<std::string>;
struct Says : Parts {  ///< texts that the output of the last command must contain
    using Parts::Parts;
};
struct Never : Parts {  ///< texts that the output of the last command must not contain
    using Parts::Parts;
};
struct Holds : Parts {  ///< texts that the package's description must contain; not checked if empty
    using Parts::Parts;
};
struct Command {
    std::string words;
};

/// One realistic input and its expected outcome. The parts after `make` are Exit, Says, Holds, Command and
/// Never, in any order. Absent parts have the values of a scan that is prepared successfully.
struct Row {
    std::string family;
    std::string what;  ///< description of the case, unique within the family
    std::function<void(Scan&)> make;
    Exit exit = Exit::ok;  ///< exit code of the last command
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

// The rows, grouped by family. Add a row for each new case.
std::vector<Row> scan_rows();
std::vector<Row> photo_rows();
std::vector<Row> command_rows();

/// All rows, grouped by family.
std::span<const Row> table();

}  // namespace vantage::real_inputs
