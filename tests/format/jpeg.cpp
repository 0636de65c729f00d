#include "jpeg.h"

#include <algorithm>
#include <csetjmp>
#include <cstdio>  // must precede jpeglib.h, which requires it
#include <stdexcept>
#include <string>

#include "jpeglib.h"

namespace independent {

namespace {

uint64_t read_big_endian(Bytes bytes, size_t offset) {
    const Bytes field = slice(bytes, offset, 2);
    return uint64_t{field[0]} << 8 | field[1];
}

void read_frame_header(Bytes bytes, size_t at, JpegHeader& header) {
    header.size_at = at + 5;
    header.size = {read_big_endian(bytes, at + 7), read_big_endian(bytes, at + 5)};
    const size_t components = slice(bytes, at + 9, 1)[0];
    if (components == 1) return;  // an MCU is then one block, whatever the sampling factors
    for (size_t i = 0; i < components; ++i) {
        const uint64_t sampling = slice(bytes, at + 10 + 3 * i, 3)[1];
        header.mcu = {std::max(header.mcu.w, 8 * (sampling >> 4)),
                      std::max(header.mcu.h, 8 * (sampling & 15))};
    }
}

}  // namespace

JpegHeader read_jpeg_header(Bytes bytes) {
    JpegHeader header;
    uint64_t marker = 0;
    for (size_t at = 2; at < bytes.size();) {
        require(marker != 0xffda, "a JPEG's header does not end with its scan header");
        marker = read_big_endian(bytes, at);
        const uint64_t length = read_big_endian(bytes, at + 2);
        require(marker >= 0xff01 && length >= 2, "a JPEG's header is damaged");
        slice(bytes, at + 2, length);
        if (marker == 0xffc0) read_frame_header(bytes, at, header);
        if (marker == 0xffdd) header.interval = read_big_endian(bytes, at + 4);
        at += 2 + length;
    }
    require(header.size_at > 0 && marker == 0xffda, "a JPEG's header is incomplete");
    return header;
}

Buffer with_size(Bytes shared, const JpegHeader& header, Size size) {
    require(size.w <= 65535 && size.h <= 65535, "too large for a JPEG");
    Buffer file(shared.begin(), shared.end());
    for (size_t i = 0; i < 4; ++i)
        file[header.size_at + i] = static_cast<uint8_t>((i < 2 ? size.h : size.w) >> (i % 2 == 0 ? 8 : 0));
    return file;
}

namespace {

struct JpegDecoder {
    jpeg_decompress_struct info = {};
    jpeg_error_mgr errors = {};
    std::jmp_buf failed = {};
};

void fail(j_common_ptr info) { std::longjmp(static_cast<JpegDecoder*>(info->client_data)->failed, 1); }

void count_warning(j_common_ptr info, int level) { info->err->num_warnings += level < 0; }

// This function owns no resources, because longjmp runs no destructors.
bool decode_rows(JpegDecoder& decoder, Bytes file, Size size, uint8_t* rgb) {
    jpeg_decompress_struct& info = decoder.info;
    if (setjmp(decoder.failed)) return false;
    jpeg_create_decompress(&info);
    jpeg_mem_src(&info, file.data(), static_cast<unsigned long>(file.size()));
    jpeg_read_header(&info, TRUE);
    if (info.image_width != size.w || info.image_height != size.h) return false;
    info.out_color_space = JCS_RGB;
    info.dct_method = JDCT_ISLOW;
    jpeg_start_decompress(&info);
    while (info.output_scanline < info.output_height) {
        JSAMPROW row = rgb + 3 * size.w * info.output_scanline;
        jpeg_read_scanlines(&info, &row, 1);
    }
    jpeg_finish_decompress(&info);
    return decoder.errors.num_warnings == 0;
}

}  // namespace

Buffer decode_jpeg(Bytes file, Size size, Area area) {
    require(area.x + area.w <= size.w && area.y + area.h <= size.h, "an area lies outside its JPEG");
    Buffer rgb(3 * size.w * size.h);
    JpegDecoder decoder;
    decoder.info.err = jpeg_std_error(&decoder.errors);
    decoder.info.client_data = &decoder;
    decoder.errors.error_exit = fail;
    decoder.errors.emit_message = count_warning;
    const bool decoded = decode_rows(decoder, file, size, rgb.data());
    jpeg_destroy_decompress(&decoder.info);
    require(decoded, "a JPEG is damaged");

    Buffer rgba(4 * area.w * area.h, 255);
    for (uint64_t i = 0; i < area.w * area.h; ++i)
        std::copy_n(&rgb[3 * ((area.y + i / area.w) * size.w + area.x + i % area.w)], 3, &rgba[4 * i]);
    return rgba;
}

}  // namespace independent
