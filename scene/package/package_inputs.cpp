#include "scene/package/package_inputs.h"

#include <nlohmann/json.hpp>

#include "base/text/json_text.h"

namespace vantage {
namespace {

using nlohmann::json;

/// Adds every object {"bytes": ..., "xxh3": ...} in META's list of inputs.
void add_identities(const json& value, std::vector<FileIdentity>& out) {
    if (value.is_object() && value.contains("bytes") && value.contains("xxh3")) {
        const json &bytes = value["bytes"], &checksum = value["xxh3"];
        if (bytes.is_number_unsigned() && checksum.is_number_unsigned())
            out.push_back({bytes.get<std::uint64_t>(), checksum.get<std::uint64_t>()});
    }
    if (value.is_structured())
        for (const json& part : value) add_identities(part, out);
}

}  // namespace

Inputs inputs_of(const PackageReader& package) {
    Inputs inputs{{package.path()}, {}};
    for (const package::PhotoRecord& p : package.photos())
        if (p.source_bytes) inputs.contents.push_back({p.source_bytes, p.source_checksum});
    const json meta = json_of(package.meta());
    if (!meta.is_object()) return inputs;
    for (const char* list : {"inputs", "skipped"})
        if (meta.contains(list)) add_identities(meta[list], inputs.contents);
    return inputs;
}

}  // namespace vantage
