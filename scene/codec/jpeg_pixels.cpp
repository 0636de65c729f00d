#include "scene/codec/jpeg_pixels.h"

#include <turbojpeg.h>

#include <memory>
#include <new>

namespace vantage::codec {
namespace {

struct Destroy {
    void operator()(void* handle) const { tjDestroy(handle); }
};
using Handle = std::unique_ptr<void, Destroy>;

const unsigned char* pixels(std::span<const std::byte> b) {
    return reinterpret_cast<const unsigned char*>(b.data());
}

}  // namespace

std::vector<std::byte> encode_jpeg(std::span<const std::byte> rgba, int width, int height, int quality) {
    thread_local const Handle encoder(tjInitCompress());
    std::vector<std::byte> out(tjBufSize(width, height, TJSAMP_444));
    auto* to = reinterpret_cast<unsigned char*>(out.data());
    unsigned long bytes = out.size();
    if (!encoder || tjCompress2(encoder.get(), pixels(rgba), width, 0, height, TJPF_RGBA, &to, &bytes,
                                TJSAMP_444, quality, TJFLAG_ACCURATEDCT | TJFLAG_NOREALLOC))
        throw std::bad_alloc();  // the only possible error with enough space
    out.resize(bytes);
    return out;
}

bool decode_jpeg(std::span<const std::byte> jpeg, int width, int height, std::span<std::byte> rgba) {
    thread_local const Handle decoder(tjInitDecompress());
    if (!decoder) throw std::bad_alloc();
    int w = 0, h = 0, sampling = 0, space = 0;
    if (tjDecompressHeader3(decoder.get(), pixels(jpeg), jpeg.size(), &w, &h, &sampling, &space) ||
        w != width || h != height || space == TJCS_CMYK || space == TJCS_YCCK)
        return false;
    return tjDecompress2(decoder.get(), pixels(jpeg), jpeg.size(),
                         reinterpret_cast<unsigned char*>(rgba.data()), width, 0, height, TJPF_RGBA,
                         TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS) == 0;
}

}  // namespace vantage::codec
