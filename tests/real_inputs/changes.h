#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "tests/icc_profile.h"
#include "tests/real_inputs/row.h"

/// The vocabulary of the rows: changes to a scan, files and commands.
namespace vantage::real_inputs {

inline constexpr const char* bom = "\xef\xbb\xbf";
inline constexpr const char* cafe = "Caf\xc3\xa9.jpg";         // composed, as Linux and Windows store it
inline constexpr const char* cafe_apart = "Cafe\xcc\x81.jpg";  // decomposed, as macOS stores it
inline constexpr const char* cafe_latin = "Caf\xe9.jpg";       // Latin-1
inline constexpr const char* blocked = "no photo can be used";

using Change = std::function<void(Scan&)>;

inline Change nothing() {
    return [](Scan&) {};
}
/// Gives photo A these names on disk and in the cameras.
inline Change named(std::string disk, std::string cameras) {
    return [=](Scan& s) {
        s.move("images/A.jpg", "images/" + disk);
        s["sparse/images.txt"] = colmap_images({cameras, "B.jpg", "C.jpg"});
    };
}
inline Change cameras_named(Names names) {
    return [=](Scan& s) { s["sparse/images.txt"] = colmap_images(names); };
}
inline Change moved(std::string from, std::string to) {
    return [=](Scan& s) { s.move(from, to); };
}
inline Change with_mesh(std::string file, std::string bytes) {
    return [=](Scan& s) {
        s.remove("mesh.ply");
        s[file] = bytes;
    };
}
inline Change with_file(std::string file, std::string bytes) {
    return [=](Scan& s) { s[file] = bytes; };
}
inline Change with_list(std::string list) {
    return [=](Scan& s) { use_bundler(s, list); };
}
/// Replaces the mesh with a glTF file of the box, whose buffer is in the file named by `uri`.
inline Change with_gltf(std::string file, std::string uri) {
    return [=](Scan& s) {
        s.remove("mesh.ply");
        s[file] = box_gltf().json(uri);
        s[replaced(uri, "%20", " ")] = box_gltf().bytes;
    };
}
/// The box as an OBJ with three objects; the second object uses negative vertex indices.
inline std::string several_objects() {
    return "o bottom\nusemtl stone\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nf 1 3 2\nf 1 4 3\n"
           "o top\nusemtl tin\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\nf -4 -3 -2 -1\n"
           "o walls\ng south east\nusemtl stone\nf 1 2 6 5\nf 2 3 7 6\ng north west\nf 3 4 8 7\nf 4 1 5 8\n";
}
inline Change mesh_at(Place place) { return with_mesh("mesh.ply", box_ply(place)); }
inline Change text(std::string file, std::string from, std::string to) {
    return [=](Scan& s) { s.replace(file, from, to); };
}
/// Inserts these bytes at the start of a file.
inline Change starts_with(std::string file, std::string bytes) {
    return [=](Scan& s) { s[file] = bytes + s.files.at(file); };
}
inline Change both(Change a, Change b) {
    return [=](Scan& s) {
        a(s);
        b(s);
    };
}
inline Change binary_cameras(Names names) {
    return [=](Scan& s) {
        s.remove("sparse");
        s["sparse/cameras.bin"] = colmap_cameras_bin();
        s["sparse/images.bin"] = colmap_images_bin(names);
    };
}
/// Stores all photos in another format.
inline Change photos_as(std::string extension) {
    return [=](Scan& s) {
        s.remove("images");
        s["images/A" + extension] = red(extension);
        s["images/B" + extension] = green(extension);
        s["images/C" + extension] = blue(extension);
    };
}
/// Stores photo A in another format.
inline Change with_photo_a(std::string extension, std::string bytes) {
    return [=](Scan& s) {
        s.remove("images/A.jpg");
        s["images/A" + extension] = bytes;
    };
}
/// Gives photo A this color profile.
inline Change with_profile_a(std::string icc) {
    return [=](Scan& s) { s["images/A.jpg"] = with_profile(s.files.at("images/A.jpg"), icc); };
}
/// A gray photo in linear light, as stated by its color profile.
inline std::string linear_gray() {
    RgbSpace linear = srgb;
    linear.name = "Linear sRGB", linear.gamma = 1;
    return with_profile(photo(".jpg", 0.2159, 0.2159, 0.2159), icc_profile(linear));
}
inline std::string crlf(std::string text) {
    for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += 2) text.replace(at, 1, "\r\n");
    return text;
}
inline Change windows_lines(std::string file) {
    return [=](Scan& s) { s[file] = crlf(s.files.at(file)); };
}
inline std::string changed(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == text.npos) throw std::logic_error("no '" + from + "'");
    return text.replace(at, from.size(), to);
}

/// The standard command with additional options.
inline std::string with(const std::string& more) { return std::string(prepare_command) + " " + more; }
/// A command that compares the mesh with the one in `from`. Scalar fields are forced on, so that the distance
/// is stored even if it is constant. `then` is appended to the command.
inline std::string deviation(const std::string& from, const std::string& then) {
    return "vantage prepare {scan} -o {out}.vantage --no-report --effect scalar-fields=on --deviation-from " +
           from + " " + then;
}
inline std::string text_cloud(std::vector<std::string> points) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points.size()) +
                       "\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
    for (const std::string& p : points) text += p + "\n";
    return text;
}
/// A LAS file of point format 2 whose points are the corners of the box, each of them twice.
inline std::string box_las() {
    std::string las(227, '\0');
    const auto put = [&](std::size_t at, const auto& value) { std::memcpy(&las[at], &value, sizeof value); };
    las.replace(0, 4, "LASF");
    las[24] = 1, las[25] = 2, las[104] = 2;
    put(94, std::uint16_t(227)), put(96, std::uint32_t(227)), put(105, std::uint16_t(26)),
        put(107, std::uint32_t(16));
    for (std::size_t axis = 0; axis < 3; ++axis) put(131 + 8 * axis, 0.001), put(155 + 8 * axis, 0.5);
    for (int i = 0; i < 16; ++i) {
        std::array<std::int32_t, 3> at{};
        for (int axis = 0; axis < 3; ++axis) at[std::size_t(axis)] = (i >> axis & 1) ? 500 : -1500;
        const std::array<std::uint16_t, 3> rgb{52224, 16384, 13056};
        std::string record(26, '\0');
        std::memcpy(&record[0], &at, 12);
        std::memcpy(&record[20], &rgb, 6);
        las += record;
    }
    return las;
}

/// Moves photos A and B to one folder and C to another.
inline Change in_image_sets(const std::string& first, const std::string& second) {
    return [=](Scan& s) {
        for (const std::string name : {"A.jpg", "B.jpg"})
            s.move("images/" + name, "images/" + first + "/" + name);
        s.move("images/C.jpg", "images/" + second + "/C.jpg");
    };
}
inline std::string cloud(const std::string& file, const std::string& then) {
    return "vantage prepare {scan} -o {out}.vantage --no-report --points " + file + " " + then;
}
inline constexpr const char* check_against =
    "vantage prepare {scan} -o {out}.vantage --no-report ; vantage check --against {scan} {out}.vantage";
inline constexpr const char* again =
    "vantage prepare {scan} -o {out}.vantage --no-report ; vantage prepare {scan} -o {out}.vantage "
    "--no-report";

inline const Holds no_package{};
inline const Holds red_box{"area 24, vertices red (204,64,51)"};

}  // namespace vantage::real_inputs
