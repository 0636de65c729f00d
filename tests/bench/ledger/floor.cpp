// Measures a lower bound on the time to prepare photos on this machine: on all cores, decodes every JPEG in a
// folder once and writes as many bytes as the package has. Prints the seconds.
#include <turbojpeg.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

void decode(const std::filesystem::path& file, tjhandle decoder, std::vector<unsigned char>& pixels) {
    std::ifstream in(file, std::ios::binary);
    const std::vector<char> read((std::istreambuf_iterator<char>(in)), {});
    const auto* jpeg = reinterpret_cast<const unsigned char*>(read.data());
    int width = 0, height = 0, sampling = 0, space = 0;
    if (tjDecompressHeader3(decoder, jpeg, read.size(), &width, &height, &sampling, &space)) return;
    pixels.resize(std::size_t(width) * std::size_t(height) * 4);
    tjDecompress2(decoder, jpeg, read.size(), pixels.data(), width, 0, height, TJPF_RGBX, 0);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) return std::fprintf(stderr, "usage: ledger-floor PHOTOS BYTES FILE\n"), 2;
    std::vector<std::filesystem::path> photos;
    for (const auto& entry : std::filesystem::directory_iterator(argv[1])) photos.push_back(entry.path());
    const auto start = Clock::now();
    std::atomic<std::size_t> next = 0;
    std::vector<std::jthread> threads;
    for (unsigned t = 0; t < std::thread::hardware_concurrency(); ++t)
        threads.emplace_back([&] {
            const tjhandle decoder = tjInitDecompress();
            std::vector<unsigned char> pixels;
            for (std::size_t i; (i = next++) < photos.size();) decode(photos[i], decoder, pixels);
            tjDestroy(decoder);
        });
    threads.clear();
    std::vector<char> block(std::size_t{8} << 20, 1);
    std::ofstream out(argv[3], std::ios::binary);
    for (std::size_t left = std::strtoull(argv[2], nullptr, 10), n; left > 0; left -= n)
        out.write(block.data(), std::streamsize(n = std::min(left, block.size())));
    out.close();
    const std::chrono::duration<double> took = Clock::now() - start;
    std::printf("%.4f\n", took.count());
    return out ? 0 : 1;
}
