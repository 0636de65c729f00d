#include "pipeline/costs/known_costs.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>

#include "base/files/checksum.h"
#include "base/files/make_folder.h"
#include "base/files/replace_file.h"
#include "base/files/xdg_folder.h"
#include "base/text/error.h"
#include "pipeline/output/meta.h"
#include "pipeline/run/config_files.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

fs::path kept_file(const std::string& key) {
    const fs::path folder = xdg_folder("XDG_CACHE_HOME", ".cache");
    return folder.empty() ? folder : folder / "costs" / (key + ".json");
}

}  // namespace

std::string costs_key(const PackageReader& package) {
    const nlohmann::json inputs = parse_meta(package).value("inputs", nlohmann::json::object());
    nlohmann::json named;
    for (const char* part : {"mesh", "cameras", "points"}) named[part] = inputs.value(part, nlohmann::json());
    const std::string text = named.dump();
    return fmt::format("{:016x}", checksum(std::as_bytes(std::span(text))));
}

double photo_file_bytes(const PackageReader& package) {
    double out = 0;
    for (const package::PhotoRecord& p : package.photos())
        if (!(p.flags & package::photo_held_out)) out += double(p.source_bytes);
    return out;
}

Costs read_costs(const fs::path& file) {
    try {
        Costs out = costs_of(nlohmann::json::parse(std::ifstream(file)));
        if (std::ranges::none_of(out.scans, [](const ScanCosts& s) { return s.trials.empty(); })) return out;
    } catch (const nlohmann::json::exception&) {
    }
    throw Error(Exit::input, file.string() + ": is not a results file of 'vantage costs' (costs.json)");
}

void keep_costs(const Costs& costs) {
    for (const ScanCosts& scan : costs.scans) try {
            const fs::path file = kept_file(scan.key);
            if (file.empty()) return;
            Costs one = costs;
            one.scans = {scan};
            make_folder(file.parent_path());
            replace_file(file, to_json(one).dump());
        } catch (const Error&) {
        }
}

KnownCosts known_costs(const std::string& key) {
    for (const auto& [file, own] :
         {std::pair(kept_file(key), true), std::pair(find_config("costs.json").value_or(""), false)})
        if (fs::is_regular_file(file)) try {
                return {read_costs(file), own};
            } catch (const Error&) {  // written by another version
            }
    return {};
}

}  // namespace vantage
