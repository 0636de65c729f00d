#include "player/measure/bench.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/real_range.h"
#include "gl/context.h"
#include "player/camera_path.h"
#include "player/measure/frame_statistics.h"
#include "player/measure/plot.h"
#include "player/offscreen.h"
#include "player/render/picture.h"
#include "player/render/renderer.h"
#include "player/shots.h"
#include "scene/error.h"
#include "scene/make_folder.h"

namespace vantage {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double frame_seconds = 1.0 / 30;  // on the paths' own clock

struct ProcessMemory {
    std::uint64_t resident, anonymous;  ///< bytes; what no file holds is of it
};

struct FrameRecord {
    double ms;
    FrameReport report;
    std::uint64_t graphics;  ///< bytes of OpenGL objects
    ProcessMemory process;
};

/// A path flown once.
struct Flight {
    std::string path, mode;
    int repeat;
    std::vector<FrameRecord> frames;
    std::uint64_t bytes_read = 0, graphics_budget = 0;
    // After a jump only.
    int frames_to_exact = -1;
    std::uint64_t jump_bytes = 0, touched_bytes = 0;
};

ProcessMemory process_memory() {
    std::ifstream statm("/proc/self/statm");
    std::uint64_t all = 0, resident = 0, of_files = 0;
    statm >> all >> resident >> of_files;
    const auto page = std::uint64_t(::sysconf(_SC_PAGESIZE));
    return {resident * page, (resident - std::min(resident, of_files)) * page};
}

/// Lets the system forget what it has read of the package.
void drop_from_cache(const PackageReader& package) {
    const int file = ::open(package.path().c_str(), O_RDONLY);
    if (file < 0) return;
    ::posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
    ::close(file);
}

/// Milliseconds of a frame: by the card's own clock, read when it is there; by finishing on a software
/// renderer.
class FrameTimer {
  public:
    explicit FrameTimer(bool software) : software_(software) {
        if (software_) return;
        GLuint id = 0;
        glCreateQueries(GL_TIME_ELAPSED, 1, &id);
        query_ = gl::Query(id);
    }
    void begin() {
        start_ = Clock::now();
        if (!software_) glBeginQuery(GL_TIME_ELAPSED, query_.id());
    }
    double end() {
        if (software_) {
            glFinish();
            return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
        }
        glEndQuery(GL_TIME_ELAPSED);
        const double processor = std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
        GLuint64 ns = 0;
        glGetQueryObjectui64v(query_.id(), GL_QUERY_RESULT, &ns);
        return std::max(processor, double(ns) / 1e6);
    }

