#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/text/error.h"

namespace vantage::ply {

enum class Type { i8, u8, i16, u16, i32, u32, f32, f64 };

inline std::size_t size_of(Type type) {
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[int(type)];
}

inline bool is_real(Type type) { return type == Type::f32 || type == Type::f64; }

struct Property {
    std::string name;
    Type type;
    bool list = false;
    Type count_type = Type::u8;
};

struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
};

enum class Format { text, little, big };

struct Ply {
    std::filesystem::path file;
    Format format = Format::text;
    std::vector<Element> elements;
    std::span<const char> body;
    [[noreturn]] void fail(const std::string& expected) const {
        throw Error(Exit::input, file.string() + ": expected " + expected);
    }
};

/// Reads the header at the beginning of a PLY's bytes. `body` of the result is a view of the bytes after the
/// header. Throws Error(input).
Ply read_header(const std::filesystem::path& file, std::span<const char> bytes);

}  // namespace vantage::ply
