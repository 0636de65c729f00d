#include "player/pictures/video_encoder.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <sstream>
#include <utility>
#include <vector>

#include "base/text/error.h"
#include "base/text/lower_extension.h"

extern char** environ;

namespace vantage {
namespace {

bool is_mp4(const std::filesystem::path& file) { return lower_extension(file) == ".mp4"; }

/// The arguments of ffmpeg. Identical frames give identical files: the number of threads does not affect
/// the output, and the version and the date are omitted.
std::vector<std::string> arguments(const std::filesystem::path& part, bool mp4, const VideoFormat& f) {
    std::ostringstream rate;
    rate << f.frame_rate;
    std::vector<std::string> out{
        "ffmpeg",      "-hide_banner", "-nostdin",
        "-loglevel",   "error",        "-y",
        "-f",          "rawvideo",     "-pixel_format",
        "rgba",        "-video_size",  std::to_string(f.width) + "x" + std::to_string(f.height),
        "-framerate",  rate.str(),     "-i",
        "pipe:0",      "-vf",          "scale=out_color_matrix=bt709:out_range=tv",
        "-colorspace", "bt709",        "-color_primaries",
        "bt709",       "-color_trc",   "bt709",
        "-fflags",     "+bitexact",    "-flags:v",
        "+bitexact"};
    const std::vector<std::string> h264{"-c:v",    "libx264",   "-crf",       "18", "-pix_fmt",
                                        "yuv420p", "-movflags", "+faststart", "-f", "mp4"};
    const std::vector<std::string> vp9{
        "-c:v", "libvpx-vp9",    "-crf", "24",       "-b:v",
        "0",    "-auto-alt-ref", "0",    "-pix_fmt", f.transparent ? "yuva420p" : "yuv420p",
        "-f",   "webm"};
    const std::vector<std::string>& codec = mp4 ? h264 : vp9;
    out.insert(out.end(), codec.begin(), codec.end());
    out.push_back("file:" + part.string());  // a name may begin with a dash, or hold a colon
    return out;
}

/// Makes a pipe whose ends are not inherited by child processes. Returns {read, write}.
std::pair<Descriptor, Descriptor> make_pipe() {
    int ends[2] = {-1, -1};
    if (::pipe2(ends, O_CLOEXEC) != 0)
        throw Error(Exit::storage, std::string("a pipe to ffmpeg cannot be opened: ") + std::strerror(errno));
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// The last line of a file.
std::string last_line(int fd) {
    std::array<char, 4096> bytes{};
    const off_t length = ::lseek(fd, 0, SEEK_END), from = std::max<off_t>(0, length - off_t(bytes.size()));
    const ssize_t read = ::pread(fd, bytes.data(), bytes.size(), from);
    std::string line, last;
    for (std::istringstream in(std::string(bytes.data(), std::size_t(std::max<ssize_t>(0, read))));
         std::getline(in, line);)
        if (!line.empty()) last = line;
    return last;
}

}  // namespace

bool is_video_file(const std::filesystem::path& file) {
    return is_mp4(file) || lower_extension(file) == ".webm";
}

VideoEncoder::VideoEncoder(const std::filesystem::path& file, const VideoFormat& format)
    : file_(file), format_(format) {
    const auto refuse = [&](const std::string& why) { throw Error(Exit::usage, file.string() + ": " + why); };
    if (is_mp4(file) && (format.width % 2 || format.height % 2))
        refuse("a video of " + std::to_string(format.width) + "x" + std::to_string(format.height) +
               ", expected an even width and height for MP4");
    if (is_mp4(file) && format.transparent)
        refuse("MP4 has no transparency, expected a file *.webm, a folder, or --holes shade");
    start();
}

void VideoEncoder::start() {
    ::signal(SIGPIPE, SIG_IGN);  // if ffmpeg exits early, writing fails instead
    auto [input, frames] = make_pipe();
    messages_ = Descriptor(::memfd_create("ffmpeg messages", MFD_CLOEXEC));
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_adddup2(&files, input.get(), STDIN_FILENO);
    ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&files, messages_.get(), STDERR_FILENO);
    // A separate process group keeps the terminal's Ctrl+C from reaching ffmpeg.
    posix_spawnattr_t attributes;
    ::posix_spawnattr_init(&attributes);
    sigset_t defaults;
    ::sigemptyset(&defaults);
    ::sigaddset(&defaults, SIGPIPE);
    ::posix_spawnattr_setsigdefault(&attributes, &defaults);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    std::vector<std::string> words = arguments(file_.part(), is_mp4(file_.file()), format_);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const int error = ::posix_spawnp(&process_, "ffmpeg", &files, &attributes, argv.data(), environ);
    ::posix_spawn_file_actions_destroy(&files);
    ::posix_spawnattr_destroy(&attributes);
    frames_ = std::move(frames);
    if (error == 0) return;
    process_ = -1;
    throw Error(Exit::input,
                file_.file().string() + ": ffmpeg cannot be started (" + std::strerror(error) +
                    "), expected it to be installed; without it, frames can be written to a folder as PNG");
}

VideoEncoder::~VideoEncoder() {
    if (process_ > 0) {
        ::kill(process_, SIGKILL);
        wait();
    }
}

/// Waits until ffmpeg exits, and returns its status.
int VideoEncoder::wait() {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    return status;
}

void VideoEncoder::fail() {
    const std::string line = last_line(messages_.get());
    throw Error(Exit::storage,
                file_.file().string() + ": ffmpeg failed: " + (line.empty() ? "without a message" : line));
}

void VideoEncoder::write(const Picture& frame, const std::atomic<bool>& stop) {
    for (std::size_t done = 0; done < frame.rgba.size();) {
        if (stop) throw Error(Exit::interrupted, file_.file().string() + ": interrupted, and not written");
        const ssize_t n = ::write(frames_.get(), frame.rgba.data() + done, frame.rgba.size() - done);
        if (n > 0)
            done += std::size_t(n);
        else if (n == 0 || errno != EINTR) {
            wait();  // for its last message
            fail();
        }
    }
}

void VideoEncoder::finish(const std::atomic<bool>& stop) {
    frames_ = Descriptor();
    siginfo_t ended{};
    while (::waitid(P_PID, id_t(process_), &ended, WEXITED | WNOWAIT) < 0 && errno == EINTR)
        if (stop) throw Error(Exit::interrupted, file_.file().string() + ": interrupted, and not written");
    if (const int status = wait(); !WIFEXITED(status) || WEXITSTATUS(status) != 0) fail();
    file_.finish();
}

}  // namespace vantage
