// pace-bench measures frame pacing in motion under simulated loads. Prints a table and draws curves.
#include <cstdio>
#include <string>

#include "player/measure/bench/plot.h"
#include "tests/simulated_pace.h"

namespace {

using namespace vantage;

struct NamedLoad {
    const char* name;
    std::function<double(int)> factor;
};
const NamedLoad loads[] = {{"none", {}}, {"step", step_load}, {"spikes", spike_load}, {"drift", drift_load}};

void print_row(const NamedLoad& load, const PacedMotion& motion, const std::vector<PacedFrame>& frames) {
    double pixels = 0, reduced = 0;
    for (const PacedFrame& f : frames) {
        pixels += f.pace.scale * f.pace.scale;
        reduced += f.pace.reduced;
    }
    const double n = double(frames.size());
    std::printf("| %s | %g | %d | %zu | %d | %.0f %% | %.0f %% | %zu |\n", load.name, motion.machine.full,
                motion.delay, count_missed(frames), longest_missed(frames), 100 * pixels / n,
                100 * reduced / n, count_changes(frames));
}

}  // namespace

int main(int argc, char** argv) {
    constexpr double hertz = 90;
    const std::string folder = argc > 1 ? argv[1] : ".";
    std::printf(
        "%g Hz, 1000 frames, 1 ms of overhead per frame, 4 %% noise\n"
        "| load | ms per full frame | delay, frames | missed | in a row | pixels | reduced | changes |\n"
        "|---|---|---|---|---|---|---|---|\n",
        hertz);
    for (const NamedLoad& load : loads) {
        std::vector<Curve> curves;
        for (const double full : {7.0, 14.0})
            for (const int delay : {0, 1, 2}) {
                const PacedMotion motion{{1, full}, 1000 / hertz, delay, load.factor};
                const std::vector<PacedFrame> frames = paced(motion);
                print_row(load, motion, frames);
                if (delay != 1) continue;
                Curve ms{std::to_string(int(full)) + " ms per full frame", {}},
                    scale{std::to_string(int(full)) + " ms: size, tenths", {}};
                for (const PacedFrame& f : frames) {
                    ms.values.push_back(f.ms);
                    scale.values.push_back(10 * f.pace.scale);
                }
                curves.push_back(std::move(ms));
                curves.push_back(std::move(scale));
            }
        write_plot(folder + "/pace-" + load.name + ".svg", std::string("load: ") + load.name, "ms", curves);
    }
}