  private:
    bool software_;
    gl::Query query_;
    Clock::time_point start_;
};

struct Target {
    gl::Texture color;
    gl::Framebuffer framebuffer;
};

Target make_target(FrameSize size) {
    Target t{gl::make_texture_2d("bench", GL_RGBA8, size.width, size.height), {}};
    t.framebuffer = gl::make_framebuffer("bench", std::array{t.color.id()}, 0);
    return t;
}

CameraPath path_of(const std::string& name, const PackageReader& package, const BenchOptions& o, int repeat) {
    const int frames = o.minutes > 0 ? 1 << 20 : o.frames;
    if (std::filesystem::is_regular_file(name)) return recorded_path(name, package, frames);
    const auto photos = package.photos();
    const std::uint32_t first = o.player.photos.empty() ? std::uint32_t(photos.size() / 2)
                                                        : named_photos(package, o.player.photos).front();
    return scripted_path(name, stand_at(photos[first], mean_up(photos)), frames, unsigned(repeat) + 1);
}

/// Makes resident all that the path needs, as far as there is room.
void preload(Renderer& renderer, const CameraPath& path, FrameSize size, RenderSettings settings,
             const std::vector<std::uint32_t>& photos) {
    settings.complete = true;
    for (const Navigation& n : path.frames)
        renderer.draw(view_of(n, size.width, size.height), settings, photos, {}, 0);
}

/// Whether a frame is among those, evenly spread over the path, that are kept as pictures.
bool pictured(int frame, int frames, int pictures) {
    return std::int64_t(frame) * pictures % frames < pictures;
}

void write_picture(const std::filesystem::path& file, const Target& target, FrameSize size) {
    Picture p{size.width, size.height, {}, {}};
    p.rgba.resize(std::size_t(p.width) * std::size_t(p.height) * 4);
    glGetTextureImage(target.color.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(p.rgba.size()), p.rgba.data());
    write_png(file, p);
}

Flight fly_path(const PackageReader& package, const BenchOptions& o, const CameraPath& path,
                const std::string& mode, int repeat, FrameSize size, const Target& target, bool software) {
    if (!o.warm) drop_from_cache(package);
    const std::vector<std::uint32_t> photos = photos_in_use(package, o.player);
    RenderSettings settings = render_settings(package, o.player);
    settings.fill_holes = true;
    settings.complete = false;
    settings.upload_bytes = std::size_t(o.player.upload_kib) << 10;
    settings.whole_photos = mode == "whole";
    Renderer renderer(package, memory_budget(o.player));
    if (mode == "resident") preload(renderer, path, size, settings, photos);
    Flight flight{path.name, mode, repeat, {}};
    flight.frames.reserve(path.frames.size());
    FrameTimer timer(software);
    const auto begin = Clock::now();
    std::uint64_t before_jump = 0;
    const int jump = path.name == "jump" ? int(path.frames.size()) / 2 : -1;
    for (int i = 0; i < int(path.frames.size()); ++i) {
        if (o.minutes > 0 && Clock::now() - begin > std::chrono::duration<double, std::ratio<60>>(o.minutes))
            break;
        if (i == jump) before_jump = renderer.store().bytes_read();
        const View view = view_of(path.frames[std::size_t(i)], size.width, size.height);
        // Motion goes on as it went: where the view is in a quarter of a second.
        const Navigation ahead =
            i > 0 ? between(path.frames[std::size_t(i) - 1], path.frames[std::size_t(i)], 8) : path.frames[0];
        const View next = view_of(ahead, size.width, size.height);
        timer.begin();
        const FrameReport report = renderer.draw(view, settings, photos, {}, 1 + i * frame_seconds,
                                                 i == 0 || i == jump ? nullptr : &next);
        renderer.show(view, settings, target.framebuffer.id(), false);
        const double ms = timer.end();
        gl::check("drawing a frame");
        ProcessMemory memory = process_memory();
        const std::uint64_t kept = flight.frames.size() * sizeof(FrameRecord);  // by measuring itself
        memory.resident -= kept, memory.anonymous -= kept;
        flight.frames.push_back({ms, report, gl::memory_held(), memory});
        if (repeat == 0 && pictured(i, int(path.frames.size()), o.pictures)) {
            char number[16];
            std::snprintf(number, sizeof number, "-%05d.png", i);
            write_picture(o.folder / (path.name + "-" + mode + number), target, size);
        }
        if (jump >= 0 && i > jump && flight.frames_to_exact < 0 && report.tiles_missing == 0 &&
            report.photos == renderer.plan().photos.size()) {
            flight.frames_to_exact = i - jump;
            flight.jump_bytes = renderer.store().bytes_read() - before_jump;
            flight.touched_bytes = renderer.touched_bytes(view, settings, photos, 1 + i * frame_seconds);
        }
    }
    flight.bytes_read = renderer.store().bytes_read();
    flight.graphics_budget = renderer.graphics_budget();
    return flight;
}

void write_frames(const std::filesystem::path& file, const std::vector<Flight>& flights) {
    std::ofstream out(file);
    out << "path,mode,repeat,frame,ms,uploaded_bytes,tiles,tiles_missing,tiles_damaged,photos,passes,draws,"
           "graphics_bytes,process_bytes,anonymous_bytes\n";
    for (const Flight& f : flights)
        for (std::size_t i = 0; i < f.frames.size(); ++i) {
            const FrameRecord& r = f.frames[i];
            out << f.path << ',' << f.mode << ',' << f.repeat << ',' << i << ',' << r.ms << ','
                << r.report.uploaded << ',' << r.report.tiles << ',' << r.report.tiles_missing << ','
                << r.report.tiles_damaged << ',' << r.report.photos << ',' << r.report.passes << ','
                << r.report.draws << ',' << r.graphics << ',' << r.process.resident << ','
                << r.process.anonymous << '\n';
        }
    if (!out.flush()) throw Error(Exit::storage, file.string() + ": cannot be written");
}

std::vector<double> times(const Flight& f) {
    std::vector<double> ms;
    for (const FrameRecord& r : f.frames) ms.push_back(r.ms);
    return ms;
}

/// All repeats of one path in one mode.
nlohmann::json summarise(const std::vector<const Flight*>& flights, const BenchOptions& o) {
    std::vector<double> all, medians, ratios;
    std::uint64_t uploaded = 0, over = 0, graphics = 0, process = 0, missing = 0, read = 0;
    for (const Flight* f : flights) {
        const std::vector<double> ms = times(*f);
        const FrameStatistics s = frame_statistics(ms);
        all.insert(all.end(), ms.begin(), ms.end());
        medians.push_back(s.median);
        ratios.push_back(s.median > 0 ? s.p999 / s.median : 0);
        read += f->bytes_read;
        for (const FrameRecord& r : f->frames) {
            uploaded = std::max<std::uint64_t>(uploaded, r.report.uploaded);
            over += r.report.uploaded > std::size_t(o.player.upload_kib) << 10;
            graphics = std::max(graphics, r.graphics);
            process = std::max(process, r.process.resident);
            missing += r.report.tiles_missing > 0;
        }
    }
    const FrameStatistics s = frame_statistics(all);
    const auto [low, high] = std::ranges::minmax(medians);
    nlohmann::json out{
        {"path", flights[0]->path},
        {"mode", flights[0]->mode},
        {"repeats", flights.size()},
        {"frames", all.size()},
        {"ms", {{"mean", s.mean}, {"median", s.median}, {"p99", s.p99}, {"p999", s.p999}, {"max", s.max}}},
        {"median_spread", low > 0 ? high / low : 0},
        {"p999_over_median", frame_statistics(ratios).median},
        {"frames_with_tiles_missing", missing},
        {"uploaded_bytes_a_frame_max", uploaded},
        {"upload_budget_bytes", std::uint64_t(o.player.upload_kib) << 10},
        {"frames_over_upload_budget", over},
        {"graphics_bytes_max", graphics},
        {"graphics_budget_bytes", flights.back()->graphics_budget},
        {"process_bytes_max", process},
        {"bytes_read", read / flights.size()}};
    if (const Flight& f = *flights.back(); f.frames_to_exact >= 0) {
        out["frames_to_exact"] = f.frames_to_exact;
        out["bytes_to_exact"] = f.jump_bytes;
        out["bytes_touched"] = f.touched_bytes;
        out["read_over_touched"] = double(f.jump_bytes) / double(std::max<std::uint64_t>(1, f.touched_bytes));
    }
    return out;
}

void print(const nlohmann::json& s) {
    const auto& ms = s["ms"];
    std::printf(
        "%-10s %-9s  mean %7.2f  median %7.2f  99 %% %7.2f  99.9 %% %7.2f  max %7.2f ms  99.9 %%/median %.2f"
        "  %5.1f MiB read  %.1f MiB a frame at most",
        s["path"].get<std::string>().c_str(), s["mode"].get<std::string>().c_str(), ms["mean"].get<double>(),
        ms["median"].get<double>(), ms["p99"].get<double>(), ms["p999"].get<double>(),
        ms["max"].get<double>(), s["p999_over_median"].get<double>(),
        double(s["bytes_read"].get<std::uint64_t>()) / 1048576,
        double(s["uploaded_bytes_a_frame_max"].get<std::uint64_t>()) / 1048576);
    if (s.contains("read_over_touched"))
        std::printf("  exact after %d frames, %.2f bytes read a byte touched",
                    s["frames_to_exact"].get<int>(), s["read_over_touched"].get<double>());
    std::printf("\n");
    std::fflush(stdout);
}

/// Median frame time of a view that stands still, everything resident, over a setting (de Melo 2017, 5.1
/// and 5.2).
int run_sweep(const PackageReader& package, const BenchOptions& o, FrameSize size, const Target& target,
              bool software, const std::filesystem::path& folder) {
    const bool passes = o.sweep == "passes";
    const int all = int(photos_in_use(package, o.player).size());
    std::vector<int> values;
    for (int v = 1; v <= (passes ? most_photos_per_pass : all); v *= 2) values.push_back(v);
    if (!passes && values.back() != all) values.push_back(all);
    std::vector<std::vector<double>> ms(values.size());
    for (int repeat = 0; repeat < o.repeats; ++repeat)
        for (std::size_t i = 0; i < values.size(); ++i) {
            BenchOptions one = o;
            one.warm = true;
            (passes ? one.player.render.photos_per_pass : one.player.photos_blended) = values[i];
            if (passes && o.player.photos_blended < 0) one.player.photos_blended = all;
            const Flight f = fly_path(package, one, path_of("still", package, one, repeat), "resident",
                                      repeat, size, target, software);
            for (const double t : times(f)) ms[i].push_back(t);
        }
    Curve medians{passes ? "photos a pass" : "photos blended", {}};
    std::vector<std::string> labels;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const FrameStatistics s = frame_statistics(ms[i]);
        medians.values.push_back(s.median);
        labels.push_back(std::to_string(values[i]));
        std::printf("%s %2d  median %7.2f ms  99 %% %7.2f ms\n", passes ? "photos a pass" : "photos blended",
                    values[i], s.median, s.p99);
    }
    write_plot(folder / ("sweep-" + o.sweep + ".svg"), "median frame time, " + medians.name, "ms", {medians},
               labels);
    return int(Exit::ok);
}

}  // namespace

