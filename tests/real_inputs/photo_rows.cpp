// Rows about the colors of meshes, and about photos.
#include "tests/real_inputs/changes.h"

namespace vantage::real_inputs {

// clang-format off
std::vector<Row> photo_rows() {
    return {
        // -------------------------------------------------------------------------------------------- colors
        {"colors", "PLY with uchar colors", with_mesh("mesh.ply", box_ply_with("property uchar red\nproperty uchar green\nproperty uchar blue\n", "204 64 51")), red_box},
        {"colors", "PLY with float colors up to 1", with_mesh("mesh.ply", box_ply_with("property float red\nproperty float green\nproperty float blue\n", "0.8 0.25 0.2")), red_box},
        {"colors", "PLY with float colors up to 255", with_mesh("mesh.ply", box_ply_with("property float red\nproperty float green\nproperty float blue\n", "204 64 51")), red_box},
        {"colors", "PLY with double colors up to 65535", with_mesh("mesh.ply", box_ply_with("property double red\nproperty double green\nproperty double blue\n", "52428 16448 13107")), red_box},
        {"colors", "PLY with ushort colors up to 255", with_mesh("mesh.ply", box_ply_with("property ushort red\nproperty ushort green\nproperty ushort blue\n", "204 64 51")), red_box},
        {"colors", "PLY with ushort colors up to 65535", with_mesh("mesh.ply", box_ply_with("property ushort red\nproperty ushort green\nproperty ushort blue\n", "52428 16448 13107")), red_box},
        {"colors", "PLY with int colors", with_mesh("mesh.ply", box_ply_with("property int red\nproperty int green\nproperty int blue\n", "204 64 51")), red_box},
        {"colors", "PLY with diffuse_red", with_mesh("mesh.ply", box_ply_with("property uchar diffuse_red\nproperty uchar diffuse_green\nproperty uchar diffuse_blue\n", "204 64 51")), red_box},
        {"colors", "PLY with properties r, g and b", with_mesh("mesh.ply", box_ply_with("property uchar r\nproperty uchar g\nproperty uchar b\n", "204 64 51")), red_box},
        {"colors", "PLY with float colors up to 255 and an alpha of 1", with_mesh("mesh.ply", box_ply_with("property float red\nproperty float green\nproperty float blue\nproperty float alpha\n", "204 64 51 1")), red_box},
        {"colors", "PLY with blue before red", with_mesh("mesh.ply", box_ply_with("property uchar blue\nproperty uchar green\nproperty uchar red\n", "51 64 204")), red_box},
        {"colors", "PLY with NaN as a color", with_mesh("mesh.ply", box_ply_with("property float red\nproperty float green\nproperty float blue\n", "nan 0.5 0.5")), Holds{"(0,128,128)"}},
        {"colors", "PLY with only red", with_mesh("mesh.ply", box_ply_with("property uchar red\n", "204"))},
        {"colors", "OBJ with colors up to 1", with_mesh("mesh.obj", box_obj(" 0.8 0.25 0.2")), red_box},
        {"colors", "OBJ with colors up to 255", with_mesh("mesh.obj", box_obj(" 204 64 51")), red_box},
        {"colors", "OBJ with colors up to 255 and alpha", with_mesh("mesh.obj", box_obj(" 204 64 51 255")), red_box},
        {"colors", "OBJ with a weight instead of a color", with_mesh("mesh.obj", box_obj(" 1.0"))},
        {"colors", "OBJ with a glass face in its MTL", [](Scan& s) { s.remove("mesh.ply"); s["mesh.obj"] = "mtllib box.mtl\n" + changed(box_obj(), "f 1 3 2\n", "usemtl glass\nf 1 3 2\nusemtl frame\n"); s["box.mtl"] = "newmtl glass\nKd 0.8 0.25 0.2\nd 0.5\n"; }, Says{"triangles have a vertex with alpha below 255"}, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; vantage info {out}.vantage"}},
        {"colors", "an OBJ whose MTL has changed, then check --against", [](Scan& s) { s.remove("mesh.ply"); s["mesh.obj"] = "mtllib box.mtl\n" + changed(box_obj(), "f 1 3 2\n", "usemtl glass\nf 1 3 2\nusemtl frame\n"); s["box.mtl"] = "newmtl glass\nd 0.5\n"; s["other.mtl"] = "newmtl glass\nd 0.4\n"; }, Exit::stale, Says{"box.mtl: has changed"}, no_package, Command{std::string(prepare_command) + " ; cp {scan}/other.mtl {scan}/box.mtl ; vantage check --against {scan} {out}.vantage"}},
        {"colors", "an OBJ whose opaque material has become glass, then check --against", [](Scan& s) { s.remove("mesh.ply"); s["mesh.obj"] = "mtllib box.mtl\nusemtl glass\n" + box_obj(); s["box.mtl"] = "newmtl glass\n"; s["other.mtl"] = "newmtl glass\nd 0.4\n"; }, Exit::stale, Says{"box.mtl: has changed"}, no_package, Command{std::string(prepare_command) + " ; cp {scan}/other.mtl {scan}/box.mtl ; vantage check --against {scan} {out}.vantage"}},
        {"colors", "an OBJ whose missing MTL was added, then check --against", [](Scan& s) { s.remove("mesh.ply"); s["mesh.obj"] = "mtllib new.mtl\nusemtl glass\n" + box_obj(); s["other.mtl"] = "newmtl glass\nd 0.4\n"; }, Exit::stale, Says{"new.mtl: was added after the package was prepared"}, no_package, Command{std::string(prepare_command) + " ; cp {scan}/other.mtl {scan}/new.mtl ; vantage check --against {scan} {out}.vantage"}},
        {"colors", "an OBJ whose MTL is missing", with_mesh("mesh.obj", "mtllib none.mtl\nusemtl glass\n" + box_obj()), Says{"mesh.obj: its material file none.mtl is missing"}},
        {"colors", "PLY with an alpha of 0 everywhere", with_mesh("mesh.ply", box_ply_with("property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n", "204 64 51 0")), Says{"treated as alpha that was never set"}, Holds{"area 24, vertices red (204,64,51)"}, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; vantage info {out}.vantage"}},
        {"colors", "COFF with colors up to 255", with_mesh("mesh.off", box_off("COFF\n8 12 0\n", " 204 64 51 255")), red_box},
        {"colors", "COFF with colors up to 1", with_mesh("mesh.off", box_off("COFF\n8 12 0\n", " 0.8 0.25 0.2 1.0")), red_box},
        {"colors", "COFF without alpha", with_mesh("mesh.off", box_off("COFF\n8 12 0\n", " 204 64 51")), red_box},
        {"colors", "OFF with equal vertex colors", with_mesh("mesh.off", box_off("OFF\n8 12 0\n", " 204 64 51 255")), red_box},

        // -------------------------------------------------------------------------------------------- photos
        {"photos", "PNG", photos_as(".png"), Holds{"A.png=red B.png=green C.png=blue"}},
        {"photos", "TIFF", photos_as(".tif"), Holds{"A.tif=red B.tif=green C.tif=blue"}},
        {"photos", "WebP", photos_as(".webp"), Holds{"A.webp=red B.webp=green C.webp=blue"}},
        {"photos", "BMP", photos_as(".bmp"), Holds{"A.bmp=red B.bmp=green C.bmp=blue"}},
        {"photos", "EXR", photos_as(".exr"), Says{"A.exr and 2 other photos hold linear light: converted to sRGB"}, Holds{"A.exr=red B.exr=green C.exr=blue"}},
        {"photos", "Radiance HDR", photos_as(".hdr"), Says{"A.hdr and 2 other photos hold linear light: converted to sRGB"}, Holds{"A.hdr=red B.hdr=green C.hdr=blue"}},
        {"photos", "an EXR in which linear 0.216 must become sRGB 128", with_photo_a(".exr", photo(".exr", 0.21586, 0.21586, 0.21586)), Holds{"A.exr=gray(128)"}},
        {"photos", "a Radiance HDR in which linear 0.216 must become sRGB 128", with_photo_a(".hdr", photo(".hdr", 0.21586, 0.21586, 0.21586)), Holds{"A.hdr=gray(128)"}},
        {"photos", "an EXR in which linear 0.001 must become sRGB 0.0129", with_photo_a(".exr", photo(".exr", 0.001, 0.001, 0.001)), Holds{"A.exr=gray(3)"}},
        {"photos", "EXR with values above 1", with_photo_a(".exr", photo(".exr", 7, 7, 7)), Says{"values above 1 are clipped"}, Holds{"A.exr=white"}},
        {"photos", "EXR with negative values", with_photo_a(".exr", photo(".exr", -1, -1, -1)), Holds{"A.exr=gray(0)"}},
        {"photos", "EXR with NaN", with_photo_a(".exr", photo(".exr", std::nan(""), std::nan(""), std::nan(""))), Holds{"A.exr=gray(0)"}},
        {"photos", "EXR with infinite values", with_photo_a(".exr", photo(".exr", INFINITY, INFINITY, INFINITY)), Holds{"A.exr=white"}},
        {"photos", "a white PNG, which is not linear", with_photo_a(".png", photo(".png", 1, 1, 1)), Holds{"A.png=gray(248)"}, Never{"linear"}},
        {"photos", "one EXR among JPEGs", [](Scan& s) { s.remove("images/A.jpg"); s["images/A.exr"] = red(".exr"); }, Says{"A.exr holds linear light"}, Holds{"A.exr=red B.jpg=green"}},
        {"photos", "256 KiB of metadata before the image size", [](Scan& s) { s["images/A.jpg"] = with_metadata(s["images/A.jpg"], 256 << 10); }},
        {"photos", "3 MiB of metadata before the image size", [](Scan& s) { s["images/A.jpg"] = with_metadata(s["images/A.jpg"], 3 << 20); }},
        {"photos", "a JPEG named .png", moved("images/A.jpg", "images/A.png"), Holds{"A.png=red"}},
        {"photos", "a PNG named .jpg", with_file("images/A.jpg", red(".png"))},
        {"photos", "a truncated JPEG", [](Scan& s) { s["images/C.jpg"].resize(700); }, Exit::incomplete, Says{"skipped C.jpg"}, Holds{"A.jpg=red B.jpg=green"}},
        {"photos", "an empty JPEG", with_file("images/C.jpg", ""), Exit::incomplete, Says{"skipped C.jpg"}, Holds{"A.jpg=red B.jpg=green"}},
        {"photos", "an HTML page named .jpg", with_file("images/C.jpg", "<html>404</html>"), Exit::incomplete, Says{"skipped C.jpg"}, Holds{"A.jpg=red B.jpg=green"}},
        {"photos", "a JPEG named .heic", named("A.heic", "A.heic"), Holds{"A.heic=red"}},
        {"photos", "a HEIC that cannot be read", [](Scan& s) { s.remove("images/A.jpg"); s["images/A.HEIC"] = std::string("\0\0\0\x18""ftypheic", 12) + std::string(200, 'x'); }, Exit::incomplete, Says{"skipped A.HEIC", "convert the photos to JPEG"}, Holds{"B.jpg=green C.jpg=blue"}},
        {"photos", "all photos truncated", [](Scan& s) { for (const char* n : {"A", "B", "C"}) s[std::string("images/") + n + ".jpg"].resize(20); }, Exit::input, Says{blocked}},
        {"photos", "a gray photo", with_file("images/A.jpg", photo(".jpg", 0.5, 0.5, 0.5)), Holds{"A.jpg=gray(12"}},
        {"photos", "a photo in Adobe RGB", with_profile_a(icc_profile(adobe_rgb)), Says{"A.jpg holds the color profile 'Adobe RGB (1998)': converted to sRGB; colors outside sRGB are clipped"}},
        {"photos", "two photos in Display P3", [](Scan& s) { for (const char* n : {"A", "B"}) { std::string& photo = s[std::string("images/") + n + ".jpg"]; photo = with_profile(photo, icc_profile(display_p3)); } }, Says{"A.jpg and another photo hold the color profile 'Display P3': converted"}},
        {"photos", "a photo in sRGB, according to its profile", with_profile_a(icc_profile(srgb)), Never{"profile"}},
        {"photos", "a photo in linear light, according to its profile", with_file("images/A.jpg", linear_gray()), Says{"A.jpg holds the color profile 'Linear sRGB'"}, Holds{"A.jpg=gray(12"}},
        {"photos", "a photo in Adobe RGB, prepared twice", with_profile_a(icc_profile(adobe_rgb)), Says{"nothing to do"}, Command{again}},
        {"photos", "a damaged color profile", with_profile_a("none"), Says{"A.jpg holds a color profile, which cannot be used because it is damaged: treated as sRGB"}},
        {"photos", "a gray color profile", with_profile_a(gray_profile(2.2)), Says{"A.jpg holds the color profile 'Gray', which cannot be used because it is not for RGB: treated as sRGB"}},
        {"photos", "a RAW file that cannot be read", both(moved("images/C.jpg", "images/C.IIQ"), [](Scan& s) { s["images/C.IIQ"] = std::string(1000, 'r'); cameras_named({"A.jpg", "B.jpg", "C.IIQ"})(s); }), Exit::incomplete, Says{"skipped C.IIQ: not a readable photo", "Unsupported file format or not RAW file"}, Holds{"A.jpg=red B.jpg=green;"}},
        {"photos", "a photo rotated by 90 degrees, as stated in its EXIF data", [](Scan& s) { s.remove("images/C.jpg"); s["images/C.tif"] = photo(".tif", 0.25, 0.3, 0.8, 48, 64, 6); }, Holds{"A.jpg=red B.jpg=green C.tif=blue"}},
        {"photos", "a photo rotated by 90 degrees", with_file("images/C.jpg", photo(".jpg", 0, 0, 1, 48, 64)), Exit::incomplete, Says{"skipped C.jpg"}, Holds{"A.jpg=red B.jpg=green"}},
        {"photos", "a photo rotated by 90 degrees, inspected", with_file("images/C.jpg", photo(".jpg", 0, 0, 1, 48, 64)), Exit::incomplete, Says{"skipped  C.jpg: is 48x64, but its camera expects 64x48"}, no_package, Command{"vantage inspect {scan}"}},
        {"photos", "a photo twice the size and rotated by 90 degrees, as stated in its EXIF data", [](Scan& s) { s.remove("images/C.jpg"); s["images/C.tif"] = photo(".tif", 0.25, 0.3, 0.8, 96, 128, 6); }, Says{"C.tif: is 96x128, but its camera expects 64x48; scaled the camera"}, Holds{"A.jpg=red B.jpg=green C.tif=blue"}},
        {"photos", "a photo rotated by 90 degrees, as stated by a long integer in its EXIF data", [](Scan& s) { s["images/C.jpg"] = photo(".jpg", 0.25, 0.3, 0.8, 48, 64).insert(2, std::string("\xff\xe1\0\x22""Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x04\0\0\0\x01\0\0\0\x06\0\0\0\0", 36)); }, Holds{"A.jpg=red B.jpg=green C.jpg=blue"}},
        {"photos", "a photo twice the size", [](Scan& s) { s["images/A.jpg"] = photo(".jpg", 0.8, 0.25, 0.2, 128, 96); }, Says{"A.jpg: is 128x96, but its camera expects 64x48; scaled the camera"}},
    };
}
// clang-format on

}  // namespace vantage::real_inputs
