#include "scene/agreement/shared_discs.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace vantage {
namespace {

constexpr std::size_t min_samples = 30;
constexpr std::size_t max_samples = std::size_t(1) << 20;  ///< total number over all photos

SharedDiscs shared(Samples samples, const std::vector<bool>& use) {
    SharedDiscs out;
    std::size_t discs = 0;
    for (const auto& s : samples) discs = std::max(discs, s.size());
    for (std::size_t d = 0; d < discs; ++d) {
        const std::size_t start = out.all.size();
        for (std::uint32_t i = 0; i < samples.size(); ++i) {
            if (!use[i] || d >= samples[i].size() || samples[i][d].linear[0] == 0) continue;
            const package::SampleRecord& s = samples[i][d];
            const float r = float(s.radius) / 65535;
            Observation o{i, {}, r * r};
            for (int c = 0; c < 3; ++c) o.ln[c] = std::log(float(std::max<std::uint16_t>(s.linear[c], 1)));
            out.all.push_back(o);
        }
        if (out.all.size() - start < 2)
            out.all.resize(start);
        else
            out.first.push_back(start);
    }
    out.first.push_back(out.all.size());
    return out;
}

std::vector<std::size_t> counted(const SharedDiscs& obs, std::size_t photos) {
    std::vector<std::size_t> count(photos, 0);
    for (const Observation& o : obs.all) ++count[o.photo];
    return count;
}

}  // namespace

std::vector<std::span<const package::SampleRecord>> PhotoSamples::spans() const {
    return {of_photo.begin(), of_photo.end()};
}

SharedDiscs shared_discs(Samples samples, std::vector<std::size_t>& count) {
    std::vector<bool> use(samples.size(), true);
    for (;;) {
        SharedDiscs obs = shared(samples, use);
        count = counted(obs, samples.size());
        bool stable = true;  // dropping a photo reduces the counts of others
        for (std::size_t i = 0; i < use.size(); ++i)
            if (use[i] && count[i] < min_samples) use[i] = stable = false;
        if (stable) return obs;
    }
}

std::vector<std::uint32_t> components(const SharedDiscs& obs, std::size_t photos) {
    std::vector<std::uint32_t> of(photos);
    std::iota(of.begin(), of.end(), 0u);
    const auto root = [&](std::uint32_t i) {
        while (of[i] != i) i = of[i] = of[of[i]];
        return i;
    };
    obs.each_disc([&](std::span<const Observation> disc, std::size_t) {
        for (const Observation& o : disc) {
            const std::uint32_t a = root(disc.front().photo), b = root(o.photo);
            of[std::max(a, b)] = std::min(a, b);
        }
    });
    for (std::uint32_t i = 0; i < photos; ++i) of[i] = root(i);
    return of;
}

PhotoSamples thinned(Samples samples, std::size_t step) {
    PhotoSamples out;
    out.step = step;
    for (const auto& s : samples) {
        auto& kept = out.of_photo.emplace_back();
        for (std::size_t d = 0; d < s.size(); d += step) kept.push_back(s[d]);
    }
    return out;
}

PhotoSamples samples_to_fit(Samples samples) {
    constexpr std::size_t most = 8192;  // discs
    std::size_t shown_discs = 0;
    for (const auto& s : samples) shown_discs += std::size_t(std::ranges::count_if(s, shown));
    return thinned(samples, 1 + shown_discs / most);
}

PhotoSamples read_samples(std::span<const package::PhotoRecord> photos,
                          const std::function<std::vector<std::byte>(std::uint32_t photo)>& read) {
    PhotoSamples out;
    out.step = 1 + photos.size() * package::surface_discs / max_samples;
    out.of_photo.resize(photos.size());
    for (std::uint32_t i = 0; i < photos.size(); ++i) {
        if (photos[i].levels == 0) continue;
        const std::vector<std::byte> bytes = read(i);
        const std::size_t discs = bytes.size() / sizeof(package::SampleRecord);
        auto& samples = out.of_photo[i];
        samples.resize((discs + out.step - 1) / out.step);
        for (std::size_t d = 0; d < samples.size(); ++d)
            std::memcpy(&samples[d], &bytes[d * out.step * sizeof(package::SampleRecord)], sizeof samples[d]);
    }
    return out;
}

}  // namespace vantage
