#pragma once
#include <sys/types.h>

#include <atomic>
#include <filesystem>
#include <string>

#include "base/files/descriptor.h"
#include "base/files/replace_file.h"
#include "player/render/picture.h"

namespace vantage {

/// Whether a video is written to a file of this name: *.mp4 or *.webm. Otherwise the name is that of a folder
/// of frames.
bool is_video_file(const std::filesystem::path& file);

/// The format of a video's frames.
struct VideoFormat {
    int width = 0, height = 0;  ///< even numbers for *.mp4
    double frame_rate = 30;
    bool transparent = false;  ///< for *.webm
};

/// Encodes frames with the program ffmpeg, which it starts: H.264 for *.mp4, VP9 for *.webm. The file gets
/// its final name when it is complete; partial files are removed.
class VideoEncoder {
  public:
    /// Throws Error(usage) if the file type does not support the format, Error(input) if ffmpeg is not
    /// installed.
    VideoEncoder(const std::filesystem::path& file, const VideoFormat& format);
    /// Stops ffmpeg and removes the file, unless finish() was called.
    ~VideoEncoder();
    VideoEncoder(const VideoEncoder&) = delete;
    VideoEncoder& operator=(const VideoEncoder&) = delete;

    /// Throws Error(storage) with the last line of ffmpeg's output if ffmpeg has failed, Error(interrupted)
    /// once `stop` is set.
    void write(const Picture& frame, const std::atomic<bool>& stop);
    /// Waits until the video is complete, and renames it. Throws the errors of write().
    void finish(const std::atomic<bool>& stop);

  private:
    void start();
    int wait();
    [[noreturn]] void fail();

    UnfinishedFile file_;
    VideoFormat format_;
    Descriptor frames_, messages_;
    pid_t process_ = -1;
};

}  // namespace vantage
