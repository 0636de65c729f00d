#include "pipeline/run/trace.h"

#include <nlohmann/json.hpp>

#include "base/files/replace_file.h"
#include "base/text/json_text.h"

namespace vantage {

void Trace::add(const char* what, const std::string& photo, double begin, double end) {
    const std::scoped_lock lock(mutex_);
    const auto thread =
        threads_.try_emplace(std::this_thread::get_id(), unsigned(threads_.size())).first->second;
    spans_.push_back({what, photo, thread, begin, end});
}

double Trace::now() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

std::vector<Trace::Span> Trace::spans() const {
    const std::scoped_lock lock(mutex_);
    return spans_;
}

void write_trace(const std::filesystem::path& file, const std::vector<Trace::Span>& spans) {
    nlohmann::json events = nlohmann::json::array();
    for (const Trace::Span& s : spans)
        events.push_back({{"name", s.what},
                          {"ph", "X"},
                          {"ts", s.begin * 1e6},
                          {"dur", (s.end - s.begin) * 1e6},
                          {"pid", 1},
                          {"tid", s.thread},
                          {"args", {{"photo", s.photo}}}});
    replace_file(file, json_text({{"traceEvents", events}}, -1) + '\n');
}

}  // namespace vantage
