#include "scene/remote/remote_package.h"

#include <memory>
#include <string>
#include <vector>

#include "base/text/is_url.h"
#include "scene/package/lost_package.h"

namespace vantage {
namespace {

/// A package on a server, read with range requests.
class RemotePackage : public PackageSource {
  public:
    RemotePackage(const std::string& url, const RemoteOptions& options, std::stop_token stop)
        : file_(url, options, std::move(stop)), name_(file_.url()), path_(file_.path().string()) {
        announce_mapping(file_.bytes(), path_.c_str());
    }
    ~RemotePackage() override { withdraw_mapping(file_.bytes()); }

    const std::filesystem::path& name() const override { return name_; }
    Part bytes() const override { return file_.bytes(); }
    int descriptor() const override { return -1; }

    Held hold(std::span<const Part> parts, std::stop_token stop) override {
        const std::vector<ByteRange> ranges = ranges_of(parts);
        Held kept = file_.keep(ranges);
        return file_.fetch(ranges, std::move(stop)) ? kept : nullptr;
    }

    bool discard(std::span<const Part> parts) override {
        for (const ByteRange& range : ranges_of(parts)) file_.discard(range);
        return true;
    }

    std::optional<SourceTraffic> traffic() const override {
        const Traffic t = file_.traffic();
        return SourceTraffic{t.bytes_received, t.bytes_from_cache, t.bytes_per_second, file_.offline()};
    }

  private:
    std::vector<ByteRange> ranges_of(std::span<const Part> parts) const {
        std::vector<ByteRange> out;
        for (const Part& part : parts) {
            if (part.empty()) continue;
            const auto begin = std::uint64_t(part.data() - file_.bytes().data());
            out.push_back({begin, begin + part.size()});
        }
        return out;
    }

    RemoteFile file_;
    const std::filesystem::path name_;
    const std::string path_;
};

}  // namespace

PackageReader open_package(const std::filesystem::path& package, const RemoteOptions& options,
                           std::stop_token stop) {
    if (!is_url(package.native())) return PackageReader(package);
    return PackageReader(std::make_unique<RemotePackage>(package.string(), options, std::move(stop)));
}

}  // namespace vantage
