#include "base/files/png_rows.h"

#include <png.h>

#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <string>
#include <utility>

#include "base/files/replace_file.h"

namespace vantage {

struct PngRows::State {
    UnfinishedFile file;
    std::FILE* out = nullptr;
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::string trouble{};

    static void note(png_structp png, png_const_charp message) {
        static_cast<State*>(png_get_error_ptr(png))->trouble = message;
        png_longjmp(png, 1);
    }
    static void ignore(png_structp, png_const_charp) {}

    // Each of these functions returns false if libpng fails. These functions construct no objects, because
    // libpng leaves them with longjmp on an error.
    bool begin(png_uint_32 width, png_uint_32 height, png_textp xmp) {
        if (setjmp(png_jmpbuf(png))) return false;
        png_init_io(png, out);
        png_set_user_limits(png, max_pixels, max_pixels);
        png_set_IHDR(png, info, width, height, 8, PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        // These settings take a sixth of the time of the default level and filters, but files are a sixth
        // larger.
        png_set_compression_level(png, 1);
        png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_PAETH);
        png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
        if (xmp) png_set_text(png, info, xmp, 1);
        png_write_info(png, info);
        return true;
    }
    bool write(png_const_bytep row) {
        if (setjmp(png_jmpbuf(png))) return false;
        png_write_row(png, row);
        return true;
    }
    bool end() {
        if (setjmp(png_jmpbuf(png))) return false;
        png_write_end(png, info);
        return true;
    }
    bool close() {
        const bool closed = std::fclose(std::exchange(out, nullptr)) == 0;
        if (!closed) trouble = std::strerror(errno);
        return closed;
    }
    ~State() {
        png_destroy_write_struct(&png, &info);
        if (out) std::fclose(out);
    }
};

PngRows::PngRows(const std::filesystem::path& file, int width, int height, const std::string& xmp)
    : state_(new State{UnfinishedFile(file)}) {
    State& s = *state_;
    s.out = std::fopen(s.file.part().c_str(), "wb");
    if (!s.out) s.trouble = std::strerror(errno);
    s.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &s, State::note, State::ignore);
    if (s.png) s.info = png_create_info_struct(s.png);
    // The keyword is from Adobe's XMP specification, part 3.
    std::string keyword = "XML:com.adobe.xmp", packet = xmp, none;
    png_text text{};
    text.compression = PNG_ITXT_COMPRESSION_NONE;
    text.key = keyword.data(), text.text = packet.data();
    text.itxt_length = packet.size();
    text.lang = text.lang_key = none.data();
    png_textp metadata = xmp.empty() ? nullptr : &text;
    if (!s.out || !s.info || !s.begin(png_uint_32(width), png_uint_32(height), metadata)) fail();
}

PngRows::~PngRows() = default;

void PngRows::fail() const { state_->file.fail(state_->trouble); }

void PngRows::add(std::span<const std::uint8_t> row) {
    if (!state_->write(row.data())) fail();
}

void PngRows::finish() {
    State& s = *state_;
    if (!s.end() || !s.close()) fail();
    s.file.finish();
}

}  // namespace vantage