void add_bench_options(CLI::App& app, BenchOptions& o) {
    add_options(app, o.player);
    const std::string group = "Bench";
    app.add_option("--paths", o.paths, "still, orbit, approach, jump, flight, or files of views")
        ->delimiter(',')
        ->capture_default_str()
        ->group(group);
    app.add_option(
           "--modes", o.modes,
           "stream: within the budget of uploads a frame; resident: all loaded before; whole: each photo "
           "uploaded whole when it is chosen")
        ->delimiter(',')
        ->check(CLI::IsMember({"stream", "resident", "whole"}))
        ->capture_default_str()
        ->group(group);
    app.add_option("--path-frames", o.frames, "frames a path")
        ->check(CLI::Range(2, 1 << 20))
        ->capture_default_str()
        ->group(group);
    app.add_option("--minutes", o.minutes, "fly each path for so long instead")
        ->check(real_range(0, 1e4))
        ->group(group);
    app.add_option("--repeats", o.repeats, "times each is flown")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str()
        ->group(group);
    app.add_option(
           "--sweep", o.sweep,
           "instead of paths, a view that stands still with 1, 2, 4, ... photos a pass (passes), or photos "
           "blended (photos)")
        ->check(CLI::IsMember({"passes", "photos"}))
        ->group(group);
    app.add_option("--pictures", o.pictures,
                   "frames of each path that are kept as PNG, evenly spread over it")
        ->check(CLI::Range(0, 1 << 20))
        ->group(group);
    app.add_flag("--warm", o.warm, "leave what the system has cached of the package")->group(group);
    app.footer(
        "Writes frames.csv, summary.json and a plot a path into the folder given by -o (default bench).\n"
        "Examples:\n"
        "  vantage-player bench chapel.vantage\n"
        "  vantage-player bench chapel.vantage --paths orbit --modes stream,resident --repeats 5 -o orbit\n"
        "  vantage-player bench chapel.vantage --paths flight --modes stream --minutes 10 --graphics-memory "
        "256");
}

