#pragma once
#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace vantage {

/// A record of each thread's work over time. Thread-safe; recording a span takes about a microsecond.
class Trace {
  public:
    struct Span {
        const char* what;
        std::string photo;  ///< empty if the work concerns the whole scene
        unsigned thread;    ///< threads are numbered in the order of their first spans
        double begin, end;  ///< seconds since the trace was created
    };

    /// `what` must be a string literal: only the pointer is kept.
    void add(const char* what, const std::string& photo, double begin, double end);
    /// Seconds since the trace was created.
    double now() const;
    std::vector<Span> spans() const;

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    mutable std::mutex mutex_;
    std::map<std::thread::id, unsigned> threads_;
    std::vector<Span> spans_;
};

/// Records the time from its construction to its destruction; does nothing if the trace is null.
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

/// Writes the spans in the Trace Event Format, which chrome://tracing and Perfetto can open. Throws
/// Error(storage).
void write_trace(const std::filesystem::path& file, const std::vector<Trace::Span>& spans);

}  // namespace vantage
