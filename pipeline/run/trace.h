#pragma once
#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace vantage {

/// When which thread did what. Thread-safe; a span costs about a microsecond.
class Trace {
  public:
    struct Span {
        const char* what;
        std::string photo;  ///< empty where it is of the whole scene
        unsigned thread;    ///< in the order in which threads first did something
        double begin, end;  ///< s since the trace began
    };

    void add(const char* what, const std::string& photo, double begin, double end);
    double now() const;
    std::vector<Span> spans() const;

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    mutable std::mutex mutex_;
    std::map<std::thread::id, unsigned> threads_;
    std::vector<Span> spans_;
};

/// A span from here to the end of the block; nothing without a trace.
class Traced {
  public:
    Traced(Trace* trace, const char* what, std::string photo = {})
        : trace_(trace), what_(what), photo_(std::move(photo)), begin_(trace ? trace->now() : 0) {}
    ~Traced() {
        if (trace_) trace_->add(what_, photo_, begin_, trace_->now());
    }
    Traced(const Traced&) = delete;
    Traced& operator=(const Traced&) = delete;

  private:
    Trace* trace_;
    const char* what_;
    std::string photo_;
    double begin_;
};

/// Writes the Trace Event Format that chrome://tracing and Perfetto open. Throws Error(storage).
void write_trace(const std::filesystem::path& file, const std::vector<Trace::Span>& spans);

}  // namespace vantage
