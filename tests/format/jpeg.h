#pragma once
#include "package_bytes.h"

// JPEG files that are assembled from parts of chunks.
namespace independent {

struct Size {
    uint64_t w, h;
};

struct Area {
    uint64_t x, y, w, h;
};

struct JpegHeader {
    size_t size_at = 0;  // offset of the height in SOF0, followed by the width
    Size size = {0, 0}, mcu = {8, 8};
    uint64_t interval = 0;
};

JpegHeader read_jpeg_header(Bytes bytes);

// Copies a JPEG header and replaces its size.
Buffer with_size(Bytes shared, const JpegHeader& header, Size size);

// Decodes an area of a JPEG to RGBA.
Buffer decode_jpeg(Bytes file, Size size, Area area);

}  // namespace independent