int run_bench(const PackageReader& package, BenchOptions o) {
    const FrameSize size = o.player.size.empty() ? FrameSize{1280, 720} : parse_size(o.player.size);
    if (!o.player.out.empty()) o.folder = o.player.out;
    const std::filesystem::path& folder = o.folder;
    make_folder(folder);
    const gl::HeadlessContext context;
    const bool software = gl::current_device().software;
    const Target target = make_target(size);
    std::printf("%s, %dx%d, %d repeats\n", gl::current_device().renderer.c_str(), size.width, size.height,
                o.repeats);
    std::fflush(stdout);
    if (!o.sweep.empty()) return run_sweep(package, o, size, target, software, folder);
    std::vector<Flight> flights;
    nlohmann::json summaries = nlohmann::json::array();
    for (const std::string& name : o.paths) {
        std::vector<Curve> curves;
        const std::size_t first = flights.size();
        // One after the other in turn, so that a machine that slows down slows all of them.
        for (int repeat = 0; repeat < o.repeats; ++repeat)
            for (const std::string& mode : o.modes)
                flights.push_back(fly_path(package, o, path_of(name, package, o, repeat), mode, repeat, size,
                                           target, software));
        for (const std::string& mode : o.modes) {
            std::vector<const Flight*> same;
            for (std::size_t i = first; i < flights.size(); ++i)
                if (flights[i].mode == mode) same.push_back(&flights[i]);
            summaries.push_back(summarise(same, o));
            print(summaries.back());
            curves.push_back({mode, times(*same.front())});
        }
        const std::string stem = flights[first].path;
        write_plot(folder / (stem + ".svg"), "frame time, " + stem, "ms", curves);
    }
    write_frames(folder / "frames.csv", flights);
    std::ofstream out(folder / "summary.json");
    if (!(out << summaries.dump(1) << "\n").flush())
        throw Error(Exit::storage, (folder / "summary.json").string() + ": cannot be written");
    return int(Exit::ok);
}

}  // namespace vantage
