// pace-bench: how the frames of a motion are paced against simulated loads. Prints a table and draws curves.
#include <cstdio>
#include <string>

#include "player/measure/plot.h"
#include "tests/simulated_pace.h"

namespace {

using namespace vantage;

struct NamedLoad {
    const char* name;
    std::function<double(int)> factor;
};
const NamedLoad loads[] = {
    {"none", {}},
    {"step", [](int i) { return i >= 200 && i < 500 ? 2.5 : 1.0; }},
    {"spikes", [](int i) { return i % 150 == 149 ? 4.0 : 1.0; }},
    {"drift",
     [](int i) { return 1 + 2 * std::clamp(i < 500 ? (i - 100) / 400.0 : (900 - i) / 400.0, 0.0, 1.0); }},
};

void print_row(const NamedLoad& load, const PacedMotion& motion, const std::vector<PacedFrame>& frames) {
    std::size_t missed = 0, changes = 0;
    double pixels = 0, swift = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        missed += frames[i].missed;
        changes += i > 0 && frames[i].pace != frames[i - 1].pace;
        pixels += frames[i].pace.scale * frames[i].pace.scale;
        swift += frames[i].pace.swift;
    }
    const double n = double(frames.size());
    std::printf("| %s | %g | %d | %zu | %d | %.0f %% | %.0f %% | %zu |\n", load.name, motion.machine.full,
                motion.delay, missed, longest_missed(frames), 100 * pixels / n, 100 * swift / n, changes);
}

}  // namespace

int main(int argc, char** argv) {
    constexpr double hertz = 90;
    const std::string folder = argc > 1 ? argv[1] : ".";
    std::printf(
        "%g Hz, 1000 frames, 1 ms of its own per frame, 4 %% noise\n"
        "| load | ms per full frame | known late, frames | missed | in a row | pixels | swift | changes |\n"
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
                    scale{"share of the size, x 10", {}};
                for (const PacedFrame& f : frames) {
                    ms.values.push_back(f.ms);
                    scale.values.push_back(10 * f.pace.scale);
                }
                scale.name = std::to_string(int(full)) + " ms: size, tenths";
                curves.push_back(std::move(ms));
                curves.push_back(std::move(scale));
            }
        write_plot(folder + "/pace-" + load.name + ".svg", std::string("load: ") + load.name, "ms", curves);
    }
}
