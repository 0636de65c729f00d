#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vantage {

/// A material's color: sRGB and alpha.
using MaterialColor = std::array<std::uint8_t, 4>;

/// Reads a Wavefront MTL file: the diffuse color of each material (`Kd r g b`, treated as sRGB; default
/// white) and its alpha (`d`, otherwise 1 - `Tr`; default 1), both clamped to [0, 1]. Lines of other kinds
/// are skipped. Unreadable values keep their defaults, and alpha from a texture (`map_d`) is not read. If
/// several materials have the same name, the last is used. These cases are reported in `warnings`, in at most
/// one line per material and eight lines in all. Throws Error(input) if the file cannot be read.
std::map<std::string, MaterialColor> read_mtl(const std::filesystem::path& file,
                                              std::vector<std::string>& warnings);

/// The material of a face's `usemtl`: the one with exactly that name, otherwise the only one whose name is
/// the same up to ` # `, which starts a comment; empty if there is no such material.
std::optional<MaterialColor> material_named(const std::map<std::string, MaterialColor>& materials,
                                            const std::string& name);

}  // namespace vantage
