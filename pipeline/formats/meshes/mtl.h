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

/// Reads a Wavefront MTL file: of each material its diffuse color (`Kd r g b`, taken as sRGB; white if there
/// is none) and its alpha (`d`, or 1 - `Tr`; `d` counts if there are both; 1 if there is neither), both
/// clamped to [0, 1]. Lines of other kinds are skipped. A value that cannot be read is left at its default,
/// alpha from a texture (`map_d`) is not read, and of materials of the same name with other values, the last
/// counts: these add to `warnings`, one line per material and at most eight. Throws Error(input) if the file
/// cannot be read.
std::map<std::string, MaterialColor> read_mtl(const std::filesystem::path& file,
                                              std::vector<std::string>& warnings);

/// The material that a face's `usemtl` means: the one of that name, `#` included; else the only one that has
/// it if what follows ` # ` is a comment. Nothing if there is none.
std::optional<MaterialColor> material_named(const std::map<std::string, MaterialColor>& materials,
                                            const std::string& name);

}  // namespace vantage
