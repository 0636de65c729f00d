#include "tests/bench/results/log.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "base/text/error.h"

namespace vantage::bench {
namespace {

void append(const std::filesystem::path& file, const nlohmann::json& line) {
    std::ofstream out(file, std::ios::app);
    if (!(out << line.dump() << '\n').flush())
        throw Error(Exit::storage, file.string() + ": cannot be written");
}

}  // namespace

Log::Log(const std::filesystem::path& file, const std::string& run) : file_(file) {
    std::ifstream in(file);
    std::string line;
    std::uintmax_t whole = 0;
    bool same = std::getline(in, line) && !in.eof() &&
                nlohmann::json::parse(line, nullptr, false) == nlohmann::json{{"run", run}};
    if (same) whole = line.size() + 1;
    while (same && std::getline(in, line) && !in.eof()) {
        const nlohmann::json j = nlohmann::json::parse(line, nullptr, false);
        if (!j.is_object()) break;
        for (const auto& m : j.at("measurements")) measurements_.push_back(measurement(m));
        seconds_[j.at("job")] = j.at("seconds");
        whole += line.size() + 1;
    }
    in.close();
    std::error_code error;
    if (same) {
        std::filesystem::resize_file(file, whole, error);
        return;
    }
    std::filesystem::remove(file, error);
    append(file, {{"run", run}});
}

void Log::add(const std::string& job, double seconds, const std::vector<Measurement>& measurements) {
    nlohmann::json list = nlohmann::json::array();
    for (const Measurement& m : measurements) list.push_back(to_json(m));
    append(file_, {{"job", job}, {"seconds", seconds}, {"measurements", list}});
    seconds_[job] = seconds;
    measurements_.insert(measurements_.end(), measurements.begin(), measurements.end());
}

double Log::seconds() const {
    double sum = 0;
    for (const auto& [job, s] : seconds_) sum += s;
    return sum;
}

}  // namespace vantage::bench
