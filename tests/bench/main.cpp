// vantage-bench measures the cost of accuracy in time and bytes.
#include "base/cli/command.h"
#include "base/cli/report_exception.h"
#include "tests/bench/run.h"

int main(int argc, char** argv) {
    using namespace vantage;
    try {
        const Command program("vantage-bench",
                              "Measures what each level of accuracy costs and reports it as an "
                              "HTML page.");
        bench::RunOptions options;
        bench::add_run_options(program, options);
        return program.run({argv + 1, argv + argc});
    } catch (...) {
        return report_exception("vantage-bench");
    }
}
