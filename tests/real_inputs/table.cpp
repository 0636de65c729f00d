// The table: a new case is a new row.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "tests/icc_profile.h"
#include "tests/real_inputs/row.h"

namespace vantage::real_inputs {
namespace {

constexpr const char* bom = "\xef\xbb\xbf";
constexpr const char* cafe = "Caf\xc3\xa9.jpg";         // composed, as Linux and Windows store it
constexpr const char* cafe_apart = "Cafe\xcc\x81.jpg";  // decomposed, as macOS stores it
constexpr const char* cafe_latin = "Caf\xe9.jpg";       // Latin-1
constexpr const char* blocked = "no photo can be used";

using Change = std::function<void(Scan&)>;

Change nothing() {
    return [](Scan&) {};
}
/// Photo A has another name on disk and in the cameras.
Change named(std::string disk, std::string cameras) {
    return [=](Scan& s) {
        s.move("images/A.jpg", "images/" + disk);
        s["sparse/images.txt"] = colmap_images({cameras, "B.jpg", "C.jpg"});
    };
}
Change cameras_named(Names names) {
    return [=](Scan& s) { s["sparse/images.txt"] = colmap_images(names); };
}
Change moved(std::string from, std::string to) {
    return [=](Scan& s) { s.move(from, to); };
}
Change with_mesh(std::string file, std::string bytes) {
    return [=](Scan& s) {
        s.remove("mesh.ply");
        s[file] = bytes;
    };
}
Change with_file(std::string file, std::string bytes) {
    return [=](Scan& s) { s[file] = bytes; };
}
Change with_list(std::string list) {
    return [=](Scan& s) { use_bundler(s, list); };
}
/// The box as glTF, with its buffer in a file of this name.
Change with_gltf(std::string file, std::string uri) {
    return [=](Scan& s) {
        s.remove("mesh.ply");
        s[file] = box_gltf().json(uri);
        s[replaced(uri, "%20", " ")] = box_gltf().bytes;
    };
}
/// The box as three objects, of which the second counts its vertices from the last one.
std::string several_objects() {
    return "o bottom\nusemtl stone\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nf 1 3 2\nf 1 4 3\n"
           "o top\nusemtl tin\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\nf -4 -3 -2 -1\n"
           "o walls\ng south east\nusemtl stone\nf 1 2 6 5\nf 2 3 7 6\ng north west\nf 3 4 8 7\nf 4 1 5 8\n";
}
Change mesh_at(Place place) { return with_mesh("mesh.ply", box_ply(place)); }
Change text(std::string file, std::string from, std::string to) {
    return [=](Scan& s) { s.replace(file, from, to); };
}
/// The file starts with these bytes.
Change starts_with(std::string file, std::string bytes) {
    return [=](Scan& s) { s[file] = bytes + s.files.at(file); };
}
Change both(Change a, Change b) {
    return [=](Scan& s) {
        a(s);
        b(s);
    };
}
Change binary_cameras(Names names) {
    return [=](Scan& s) {
        s.remove("sparse");
        s["sparse/cameras.bin"] = colmap_cameras_bin();
        s["sparse/images.bin"] = colmap_images_bin(names);
    };
}
/// All photos in another format.
Change photos_as(std::string extension) {
    return [=](Scan& s) {
        s.remove("images");
        s["images/A" + extension] = red(extension);
        s["images/B" + extension] = green(extension);
        s["images/C" + extension] = blue(extension);
    };
}
/// Photo A in another format.
Change with_photo_a(std::string extension, std::string bytes) {
    return [=](Scan& s) {
        s.remove("images/A.jpg");
        s["images/A" + extension] = bytes;
    };
}
/// Photo A with this color profile.
Change with_profile_a(std::string icc) {
    return [=](Scan& s) { s["images/A.jpg"] = with_profile(s.files.at("images/A.jpg"), icc); };
}
/// A gray photo in linear light, which its profile says.
std::string linear_gray() {
    RgbSpace linear = srgb;
    linear.name = "Linear sRGB", linear.gamma = 1;
    return with_profile(photo(".jpg", 0.2159, 0.2159, 0.2159), icc_profile(linear));
}
std::string crlf(std::string text) {
    for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += 2) text.replace(at, 1, "\r\n");
    return text;
}
Change windows_lines(std::string file) {
    return [=](Scan& s) { s[file] = crlf(s.files.at(file)); };
}
std::string changed(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == text.npos) throw std::logic_error("no '" + from + "'");
    return text.replace(at, from.size(), to);
}

/// The usual command with more options.
std::string with(const std::string& more) { return std::string(prepare_command) + " " + more; }
/// Compares the mesh with another one, which has to give a layer even if the distance is the same everywhere.
std::string deviation(const std::string& from, const std::string& then) {
    return "vantage prepare {scan} -o {out}.vantage --no-report --effect scalar-fields=on --deviation-from " +
           from + " " + then;
}
std::string text_cloud(std::vector<std::string> points) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points.size()) +
                       "\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
    for (const std::string& p : points) text += p + "\n";
    return text;
}
/// A LAS file of format 2 whose points are the corners of the box, twice.
std::string box_las() {
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

/// A and B in one folder, C in the other.
Change in_image_sets(const std::string& first, const std::string& second) {
    return [=](Scan& s) {
        for (const std::string name : {"A.jpg", "B.jpg"})
            s.move("images/" + name, "images/" + first + "/" + name);
        s.move("images/C.jpg", "images/" + second + "/C.jpg");
    };
}
std::string cloud(const std::string& file, const std::string& then) {
    return "vantage prepare {scan} -o {out}.vantage --no-report --points " + file + " " + then;
}
constexpr const char* check_against =
    "vantage prepare {scan} -o {out}.vantage --no-report ; vantage check --against {scan} {out}.vantage";
constexpr const char* again =
    "vantage prepare {scan} -o {out}.vantage --no-report ; vantage prepare {scan} -o {out}.vantage "
    "--no-report";

const Holds no_package{};
const Holds red_box{"area 24, vertices red (204,64,51)"};

// clang-format off
std::vector<Row> rows() {
    return {
        // ---------------------------------------------------------------------------------------- file names
        {"file names", "plain", nothing()},
        {"file names", "A.JPG on disk, A.jpg in the cameras", named("A.JPG", "A.jpg"), Holds{"A.JPG=red B.jpg=green"}},
        {"file names", "img_0000.jpg on disk, IMG_0000.JPG in the cameras", named("img_0000.jpg", "IMG_0000.JPG"), Holds{"img_0000.jpg=red"}},
        {"file names", "a.jpg and A.jpg, which differ", with_file("images/a.jpg", blue()), Exit::incomplete, Says{"left out a.jpg: has no camera"}},
        {"file names", "A.JPEG on disk, A.jpg in the cameras", named("A.JPEG", "A.jpg"), Holds{"A.JPEG=red"}},
        {"file names", "A.TIF on disk, a.jpg in the cameras", both(with_photo_a(".TIF", red(".tif")), cameras_named({"a.jpg", "B.jpg", "C.jpg"})), Holds{"A.TIF=red B.jpg=green"}},
        {"file names", "composed on disk, decomposed in the cameras", named(cafe, cafe_apart), Holds{"Caf\xc3\xa9.jpg=red"}},
        {"file names", "decomposed on disk, composed in the cameras", named(cafe_apart, cafe), Holds{"Cafe\xcc\x81.jpg=red"}},
        {"file names", "Latin-1 in the cameras", named(cafe, cafe_latin), Holds{"Caf\xc3\xa9.jpg=red"}},
        {"file names", "Latin-1 on disk", named(cafe_latin, cafe), Holds{"Caf\xc3\xa9.jpg=red"}},
        {"file names", "Latin-1 in both", named(cafe_latin, cafe_latin), Holds{"Caf\xc3\xa9.jpg=red"}},
        {"file names", "Latin-1 on disk, checked", named(cafe_latin, cafe), Says{"valid"}, Holds{"Caf\xc3\xa9.jpg=red"}, Command{check_against}},
        {"file names", "Latin-1 on disk, prepared again", named(cafe_latin, cafe), Says{"nothing to do"}, Holds{"Caf\xc3\xa9.jpg=red"}, Command{again}},
        {"file names", "Latin-1 photo without a camera", with_file(std::string("images/") + cafe_latin, red()), Exit::incomplete, Says{"has no camera"}},
        {"file names", "Latin-1 mesh", moved("mesh.ply", "m\xe9sh.ply")},
        {"file names", "Hangul, composed and decomposed", named("\xed\x95\x9c.jpg", "\xe1\x84\x92\xe1\x85\xa1\xe1\x86\xab.jpg"), Holds{"\xed\x95\x9c.jpg=red"}},
        {"file names", "Vietnamese, two marks", named("\xe1\xbb\x87.jpg", "e\xcc\xa3\xcc\x82.jpg"), Holds{"\xe1\xbb\x87.jpg=red"}},
        {"file names", "Greek in capitals", named("\xce\xb1\xce\xb2.jpg", "\xce\x91\xce\x92.jpg"), Holds{"\xce\xb1\xce\xb2.jpg=red"}},
        {"file names", "Cyrillic in capitals", named("\xd0\xb4\xd0\xbe\xd0\xbc.jpg", "\xd0\x94\xd0\x9e\xd0\x9c.JPG"), Holds{"=red"}},
        {"file names", "Japanese", named("\xe5\x86\x99\xe7\x9c\x9f.jpg", "\xe5\x86\x99\xe7\x9c\x9f.jpg"), Holds{"=red"}},
        {"file names", "emoji", named("\xf0\x9f\x98\x80.jpg", "\xf0\x9f\x98\x80.jpg"), Holds{"=red"}},
        {"file names", "blanks", named("my photo 1.jpg", "my photo 1.jpg"), Holds{"my photo 1.jpg=red"}},
        {"file names", "a quote and an ampersand", named("a'b\"&<c>.jpg", "a'b\"&<c>.jpg"), Holds{"=red"}, Command{"vantage prepare {scan} -o {out}.vantage"}},
        {"file names", "several dots", named("a.b.c.jpg", "a.b.c.jpg"), Holds{"a.b.c.jpg=red"}},
        {"file names", "a number after a dot instead of an extension", named("IMG_1.2.jpg", "IMG_1.2"), Holds{"IMG_1.2.jpg=red"}},
        {"file names", "no extension in the cameras", cameras_named({"A", "B", "C"})},
        {"file names", "a leading minus", named("-A.jpg", "-A.jpg"), Holds{"=red"}},
        {"file names", "190 bytes", named(std::string(186, 'x') + ".jpg", std::string(186, 'x') + ".jpg"), Holds{"xx.jpg=red"}},
        {"file names", "250 bytes", named(std::string(246, 'x') + ".jpg", std::string(246, 'x') + ".jpg"), Exit::input, Says{"name is longer than 191 bytes"}},
        {"file names", "._A.jpg of macOS", with_file("images/._A.jpg", "Mac OS X"), Never{"._A"}},
        {"file names", "._mesh.ply of macOS, larger than the mesh", with_file("._mesh.ply", std::string(100000, 'm')), Never{"._mesh"}},
        {"file names", ".DS_Store and Thumbs.db", both(with_file("images/.DS_Store", "x"), with_file("images/Thumbs.db", "x")), Never{"left out"}},
        {"file names", "a hidden photo", with_file("images/.trashed-A.jpg", red()), Never{"left out"}},
        {"file names", "RAW beside JPEG", with_file("images/A.CR2", "raw"), Never{"left out"}},
        {"file names", "RAW beside JPEG, other case", with_file("images/a.dng", "raw"), Never{"left out"}},
        {"file names", "PNG beside JPEG, the cameras name PNG", both(with_file("images/A.png", blue(".png")), cameras_named({"A.png", "B.jpg", "C.jpg"})), Holds{"A.png=blue B.jpg=green"}, Never{"left out"}},
        {"file names", "PNG beside JPEG, the cameras name neither", both(with_file("images/A.png", blue(".png")), cameras_named({"A", "B", "C"})), Holds{"A.jpg=red"}, Never{"left out"}},
        {"file names", "RAW beside JPEG, checked", with_file("images/A.NEF", "raw"), Says{"valid"}, Command{check_against}},
        {"file names", "a photo without a camera", with_file("images/D.jpg", red()), Exit::incomplete, Says{"left out D.jpg: has no camera"}},
        {"file names", "a camera without a photo", [](Scan& s) { s.remove("images/C.jpg"); }, Exit::incomplete, Says{"left out C.jpg: has a camera but no photo"}, Holds{"A.jpg=red B.jpg=green;"}},
        {"file names", "no name in common", cameras_named({"X.jpg", "Y.jpg", "Z.jpg"}), Exit::input, Says{"no photo has a camera in", "'A.jpg'", "'X.jpg'"}},
        {"file names", "two cameras for a photo", cameras_named({"A.jpg", "A.jpg", "C.jpg"}), Exit::input, Says{"A.jpg: has more than one camera"}},
        {"file names", "two cameras for a photo but for the case", cameras_named({"A.jpg", "a.jpg", "C.jpg"}), Exit::input, Says{"A.jpg: has more than one camera"}},

        // ------------------------------------------------------------------------------------------- folders
        {"folders", "images is a link", both(moved("images", "elsewhere"), [](Scan& s) { s.links["images"] = "elsewhere"; }), Says{"scan/images (3)"}},
        {"folders", "images is a link out of the scan", both(moved("images", "../elsewhere"), [](Scan& s) { s.links["images"] = "../elsewhere"; })},
        {"folders", "photos are links", [](Scan& s) { s.move("images", "../elsewhere"); for (const char* n : {"A", "B", "C"}) s.links[std::string("images/") + n + ".jpg"] = std::string("../../elsewhere/") + n + ".jpg"; }},
        {"folders", "a photo is a link to another name and format", [](Scan& s) { s.remove("images/A.jpg"); s["../elsewhere/1.tif"] = red(".tif"); s.links["images/A.jpg"] = "../../elsewhere/1.tif"; }},
        {"folders", "sparse is a link", both(moved("sparse", "../model"), [](Scan& s) { s.links["sparse"] = "../model"; })},
        {"folders", "a link to the folder above", [](Scan& s) { s.links["images/up"] = ".."; s.links["loop"] = "."; }},
        {"folders", "a link to nothing", [](Scan& s) { s.links["images/gone.jpg"] = "nowhere.jpg"; s.links["gone"] = "nowhere"; }},
        {"folders", "a photo is a link to nothing", [](Scan& s) { s.remove("images/C.jpg"); s.links["images/C.jpg"] = "nowhere.jpg"; }, Exit::incomplete, Says{"left out C.jpg"}, Holds{"A.jpg=red B.jpg=green;"}},
        {"folders", "blanks in all names", both(moved("images", "my images"), moved("sparse", "my model"))},
        {"folders", "photos beside the mesh", moved("images", ".")},
        {"folders", "cameras beside the photos", moved("sparse", "images")},
        {"folders", "everything in one folder below", both(both(moved("images", "scan/images"), moved("sparse", "scan/sparse")), moved("mesh.ply", "scan/mesh.ply"))},
        {"folders", "COLMAP's sparse/0", moved("sparse", "sparse/0")},
        {"folders", "sparse/0 and a larger sparse/1", [](Scan& s) { s.copy("sparse", "sparse/1"); s.move("sparse/cameras.txt", "sparse/0/cameras.txt"); s.remove("sparse/images.txt"); s["sparse/0/images.txt"] = colmap_images({"A.jpg"}); }, Says{"sparse/0: not used, has 1 cameras; sparse/1 has 3"}},
        {"folders", "sparse/0 and a smaller sparse/1", [](Scan& s) { s.copy("sparse", "sparse/0"); s["sparse/1/cameras.txt"] = s["sparse/cameras.txt"]; s["sparse/1/images.txt"] = colmap_images({"A.jpg"}); s.remove("sparse/cameras.txt"); s.remove("sparse/images.txt"); }, Says{"sparse/1: not used, has 1 cameras; sparse/0 has 3"}},
        {"folders", "sparse/0 and a broken sparse/1", [](Scan& s) { s.copy("sparse", "sparse/0"); s["sparse/1/cameras.txt"] = "nonsense"; s["sparse/1/images.txt"] = "nonsense"; s.remove("sparse/cameras.txt"); s.remove("sparse/images.txt"); }, Exit::input, Says{"sparse/1/cameras.txt, line 1: expected a camera ID, found 'nonsense'"}},
        {"folders", "a broken sparse/1, --cameras names sparse/0", [](Scan& s) { s.copy("sparse", "sparse/0"); s["sparse/1/cameras.txt"] = "nonsense"; s["sparse/1/images.txt"] = "nonsense"; s.remove("sparse/cameras.txt"); s.remove("sparse/images.txt"); }, Command{with("--cameras {scan}/sparse/0")}},
        {"folders", "no mesh in the folder, --mesh names one elsewhere", moved("mesh.ply", "../elsewhere.ply"), Command{with("--mesh {scan}/../elsewhere.ply")}},
        {"folders", "a slash at the end, photos in two folders", [](Scan& s) { s.move("images/B.jpg", "images2/B.jpg"); }, Holds{"A.jpg=red B.jpg=green C.jpg=blue"}, Command{"vantage prepare {scan}/ -o {out}.vantage --no-report"}},
        {"folders", "slashes at the end of all folders", nothing(), Holds{"A.jpg=red B.jpg=green C.jpg=blue"}, Command{"vantage prepare --mesh {scan}/mesh.ply --cameras {scan}/sparse/ --photos {scan}/images/ -o {out}.vantage --no-report"}},
        {"folders", "a slash at the end, inspected", [](Scan& s) { s.move("images/B.jpg", "images2/B.jpg"); }, Command{"vantage inspect {scan}//"}, no_package},
        {"folders", "COLMAP's dense workspace", [](Scan& s) { s.remove("mesh.ply"); s["fused.ply"] = points_ply(); s["meshed-poisson.ply"] = box_ply(); s["stereo/depth_maps/A.jpg.geometric.bin"] = "x"; }, Says{"meshed-poisson.ply"}},
        {"folders", "a dense workspace with meshed-delaunay.ply", [](Scan& s) { s.remove("mesh.ply"); s["fused.ply"] = points_ply(); s["meshed-delaunay.ply"] = box_ply(); }, Says{"meshed-delaunay.ply"}},
        {"folders", "fused.ply alone", [](Scan& s) { s.remove("mesh.ply"); s["fused.ply"] = points_ply(); }, Says{"fused.ply (1000)"}, Holds{"A.jpg=red B.jpg=green C.jpg=blue"}},
        {"folders", "mesh.ply holds points, scan.ply is the mesh", [](Scan& s) { s["mesh.ply"] = points_ply(); s["scan.ply"] = box_ply(); }, Says{"scan.ply"}},
        {"folders", "dense/ with undistorted photos beside images/", [](Scan& s) { s.copy("images", "dense/images"); s.copy("sparse", "dense/sparse"); s.move("mesh.ply", "dense/mesh.ply"); }, Says{"dense/images (3)"}},
        {"folders", "equal names in two folders", [](Scan& s) { s.move("images/A.jpg", "images/cam1/A.jpg"); s.move("images/B.jpg", "images/cam2/A.jpg"); s.move("images/C.jpg", "images/cam2/C.jpg"); cameras_named({"cam1/A.jpg", "cam2/A.jpg", "cam2/C.jpg"})(s); }, Holds{"C.jpg=blue cam1_A.jpg=red cam2_A.jpg=green"}},
        {"folders", "equal names in two folders, other case and extension", [](Scan& s) { s["images/Cam1/a.TIF"] = red(".tif"); s["images/Cam2/A.png"] = green(".png"); s.remove("images/A.jpg"); s.remove("images/B.jpg"); cameras_named({"cam1/A.jpg", "cam2/a.JPG", "C.jpg"})(s); }, Holds{"A.png=green C.jpg=blue a.TIF=red"}},
        {"folders", "equal names in two folders, cameras name one", [](Scan& s) { s["images/cam1/A.jpg"] = blue(); s.move("images", "images/cam2"); s.move("images/cam2/cam1", "images/cam1"); cameras_named({"cam2/A.jpg", "cam2/B.jpg", "cam2/C.jpg"})(s); }},
        {"folders", "cam2/A.jpg, only cam1/A.jpg on disk", [](Scan& s) { s.move("images/A.jpg", "images/cam1/A.jpg"); cameras_named({"cam2/A.jpg", "B.jpg", "C.jpg"})(s); }, Exit::incomplete, Says{"left out cam2/A.jpg: has a camera but no photo"}, Holds{"B.jpg=green C.jpg=blue;"}},
        {"folders", "two cameras' folders, photos in one folder", cameras_named({"cam1/A.jpg", "cam2/A.jpg", "C.jpg"}), Exit::incomplete, Says{"cam1/A.jpg: has a camera but no photo"}, Holds{"C.jpg=blue;"}},
        {"folders", "two cameras' folders, unlike names in one folder", cameras_named({"cam1/A.jpg", "cam2/B.jpg", "cam2/C.jpg"})},
        {"folders", "folders of another machine", cameras_named({"/home/ann/photos/A.jpg", "/home/ann/photos/B.jpg", "/home/ann/photos/C.jpg"})},
        {"folders", "cameras name images/A.jpg", cameras_named({"images/A.jpg", "images/B.jpg", "images/C.jpg"})},
        {"folders", "cameras name ./A.jpg", cameras_named({"./A.jpg", "./B.jpg", "./C.jpg"})},
        {"folders", "cameras name ../images/A.jpg", cameras_named({"../images/A.jpg", "../images/B.jpg", "../images/C.jpg"})},
        {"folders", "cameras name the second of two folders with equal names", [](Scan& s) { s.move("images", "photos/101MEDIA"); for (const char* n : {"A", "B", "C"}) s[std::string("photos/100MEDIA/") + n + ".jpg"] = blue(); cameras_named({"101MEDIA/A.jpg", "101MEDIA/B.jpg", "101MEDIA/C.jpg"})(s); }, Says{"photos/101MEDIA (3)"}},
        {"folders", "the same folders in two trees", [](Scan& s) { s.move("images", "raw/m"); for (const char* n : {"A", "B", "C"}) s[std::string("photos/m/") + n + ".jpg"] = blue(); cameras_named({"raw/m/A.jpg", "raw/m/B.jpg", "raw/m/C.jpg"})(s); }, Never{"as well"}},
        {"folders", "two folders fit equally", [](Scan& s) { s.move("images", "p1"); s.copy("p1", "p2"); }, Says{"p2: fits the cameras as well as p1, which is used; --photos names another"}},
        {"folders", "a name fits photos in two folders", [](Scan& s) { s.copy("images/A.jpg", "images/cam2/A.jpg"); s.move("images/A.jpg", "images/cam1/A.jpg"); }, Exit::incomplete, Says{"left out A.jpg: may be cam1/A.jpg or cam2/A.jpg: expected its folder in"}, Holds{"B.jpg=green C.jpg=blue;"}},
        {"folders", "a name fits two photos, one of which has its camera", [](Scan& s) { s.move("images/A.jpg", "images/cam1/A.jpg"); s.move("images/B.jpg", "images/cam2/A.jpg"); cameras_named({"A.jpg", "cam2/A.jpg", "C.jpg"})(s); }, Holds{"C.jpg=blue cam1_A.jpg=red cam2_A.jpg=green"}},
        {"folders", "names that become equal in the package", [](Scan& s) { s.move("images/A.jpg", "images/cam/A.jpg"); s.move("images/B.jpg", "images/x/A.jpg"); s.move("images/C.jpg", "images/cam_A.jpg"); cameras_named({"cam/A.jpg", "x/A.jpg", "cam_A.jpg"})(s); }, Holds{"_cam_A.jpg=blue cam_A.jpg=red x_A.jpg=green"}},
        {"folders", "photos three folders down", moved("images", "photos/DCIM/100MEDIA"), Says{"photos/DCIM/100MEDIA (3)"}},
        {"folders", "photos in subfolders, cameras name files only", [](Scan& s) { s.move("images/A.jpg", "images/left/A.jpg"); s.move("images/B.jpg", "images/right/B.jpg"); }},
        {"folders", "a subfolder in other case", [](Scan& s) { s.move("images/A.jpg", "images/Left/A.jpg"); cameras_named({"left/A.jpg", "B.jpg", "C.jpg"})(s); }},
        {"folders", "backslashes in the cameras", [](Scan& s) { s.move("images/A.jpg", "images/left/A.jpg"); cameras_named({"left\\A.jpg", "B.jpg", "C.jpg"})(s); }},
        {"folders", "paths of Windows in the cameras", cameras_named({"C:\\scan\\A.jpg", "C:\\scan\\B.jpg", "C:\\scan\\C.jpg"})},
        {"folders", "a depth folder with the same stems", [](Scan& s) { s.move("images", "frames"); for (const char* n : {"A", "B", "C"}) s[std::string("depth/") + n + ".png"] = photo(".png", 0.5, 0.5, 0.5); }, Says{"scan/frames (3)"}},
        {"folders", "a masks folder with the same stems", [](Scan& s) { s.move("images", "frames"); for (const char* n : {"A", "B", "C"}) s[std::string("masks/") + n + ".png"] = photo(".png", 1, 1, 1); }, Says{"scan/frames (3)"}},
        {"folders", "a depth folder with the cameras' own names", [](Scan& s) { s.move("images", "rgb"); for (const char* n : {"A", "B", "C"}) s[std::string("depth/") + n + ".jpg"] = photo(".jpg", 0.5, 0.5, 0.5); }, Says{"scan/rgb (3)"}},
        {"folders", "depth inside images", [](Scan& s) { for (const char* n : {"A", "B", "C"}) s[std::string("images/depth/") + n + ".jpg"] = photo(".jpg", 0.5, 0.5, 0.5); }},
        {"folders", "smaller copies in images_2", [](Scan& s) { for (const char* n : {"A", "B", "C"}) s[std::string("images_2/") + n + ".jpg"] = photo(".jpg", 0.5, 0.5, 0.5, 32, 24); }, Says{"scan/images (3)"}},
        {"folders", "more pictures elsewhere than photos", [](Scan& s) { for (int i = 0; i < 9; ++i) s["holiday/" + std::to_string(i) + ".jpg"] = red(); }, Says{"scan/images (3)"}},
        {"folders", "more pictures elsewhere, photos in a folder of any name", [](Scan& s) { s.move("images", "dslr"); for (int i = 0; i < 9; ++i) s["holiday/" + std::to_string(i) + ".jpg"] = red(); }, Says{"scan/dslr (3)"}},
        {"folders", "hidden folders", [](Scan& s) { s.copy("images", ".git/images"); s.copy("images", "@eaDir"); s.copy("images", "__MACOSX/images"); s["__MACOSX/mesh.ply"] = std::string(100000, 'x'); }, Says{"scan/images (3)"}},
        {"folders", "a mesh four levels down", moved("mesh.ply", "a/b/c/mesh.ply"), Exit::input, Says{"no mesh found"}},
        {"folders", "empty", [](Scan& s) { s.files.clear(); s.folders.insert("x"); }, Exit::input, Says{"no mesh found"}},
        {"folders", "no cameras", [](Scan& s) { s.remove("sparse"); }, Exit::input, Says{"no cameras found; expected COLMAP"}},
        {"folders", "no photos", [](Scan& s) { s.remove("images"); }, Exit::input, Says{"no photos found"}},
        {"folders", "the scan does not exist", nothing(), Exit::input, Says{"/none: does not exist"}, no_package, Command{"vantage prepare {scan}/none -o {out}.vantage"}},
        {"folders", "the scan is a file", nothing(), Exit::input, Says{"mesh.ply: not a folder"}, no_package, Command{"vantage prepare {scan}/mesh.ply -o {out}.vantage"}},
        {"folders", "--photos is a file", nothing(), Exit::input, Says{"not a folder"}, no_package, Command{with("--photos {scan}/mesh.ply")}},
        {"folders", "--mesh is a folder", nothing(), Exit::input, Says{"expected a file, found a folder"}, no_package, Command{with("--mesh {scan}/images")}},
        {"folders", "--photos does not exist", nothing(), Exit::input, Says{"does not exist"}, no_package, Command{with("--photos {scan}/none")}},
        {"folders", "masks in other case, and composed otherwise", [](Scan& s) { named("Ku\xcc\x88" "che.jpg", "Ku\xcc\x88" "che.jpg")(s); s["Masks/K\xc3\xbc" "che.PNG"] = s["Masks/b.jpg.png"] = photo(".png", 1, 1, 1); }, Says{"2 of them with a stencil"}, no_package, Command{"vantage inspect {scan}"}},
        {"folders", "a link to a folder of the scan that comes first", [](Scan& s) { s.move("images", "images/cam"); s.links["a/photos"] = "../images"; }, Says{"images/cam (3)"}},
        {"folders", "a mask beside each photo", [](Scan& s) { for (const char* n : {"A", "B", "C"}) s[std::string("images/") + n + ".mask.png"] = photo(".png", 1, 1, 1); }, Never{"left out"}},

        // ----------------------------------------------------------------------------------------- encodings
        {"encodings", "a byte order mark in cameras.txt", starts_with("sparse/cameras.txt", bom)},
        {"encodings", "a byte order mark in images.txt", starts_with("sparse/images.txt", bom)},
        {"encodings", "a byte order mark before the first camera", [](Scan& s) { s["sparse/cameras.txt"] = std::string(bom) + "1 PINHOLE 64 48 60 60 32 24\n"; }},
        {"encodings", "a byte order mark in mesh.ply", starts_with("mesh.ply", bom)},
        {"encodings", "a byte order mark in an OBJ", with_mesh("mesh.obj", std::string(bom) + changed(box_obj(), "# box\n", ""))},
        {"encodings", "a byte order mark in an OFF", with_mesh("mesh.off", bom + box_off())},
        {"encodings", "a byte order mark in bundle.out", both(with_list("A.jpg\nB.jpg\nC.jpg\n"), starts_with("bundle.out", bom))},
        {"encodings", "a byte order mark in list.txt", with_list(std::string(bom) + "A.jpg\nB.jpg\nC.jpg\n")},
        {"encodings", "a byte order mark in a MeshLab project", [](Scan& s) { use_meshlab(s, {"A.jpg", "B.jpg", "C.jpg"}); s["project.mlp"] = bom + s["project.mlp"]; }},
        {"encodings", "a byte order mark in the configuration", with_file("c.toml", std::string(bom) + "photo-size = 32\n"), Command{with("--preset {scan}/c.toml")}},
        {"encodings", "a byte order mark in a camera path", with_file("p.txt", std::string(bom) + "0,0,-6,0,0,1,60\n"), Command{"vantage prepare {scan} -o {out}.vantage --no-report ; vantage-player {out}.vantage --offscreen --path {scan}/p.txt --size 64x48 -o {out}-pictures"}},
        {"encodings", "Latin-1 in the package's name, checked as JSON", nothing(), Says{"\"valid\": true"}, no_package, Command{"vantage prepare {scan} -o {out}-\xe9.vantage --no-report ; vantage check --json {out}-\xe9.vantage"}},
        {"encodings", "UTF-16 in cameras.txt", with_file("sparse/cameras.txt", std::string("\xff\xfe" "1\0 \0", 6)), Exit::input, Says{"cameras.txt: is UTF-16, expected UTF-8"}},
        {"encodings", "UTF-16 in an OBJ", with_mesh("mesh.obj", std::string("\xff\xfev\0", 4)), Exit::input, Says{"mesh.obj: is UTF-16"}},
        {"encodings", "lines of Windows in cameras.txt", windows_lines("sparse/cameras.txt")},
        {"encodings", "lines of Windows in images.txt", windows_lines("sparse/images.txt")},
        {"encodings", "lines of Windows in mesh.ply", windows_lines("mesh.ply")},
        {"encodings", "lines of Windows in an OBJ", with_mesh("mesh.obj", crlf(box_obj()))},
        {"encodings", "lines of Windows in an OFF", with_mesh("mesh.off", crlf(box_off()))},
        {"encodings", "lines of Windows in an STL", with_mesh("mesh.stl", crlf(box_stl()))},
        {"encodings", "lines of Windows in bundle.out and list.txt", both(with_list("A.jpg\r\nB.jpg\r\nC.jpg\r\n"), windows_lines("bundle.out"))},
        {"encodings", "lines of Windows in the configuration", with_file("c.toml", "photo-size = 32\r\n"), Command{with("--preset {scan}/c.toml")}},
        {"encodings", "lines of Mac OS 9 in cameras.txt", with_file("sparse/cameras.txt", "# x\r1 PINHOLE 64 48 60 60 32 24\r")},
        {"encodings", "tabs in cameras.txt", with_file("sparse/cameras.txt", "1\tPINHOLE\t64\t48\t60\t60\t32\t24\n")},
        {"encodings", "no newline at the end of cameras.txt", with_file("sparse/cameras.txt", "1 PINHOLE 64 48 60 60 32 24")},
        {"encodings", "blank lines in cameras.txt", with_file("sparse/cameras.txt", "\n\n1 PINHOLE 64 48 60 60 32 24\n\n\n")},
        {"encodings", "numbers like +60", with_file("sparse/cameras.txt", "1 PINHOLE +64 +48 +60.0 +6e1 +32 +24\n")},
        {"encodings", "numbers like 64.0 for integers", with_file("sparse/cameras.txt", "1.0 PINHOLE 64.0 48.000 60 60 32 24\n")},
        {"encodings", "numbers like 6e1", with_file("sparse/cameras.txt", "1 PINHOLE 6.4e1 4.8E+01 6e1 60.0E0 3.2e+001 24\n")},
        {"encodings", "a width of 64.5", with_file("sparse/cameras.txt", "1 PINHOLE 64.5 48 60 60 32 24\n"), Exit::input, Says{"cameras.txt, line 1: expected a width, found '64.5'"}},
        {"encodings", "a decimal comma", with_file("sparse/cameras.txt", "1 PINHOLE 64 48 60,5 60 32 24\n"), Exit::input, Says{"cameras.txt, line 1: expected a camera parameter, found '60,5'"}},
        {"encodings", "numbers like +1 in mesh.ply", text("mesh.ply", "\n1 1 1\n", "\n+1 +1.0 +1e0\n")},
        {"encodings", "numbers like +1 in an OBJ", with_mesh("mesh.obj", changed(box_obj(), "v 1 1 1\n", "v +1 +1.0 +1e0\n"))},
        {"encodings", "numbers like +1 in an OFF", with_mesh("mesh.off", changed(box_off(), "1 1 1\n", "+1 +1.0 +1e0\n"))},
        {"encodings", "indices like 3.0 in mesh.ply", text("mesh.ply", "\n3 0 2 1\n", "\n3 0.0 2.0 1.0\n")},
        {"encodings", "a word in mesh.ply", text("mesh.ply", "\n1 1 1\n", "\n1 one 1\n"), Exit::input, Says{"mesh.ply: expected a number, found 'one'"}},
        {"encodings", "a Latin-1 comment in cameras.txt", starts_with("sparse/cameras.txt", "# caf\xe9\n")},
        {"encodings", "a Latin-1 comment in mesh.ply", text("mesh.ply", "element vertex", "comment caf\xe9\nelement vertex")},
        {"encodings", "a Latin-1 property in mesh.ply", with_mesh("mesh.ply", box_ply_with("property float caf\xe9\n", "1"))},
        {"encodings", "zeros at the end of images.txt", [](Scan& s) { s["sparse/images.txt"] += std::string(16, '\0'); }, Exit::input, Says{"images.txt, line"}},
        {"encodings", "empty cameras.txt", with_file("sparse/cameras.txt", ""), Exit::input, Says{"camera 1, which is not in the cameras file"}},
        {"encodings", "empty images.txt", with_file("sparse/images.txt", ""), Exit::input, Says{"scan/sparse: expected an image with a pose in images.txt, found none"}},
        {"encodings", "empty mesh.ply", with_file("mesh.ply", ""), Exit::input, Says{"mesh.ply: expected a PLY header"}},
        {"encodings", "empty mesh.obj", with_mesh("mesh.obj", ""), Exit::input, Says{"mesh.obj: has no vertices"}},
        {"encodings", "empty mesh.off", with_mesh("mesh.off", ""), Exit::input, Says{"mesh.off"}},
        {"encodings", "empty mesh.stl", with_mesh("mesh.stl", ""), Exit::input, Says{"mesh.stl"}},

        // ------------------------------------------------------------------------------------------- cameras
        {"cameras", "COLMAP binary", binary_cameras({"A.jpg", "B.jpg", "C.jpg"}), Says{"COLMAP binary"}},
        {"cameras", "COLMAP binary, folders and backslashes", [](Scan& s) { binary_cameras({"left\\A.jpg", "B.jpg", "C.jpg"})(s); s.move("images/A.jpg", "images/left/A.jpg"); }},
        {"cameras", "COLMAP binary, Latin-1", [](Scan& s) { binary_cameras({cafe_latin, "B.jpg", "C.jpg"})(s); s.move("images/A.jpg", std::string("images/") + cafe); }, Holds{"=red"}},
        {"cameras", "COLMAP binary, truncated", [](Scan& s) { binary_cameras({"A.jpg", "B.jpg", "C.jpg"})(s); s["sparse/images.bin"].resize(100); }, Exit::input, Says{"images.bin: truncated at byte"}},
        {"cameras", "COLMAP binary without cameras.bin", [](Scan& s) { binary_cameras({"A.jpg"})(s); s.remove("sparse/cameras.bin"); }, Exit::input, Says{"no cameras found"}},
        {"cameras", "COLMAP with blanks in a name", named("a b.jpg", "a b.jpg"), Holds{"a b.jpg=red"}},
        {"cameras", "COLMAP with points in images.txt", text("sparse/images.txt", "A.jpg\n", "A.jpg\n10.5 20.5 -1 30 40 7")},
        {"cameras", "COLMAP, an unknown model", with_file("sparse/cameras.txt", "1 MAGIC 64 48 60 60 32 24\n"), Exit::input, Says{"expected a COLMAP camera model, found 'MAGIC'"}},
        {"cameras", "COLMAP, too few parameters", with_file("sparse/cameras.txt", "1 PINHOLE 64 48 60 60 32\n"), Exit::input, Says{"cameras.txt, line 1: expected 4 parameters of PINHOLE, found 3"}},
        {"cameras", "COLMAP, no focal length", with_file("sparse/cameras.txt", "1 PINHOLE 64 48 0 0 32 24\n"), Exit::input, Says{blocked, "A.jpg"}},
        {"cameras", "COLMAP, focal length nan", with_file("sparse/cameras.txt", "1 PINHOLE 64 48 nan nan 32 24\n"), Exit::input, Says{blocked}},
        {"cameras", "COLMAP, a quaternion of zeros", [](Scan& s) { s["sparse/images.txt"] = "1 0 0 0 0 0 0 6 1 A.jpg\n\n" + changed(colmap_images({"X", "B.jpg", "C.jpg"}), "1 ", "9 "); s.replace("sparse/images.txt", " X\n", " gone.jpg\n"); }, Exit::incomplete, Says{"left out A.jpg"}, Holds{"B.jpg=green C.jpg=blue;"}},
        {"cameras", "COLMAP, a camera without an entry", text("sparse/images.txt", " 1 A.jpg", " 7 A.jpg"), Exit::input, Says{"photo A.jpg has camera 7, which is not in the cameras file"}},
        {"cameras", "COLMAP, twice the size of the photos", with_file("sparse/cameras.txt", "1 PINHOLE 128 96 120 120 64 48\n"), Says{"scaled the camera"}},
        {"cameras", "COLMAP, another shape than the photos", with_file("sparse/cameras.txt", "1 PINHOLE 64 64 60 60 32 32\n"), Exit::input, Says{blocked, "A.jpg: is 64x48, but its camera expects 64x64"}},
        {"cameras", "COLMAP, one photo of another shape", with_file("images/C.jpg", photo(".jpg", 0, 0, 1, 64, 64)), Exit::incomplete, Says{"left out C.jpg: is 64x64, but its camera expects 64x48"}, Holds{"A.jpg=red B.jpg=green;"}},
        {"cameras", "COLMAP, a distorted lens", with_file("sparse/cameras.txt", "1 OPENCV 64 48 60 60 32 24 0.05 0 0 0\n")},
        {"cameras", "COLMAP, a fisheye", with_file("sparse/cameras.txt", "1 OPENCV_FISHEYE 64 48 60 60 32 24 0.01 0 0 0\n")},
        {"cameras", "COLMAP, one camera of many unused ones", starts_with("sparse/cameras.txt", "5 SIMPLE_PINHOLE 10 10 5 5 5\n6 SIMPLE_RADIAL 10 10 5 5 5 0\n")},
        {"cameras", "--cameras names images.txt", nothing(), Command{with("--cameras {scan}/sparse/images.txt")}},
        {"cameras", "--cameras names a missing file", nothing(), Exit::input, Says{"none.out"}, no_package, Command{with("--cameras {scan}/none.out")}},
        {"cameras", "--cameras names a photo", nothing(), Exit::input, Says{"not a known camera format; expected COLMAP"}, no_package, Command{with("--cameras {scan}/images/A.jpg")}},
        {"cameras", "Bundler", with_list("A.jpg\nB.jpg\nC.jpg\n"), Says{"(Bundler)"}},
        {"cameras", "Bundler with focal lengths", with_list("A.jpg 0 60.5\nB.jpg 0 60\nC.jpg 0 61.25\n")},
        {"cameras", "Bundler with folders", with_list("./images/A.jpg 0 60.5\nimages/B.jpg\n/data/C.jpg\n")},
        {"cameras", "Bundler with paths of Windows", with_list("C:\\scan\\images\\A.jpg\nimages\\B.jpg 0 60\n.\\C.jpg\n")},
        {"cameras", "Bundler with blanks", [](Scan& s) { use_bundler(s, "my photo 1.jpg\nB.jpg\nC.jpg\n"); s.move("images/A.jpg", "images/my photo 1.jpg"); }, Holds{"my photo 1.jpg=red"}},
        {"cameras", "Bundler with blanks and focal lengths", [](Scan& s) { use_bundler(s, "my photo 1.jpg 0 60.5\nB.jpg 0 60\nC.jpg 0 60\n"); s.move("images/A.jpg", "images/my photo 1.jpg"); }, Holds{"my photo 1.jpg=red"}},
        {"cameras", "Bundler with quotes", [](Scan& s) { use_bundler(s, "\"my photo.jpg\"\n\"B.jpg\"\nC.jpg\n"); s.move("images/A.jpg", "images/my photo.jpg"); }, Holds{"my photo.jpg=red"}},
        {"cameras", "Bundler with blank lines in the list", with_list("A.jpg\n\nB.jpg\n\n\nC.jpg\n\n")},
        {"cameras", "Bundler without a list", [](Scan& s) { use_bundler(s, ""); s.remove("list.txt"); }, Exit::input, Says{"expected a list.txt"}},
        {"cameras", "Bundler with a short list", with_list("A.jpg\nB.jpg\n"), Exit::input, Says{"has 3 cameras, but its list has 2 photo names"}},
        {"cameras", "Bundler, unregistered camera", [](Scan& s) { use_bundler(s, "A.jpg\nB.jpg\nC.jpg\n"); s.replace("bundle.out", "# Bundle file v0.3\n3 0\n60 0 0\n", "# Bundle file v0.3\n3 0\n0 0 0\n"); }, Exit::incomplete, Says{"A.jpg: not registered by Bundler"}, Holds{"B.jpg=green C.jpg=blue;"}},
        {"cameras", "Bundler, truncated", [](Scan& s) { use_bundler(s, "A.jpg\nB.jpg\nC.jpg\n"); s["bundle.out"].resize(200); }, Exit::input, Says{"bundle.out, line"}},
        {"cameras", "Bundler, more cameras than numbers", [](Scan& s) { use_bundler(s, "A.jpg\n"); s["bundle.out"] = "# Bundle file v0.3\n99999999999 0\n"; }, Exit::input, Says{"has 99999999999 cameras"}},
        {"cameras", "an empty model beside a Bundler file", [](Scan& s) { use_bundler(s, "A.jpg\nB.jpg\nC.jpg\n"); s["sparse/cameras.txt"] = s["sparse/images.txt"] = "# none\n"; }, Says{"sparse (COLMAP): not used, expected an image with a pose in images.txt, found none; bundle.out has 3"}},
        {"cameras", "a model of one photo beside a Bundler file", [](Scan& s) { s["bundle.out"] = bundle(); s["list.txt"] = "A.jpg\nB.jpg\nC.jpg\n"; s["sparse/images.txt"] = colmap_images({"A.jpg"}); }, Says{"sparse (COLMAP): not used, has 1 cameras; bundle.out has 3"}},
        {"cameras", "a copy in a folder that comes first", [](Scan& s) { use_bundler(s, "A.jpg\nB.jpg\nC.jpg\n"); s["a/list.txt"] = "A.jpg\nB.jpg\nC.jpg\n"; s["a/bundle.out"] = s["bundle.out"]; }, Says{"a/bundle.out: not used, has 3 cameras; bundle.out has 3"}},
        {"cameras", "more cameras, none of these photos", [](Scan& s) { s.copy("sparse", "sparse/0"); s["sparse/1/cameras.txt"] = s["sparse/cameras.txt"]; s["sparse/1/images.txt"] = colmap_images({"A.jpg"}); s["sparse/0/images.txt"] = colmap_images({"X.jpg", "Y.jpg", "Z.jpg"}); s.remove("sparse/cameras.txt"); s.remove("sparse/images.txt"); }, Exit::incomplete, Says{"sparse/0: not used, has 3 cameras; sparse/1 has 1"}, Holds{"A.jpg=red;"}},
        {"cameras", "two Bundler files", [](Scan& s) { use_bundler(s, "A.jpg\nB.jpg\nC.jpg\n"); s["a/bundle.out"] = bundle(1); s["a/list.txt"] = "A.jpg\n"; }, Says{"a/bundle.out: not used, has 1 cameras; bundle.out has 3"}},
        {"cameras", "MeshLab", [](Scan& s) { use_meshlab(s, {"A.jpg", "B.jpg", "C.jpg"}); }, Says{"(MeshLab)"}},
        {"cameras", "MeshLab with folders", [](Scan& s) { use_meshlab(s, {"images/A.jpg", "images\\B.jpg", "C:/x/C.jpg"}); }},
        {"cameras", "MeshLab, not XML", with_file("../scan/x.mlp", ""), Says{"(COLMAP text)"}},
        {"cameras", "MeshLab, broken XML", [](Scan& s) { use_meshlab(s, {"A.jpg"}); s["project.mlp"].resize(300); }, Exit::input, Says{"project.mlp: expected a MeshLab project"}},
        {"cameras", "MeshLab, no rasters", [](Scan& s) { use_meshlab(s, {}); }, Exit::input, Says{"expected a raster with a camera, found none"}},
        {"cameras", "REALVIZ", nothing(), Exit::input, Says{"not a known camera format"}, no_package, Command{with("--cameras {scan}/mesh.ply")}},

        // -------------------------------------------------------------------------------------------- meshes
        {"meshes", "OBJ", with_mesh("mesh.obj", box_obj())},
        {"meshes", "OBJ with lines that go on", with_mesh("mesh.obj", changed(changed(box_obj(), "f 1 3 2\n", "f 1 \\\n3 \\\n2\n"), "v 1 1 1\n", "v 1 \\\r\n1 1\n"))},
        {"meshes", "OBJ with negative indices", with_mesh("mesh.obj", changed(box_obj(), "f 1 3 2\n", "f -8 -6 -7\n"))},
        {"meshes", "OBJ with texture coordinates and normals", with_mesh("mesh.obj", "vn 0 0 1\nvt 0 0\n" + changed(changed(box_obj(), "f 1 3 2\n", "f 1/1/1 3/1/1 2/1/1\n"), "f 1 4 3\n", "f 1//1 4/1 3\n"))},
        {"meshes", "OBJ with quads", with_mesh("mesh.obj", changed(changed(box_obj(), "f 1 3 2\n", "f 1 4 3 2\n"), "f 1 4 3\n", ""))},
        {"meshes", "OBJ with groups, materials, lines and points", with_mesh("mesh.obj", "mtllib none.mtl\no box\ng a b\ns off\n" + box_obj() + "usemtl x\nl 1 2\np 1\ncurv 0 1 1 2\n")},
        {"meshes", "OBJ with several objects", with_mesh("mesh.obj", several_objects())},
        {"meshes", "OBJ with comments after values", with_mesh("mesh.obj", changed(box_obj(), "f 1 3 2\n", "f 1 3 2 # first\n"))},
        {"meshes", "OBJ with an index out of range", with_mesh("mesh.obj", box_obj() + "f 1 2 99\n"), Says{"1 invalid triangles dropped"}},
        {"meshes", "OBJ with index 0", with_mesh("mesh.obj", box_obj() + "f 0 1 2\n"), Says{"1 invalid triangles dropped"}},
        {"meshes", "OBJ with a word for a number", with_mesh("mesh.obj", changed(box_obj(), "v 1 1 1\n", "v 1 x 1\n")), Exit::input, Says{"mesh.obj, line", "expected a number, found 'x'"}},
        {"meshes", "OBJ without faces", with_mesh("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), Exit::input, Says{"mesh.obj: has points only"}},
        {"meshes", "OBJ in capitals: MESH.OBJ", with_mesh("MESH.OBJ", box_obj())},
        {"meshes", "OFF", with_mesh("mesh.off", box_off())},
        {"meshes", "OFF with comments", with_mesh("mesh.off", box_off("# by hand\nOFF # kind\n# counts\n8 12 0 # edges unknown\n# vertices\n", " # corner"))},
        {"meshes", "OFF with the counts on the first line", with_mesh("mesh.off", box_off("OFF 8 12 0\n"))},
        {"meshes", "OFF without the number of edges", with_mesh("mesh.off", box_off("OFF\n8 12\n"))},
        {"meshes", "OFF without the word", with_mesh("mesh.off", box_off("8 12 0\n"))},
        {"meshes", "OFF with face colors", with_mesh("mesh.off", box_off("OFF\n8 12 0\n", "", " 0.2 0.4 0.6"))},
        {"meshes", "OFF with integer face colors", with_mesh("mesh.off", box_off("OFF\n8 12 0\n", "", " 255 0 0 255"))},
        {"meshes", "OFF with a face color index", with_mesh("mesh.off", box_off("OFF\n8 12 0\n", "", " 7"))},
        {"meshes", "OFF with blank lines", with_mesh("mesh.off", box_off("\nOFF\n\n8 12 0\n\n"))},
        {"meshes", "NOFF", with_mesh("mesh.off", box_off("NOFF\n8 12 0\n", " 0 0 1"))},
        {"meshes", "OFF that is truncated", with_mesh("mesh.off", box_off().substr(0, 100)), Exit::input, Says{"mesh.off, line", "found the end of the file"}},
        {"meshes", "OFF that claims more than it has", with_mesh("mesh.off", box_off("OFF\n99999999999 12 0\n")), Exit::input, Says{"mesh.off, line"}},
        {"meshes", "OFF of four dimensions", with_mesh("mesh.off", box_off("4OFF\n8 12 0\n", " 1")), Exit::input, Says{"expected OFF, COFF, NOFF or STOFF, found"}},
        {"meshes", "STL", with_mesh("mesh.stl", box_stl())},
        {"meshes", "STL, binary", with_mesh("mesh.stl", box_stl_binary())},
        {"meshes", "STL, binary, starts with solid", with_mesh("mesh.stl", "solid" + box_stl_binary().substr(5))},
        {"meshes", "STL, binary, truncated", with_mesh("mesh.stl", box_stl_binary().substr(0, 300)), Exit::input, Says{"mesh.stl"}},
        {"meshes", "STL in capitals", with_mesh("MESH.STL", box_stl())},
        {"meshes", "glTF", with_gltf("mesh.gltf", "mesh.bin")},
        {"meshes", "glTF whose buffer has a blank in its name", with_gltf("mesh.gltf", "my%20mesh.bin")},
        {"meshes", "glTF whose buffer is missing", with_mesh("mesh.gltf", box_gltf().json("mesh.bin")), Exit::input, Says{"mesh.gltf: its buffer mesh.bin is missing"}},
        {"meshes", "glTF, checked, with another buffer", both(with_gltf("mesh.gltf", "mesh.bin"), with_file("half.bin", box_gltf({.scale = 0.5}).bytes)), Exit::stale, Says{"mesh.bin: has changed"}, no_package, Command{std::string(prepare_command) + " ; cp {scan}/half.bin {scan}/mesh.bin ; vantage check --against {scan} {out}.vantage"}},
        {"meshes", "glTF, again, with another buffer", both(with_gltf("mesh.gltf", "mesh.bin"), with_file("half.bin", box_gltf({.scale = 0.5}).bytes)), Holds{"1 x 1 x 1, area 6"}, Command{std::string(prepare_command) + " ; cp {scan}/half.bin {scan}/mesh.bin ; " + prepare_command}},
        {"meshes", "glTF, again, nothing to do", with_gltf("mesh.gltf", "mesh.bin"), Says{"is current, nothing to do"}, Command{std::string(prepare_command) + " ; " + prepare_command}},
        {"meshes", "glTF with compressed buffers", [](Scan& s) { GltfFile box = box_gltf(); box.more = ", \"extensionsRequired\": [\"EXT_meshopt_compression\"]"; s.remove("mesh.ply"); s["mesh.glb"] = box.glb(); }, Exit::input, Says{"mesh.glb: needs the glTF extension EXT_meshopt_compression, which is not supported"}},
        {"meshes", "GLB", with_mesh("mesh.glb", box_gltf().glb())},
        {"meshes", "GLB in capitals: MESH.GLB", with_mesh("MESH.GLB", box_gltf().glb())},
        {"meshes", "GLB that is truncated", with_mesh("mesh.glb", box_gltf().glb().substr(0, 700)), Exit::input, Says{"mesh.glb: is cut off: its header counts"}},
        {"meshes", "GLB beside a PLY", with_file("mesh.glb", box_gltf({.scale = 0.5}).glb())},
        {"meshes", "GLB placed by its node", [](Scan& s) { GltfFile box = box_gltf({.x = 8}); box.nodes = ""; box.add_node("\"mesh\": 0, \"scale\": [0.5, 0.5, 0.5], \"translation\": [-4, 0, 0]"); s.remove("mesh.ply"); s["mesh.glb"] = box.glb(); }, Holds{"A.jpg=red B.jpg=green C.jpg=blue; 1 x 1 x 1, area 6"}},
        {"meshes", "FBX", with_mesh("mesh.fbx", box_fbx()), Says{"mesh.fbx: says that its unit is 1 cm; its coordinates are taken as written"}},
        {"meshes", "FBX in capitals: MESH.FBX", with_mesh("MESH.FBX", box_fbx())},
        {"meshes", "FBX that is truncated", with_mesh("mesh.fbx", box_fbx().substr(0, 300)), Exit::input, Says{"mesh.fbx: "}},
        {"meshes", "an OBJ named mesh.fbx", with_mesh("mesh.fbx", box_obj()), Exit::input, Says{"mesh.fbx: cannot be read: "}},
        {"meshes", "USD", with_mesh("mesh.usdz", "PK"), Exit::input, Says{"mesh.usdz: USD is not supported; expected PLY, OBJ or GLB"}},
        {"meshes", "USD beside a PLY", with_file("mesh.usdc", "PXR-USDC")},
        {"meshes", "PLY with vertex_index", text("mesh.ply", "vertex_indices", "vertex_index")},
        {"meshes", "PLY with vertex_indexes", text("mesh.ply", "vertex_indices", "vertex_indexes")},
        {"meshes", "PLY with an unknown list", text("mesh.ply", "vertex_indices", "corners"), Exit::input, Says{"points only"}},
        {"meshes", "PLY with obj_info and comments", text("mesh.ply", "element vertex", "obj_info x\ncomment TextureFile a.png\nelement vertex")},
        {"meshes", "PLY with texture coordinates per face", [](Scan& s) { s.replace("mesh.ply", "vertex_indices\n", "vertex_indices\nproperty list uchar float texcoord\n"); for (const char* f : {"3 0 2 1", "3 0 3 2", "3 4 5 6", "3 4 6 7", "3 0 1 5", "3 0 5 4", "3 1 2 6", "3 1 6 5", "3 2 3 7", "3 2 7 6", "3 3 0 4", "3 3 4 7"}) s.replace("mesh.ply", std::string("\n") + f + "\n", std::string("\n") + f + " 6 0 0 1 0 1 1\n"); }},
        {"meshes", "PLY with edges", [](Scan& s) { s.replace("mesh.ply", "end_header", "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header"); s["mesh.ply"] += "0 1\n"; }},
        {"meshes", "PLY with normals of zero", with_mesh("mesh.ply", box_ply_with("property float nx\nproperty float ny\nproperty float nz\n", "0 0 0"))},
        {"meshes", "PLY with nan quality", with_mesh("mesh.ply", box_ply_with("property float quality\n", "nan"))},
        {"meshes", "PLY that is truncated", [](Scan& s) { s["mesh.ply"].resize(300); }, Exit::input, Says{"mesh.ply: expected more values: the file is truncated"}},
        {"meshes", "PLY that claims more than it has", text("mesh.ply", "element vertex 8", "element vertex 4000000000"), Exit::input, Says{"the file is truncated"}},
        {"meshes", "PLY without x", text("mesh.ply", "property double x", "property double u"), Exit::input, Says{"expected vertices with x, y and z"}},
        {"meshes", "PLY with an unknown type", text("mesh.ply", "property double x", "property half x"), Exit::input, Says{"expected a PLY property type, found 'half'"}},
        {"meshes", "PLY with an unused vertex far away", [](Scan& s) { s.replace("mesh.ply", "element vertex 8", "element vertex 9"); s.replace("mesh.ply", "\n3 0 2 1\n", "\n1e9 1e9 1e9\n3 0 2 1\n"); }},
        {"meshes", "PLY with a triangle that reaches far away", [](Scan& s) { s.replace("mesh.ply", "element vertex 8\n", "element vertex 9\n"); s.replace("mesh.ply", "element face 12\n", "element face 13\n"); s.replace("mesh.ply", "\n3 0 2 1\n", "\n0 0 1e6\n3 0 2 1\n"); s["mesh.ply"] += "3 6 7 8\n"; }, Says{"mesh.ply: vertex 8 of triangle 12 (counted from 0) at (0, 0, 1000000) lies 1e+06 from the rest of the mesh, which is 3.46 in size"}, Holds{"A.jpg=red B.jpg=green C.jpg=blue"}},
        {"meshes", "a PLY named mesh.obj", with_mesh("mesh.obj", box_ply()), Exit::input, Says{"mesh.obj"}},
        {"meshes", "an HTML page named mesh.ply", with_mesh("mesh.ply", "<!DOCTYPE html><html>404</html>"), Exit::input, Says{"mesh.ply: expected a PLY header"}},
        {"meshes", "in UTM, cameras too far", mesh_at({.x = 512000, .y = 4200000, .z = 300}), Exit::misplaced, Says{"mesh.ply", "mesh from (511999, 4199999, 299) to (512001, 4200001, 301), cameras from (-2.7", "cameras from"}},
        {"meshes", "1000 times as large", mesh_at({.scale = 1000, .x = 3000}), Exit::misplaced, Says{"mesh from", "cameras from"}},
        {"meshes", "1000 times as large, cameras inside", mesh_at({.scale = 1000}), Holds{"2000 x 2000 x 2000"}},
        {"meshes", "a thousandth of the size", mesh_at({.scale = 0.001}), Exit::misplaced, Says{"mesh from (-0.001, -0.001, -0.001) to (0.001, 0.001, 0.001)"}},
        {"meshes", "moved away", mesh_at({.x = 100}), Exit::misplaced, Says{"mesh from (99, -1, -1) to (101, 1, 1)", "cameras from"}},
        {"meshes", "moved behind the cameras", mesh_at({.z = -40}), Exit::misplaced, Says{"3 of 3 photos"}},
        {"meshes", "half the size", mesh_at({.scale = 0.5}), Holds{"A.jpg=red B.jpg=green C.jpg=blue; 1 x 1 x 1, area 6"}},
        

        // -------------------------------------------------------------------------------------------- colors
        {"colors", "PLY, uchar", with_mesh("mesh.ply", box_ply_with("property uchar red\nproperty uchar green\nproperty uchar blue\n", "204 64 51")), red_box},
        {"colors", "PLY, float up to 1", with_mesh("mesh.ply", box_ply_with("property float red\nproperty float green\nproperty float blue\n", "0.8 0.25 0.2")), red_box},
        {"colors", "PLY, float up to 255", with_mesh("mesh.ply", box_ply_with("property float red\nproperty float green\nproperty float blue\n", "204 64 51")), red_box},
        {"colors", "PLY, double up to 65535", with_mesh("mesh.ply", box_ply_with("property double red\nproperty double green\nproperty double blue\n", "52428 16448 13107")), red_box},
        {"colors", "PLY, ushort up to 255", with_mesh("mesh.ply", box_ply_with("property ushort red\nproperty ushort green\nproperty ushort blue\n", "204 64 51")), red_box},
        {"colors", "PLY, ushort up to 65535", with_mesh("mesh.ply", box_ply_with("property ushort red\nproperty ushort green\nproperty ushort blue\n", "52428 16448 13107")), red_box},
        {"colors", "PLY, int", with_mesh("mesh.ply", box_ply_with("property int red\nproperty int green\nproperty int blue\n", "204 64 51")), red_box},
        {"colors", "PLY, diffuse_red", with_mesh("mesh.ply", box_ply_with("property uchar diffuse_red\nproperty uchar diffuse_green\nproperty uchar diffuse_blue\n", "204 64 51")), red_box},
        {"colors", "PLY, r g b", with_mesh("mesh.ply", box_ply_with("property uchar r\nproperty uchar g\nproperty uchar b\n", "204 64 51")), red_box},
        {"colors", "PLY, float up to 255 and alpha 1", with_mesh("mesh.ply", box_ply_with("property float red\nproperty float green\nproperty float blue\nproperty float alpha\n", "204 64 51 1")), red_box},
        {"colors", "PLY, blue before red", with_mesh("mesh.ply", box_ply_with("property uchar blue\nproperty uchar green\nproperty uchar red\n", "51 64 204")), red_box},
        {"colors", "PLY, nan", with_mesh("mesh.ply", box_ply_with("property float red\nproperty float green\nproperty float blue\n", "nan 0.5 0.5")), Holds{"(0,128,128)"}},
        {"colors", "PLY, red only", with_mesh("mesh.ply", box_ply_with("property uchar red\n", "204"))},
        {"colors", "OBJ, up to 1", with_mesh("mesh.obj", box_obj(" 0.8 0.25 0.2")), red_box},
        {"colors", "OBJ, up to 255", with_mesh("mesh.obj", box_obj(" 204 64 51")), red_box},
        {"colors", "OBJ, up to 255 with alpha", with_mesh("mesh.obj", box_obj(" 204 64 51 255")), red_box},
        {"colors", "OBJ, a weight only", with_mesh("mesh.obj", box_obj(" 1.0"))},
        {"colors", "OBJ with a face of glass in its MTL", [](Scan& s) { s.remove("mesh.ply"); s["mesh.obj"] = "mtllib box.mtl\n" + changed(box_obj(), "f 1 3 2\n", "usemtl glass\nf 1 3 2\nusemtl frame\n"); s["box.mtl"] = "newmtl glass\nKd 0.8 0.25 0.2\nd 0.5\n"; }, Says{"triangles have a vertex with alpha below 255"}, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; vantage info {out}.vantage"}},
        {"colors", "OBJ, checked, with another MTL", [](Scan& s) { s.remove("mesh.ply"); s["mesh.obj"] = "mtllib box.mtl\n" + changed(box_obj(), "f 1 3 2\n", "usemtl glass\nf 1 3 2\nusemtl frame\n"); s["box.mtl"] = "newmtl glass\nd 0.5\n"; s["other.mtl"] = "newmtl glass\nd 0.4\n"; }, Exit::stale, Says{"box.mtl: has changed"}, no_package, Command{std::string(prepare_command) + " ; cp {scan}/other.mtl {scan}/box.mtl ; vantage check --against {scan} {out}.vantage"}},
        {"colors", "OBJ, checked, whose opaque MTL became glass", [](Scan& s) { s.remove("mesh.ply"); s["mesh.obj"] = "mtllib box.mtl\nusemtl glass\n" + box_obj(); s["box.mtl"] = "newmtl glass\n"; s["other.mtl"] = "newmtl glass\nd 0.4\n"; }, Exit::stale, Says{"box.mtl: has changed"}, no_package, Command{std::string(prepare_command) + " ; cp {scan}/other.mtl {scan}/box.mtl ; vantage check --against {scan} {out}.vantage"}},
        {"colors", "OBJ, checked, whose MTL was missing", [](Scan& s) { s.remove("mesh.ply"); s["mesh.obj"] = "mtllib new.mtl\nusemtl glass\n" + box_obj(); s["other.mtl"] = "newmtl glass\nd 0.4\n"; }, Exit::stale, Says{"new.mtl: was added after the package was prepared"}, no_package, Command{std::string(prepare_command) + " ; cp {scan}/other.mtl {scan}/new.mtl ; vantage check --against {scan} {out}.vantage"}},
        {"colors", "OBJ whose MTL is missing", with_mesh("mesh.obj", "mtllib none.mtl\nusemtl glass\n" + box_obj()), Says{"mesh.obj: its material file none.mtl is missing"}},
        {"colors", "PLY with alpha 0 everywhere", with_mesh("mesh.ply", box_ply_with("property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n", "204 64 51 0")), Says{"taken as alpha that was never set"}, Holds{"area 24, vertices red (204,64,51)"}, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; vantage info {out}.vantage"}},
        {"colors", "COFF, up to 255", with_mesh("mesh.off", box_off("COFF\n8 12 0\n", " 204 64 51 255")), red_box},
        {"colors", "COFF, up to 1", with_mesh("mesh.off", box_off("COFF\n8 12 0\n", " 0.8 0.25 0.2 1.0")), red_box},
        {"colors", "COFF without alpha", with_mesh("mesh.off", box_off("COFF\n8 12 0\n", " 204 64 51")), red_box},
        {"colors", "OFF with vertex colors all the same", with_mesh("mesh.off", box_off("OFF\n8 12 0\n", " 204 64 51 255")), red_box},

        // -------------------------------------------------------------------------------------------- photos
        {"photos", "PNG", photos_as(".png"), Holds{"A.png=red B.png=green C.png=blue"}},
        {"photos", "TIFF", photos_as(".tif"), Holds{"A.tif=red B.tif=green C.tif=blue"}},
        {"photos", "WebP", photos_as(".webp"), Holds{"A.webp=red B.webp=green C.webp=blue"}},
        {"photos", "BMP", photos_as(".bmp"), Holds{"A.bmp=red B.bmp=green C.bmp=blue"}},
        {"photos", "EXR", photos_as(".exr"), Says{"A.exr and 2 other photos hold linear light: converted to sRGB"}, Holds{"A.exr=red B.exr=green C.exr=blue"}},
        {"photos", "Radiance HDR", photos_as(".hdr"), Says{"A.hdr and 2 other photos hold linear light: converted to sRGB"}, Holds{"A.hdr=red B.hdr=green C.hdr=blue"}},
        {"photos", "EXR, linear 0.216 is sRGB 128", with_photo_a(".exr", photo(".exr", 0.21586, 0.21586, 0.21586)), Holds{"A.exr=gray(128)"}},
        {"photos", "Radiance HDR, linear 0.216 is sRGB 128", with_photo_a(".hdr", photo(".hdr", 0.21586, 0.21586, 0.21586)), Holds{"A.hdr=gray(128)"}},
        {"photos", "EXR, linear 0.001 is sRGB 0.0129", with_photo_a(".exr", photo(".exr", 0.001, 0.001, 0.001)), Holds{"A.exr=gray(3)"}},
        {"photos", "EXR, brighter than 1", with_photo_a(".exr", photo(".exr", 7, 7, 7)), Says{"what is brighter than 1 is clipped"}, Holds{"A.exr=white"}},
        {"photos", "EXR, negative", with_photo_a(".exr", photo(".exr", -1, -1, -1)), Holds{"A.exr=gray(0)"}},
        {"photos", "EXR, nan", with_photo_a(".exr", photo(".exr", std::nan(""), std::nan(""), std::nan(""))), Holds{"A.exr=gray(0)"}},
        {"photos", "EXR, infinite", with_photo_a(".exr", photo(".exr", INFINITY, INFINITY, INFINITY)), Holds{"A.exr=white"}},
        {"photos", "PNG is not linear", with_photo_a(".png", photo(".png", 1, 1, 1)), Holds{"A.png=gray(248)"}, Never{"linear"}},
        {"photos", "one EXR among JPEG", [](Scan& s) { s.remove("images/A.jpg"); s["images/A.exr"] = red(".exr"); }, Says{"A.exr holds linear light"}, Holds{"A.exr=red B.jpg=green"}},
        {"photos", "metadata of 256 KiB before the size", [](Scan& s) { s["images/A.jpg"] = with_metadata(s["images/A.jpg"], 256 << 10); }},
        {"photos", "metadata of 3 MiB before the size", [](Scan& s) { s["images/A.jpg"] = with_metadata(s["images/A.jpg"], 3 << 20); }},
        {"photos", "a JPEG named .png", moved("images/A.jpg", "images/A.png"), Holds{"A.png=red"}},
        {"photos", "a PNG named .jpg", with_file("images/A.jpg", red(".png"))},
        {"photos", "a truncated JPEG", [](Scan& s) { s["images/C.jpg"].resize(700); }, Exit::incomplete, Says{"left out C.jpg"}, Holds{"A.jpg=red B.jpg=green"}},
        {"photos", "an empty JPEG", with_file("images/C.jpg", ""), Exit::incomplete, Says{"left out C.jpg"}, Holds{"A.jpg=red B.jpg=green"}},
        {"photos", "an HTML page named .jpg", with_file("images/C.jpg", "<html>404</html>"), Exit::incomplete, Says{"left out C.jpg"}, Holds{"A.jpg=red B.jpg=green"}},
        {"photos", "a text file named .heic", named("A.heic", "A.heic"), Holds{"A.heic=red"}},
        {"photos", "a HEIC that cannot be read", [](Scan& s) { s.remove("images/A.jpg"); s["images/A.HEIC"] = std::string("\0\0\0\x18""ftypheic", 12) + std::string(200, 'x'); }, Exit::incomplete, Says{"left out A.HEIC", "convert the photos to JPEG"}, Holds{"B.jpg=green C.jpg=blue"}},
        {"photos", "all photos truncated", [](Scan& s) { for (const char* n : {"A", "B", "C"}) s[std::string("images/") + n + ".jpg"].resize(20); }, Exit::input, Says{blocked}},
        {"photos", "gray", with_file("images/A.jpg", photo(".jpg", 0.5, 0.5, 0.5)), Holds{"A.jpg=gray(12"}},
        {"photos", "in Adobe RGB", with_profile_a(icc_profile(adobe_rgb)), Says{"A.jpg holds the color profile 'Adobe RGB (1998)': converted to sRGB, what is outside it is clipped"}},
        {"photos", "in Display P3, two of them", [](Scan& s) { for (const char* n : {"A", "B"}) { std::string& photo = s[std::string("images/") + n + ".jpg"]; photo = with_profile(photo, icc_profile(display_p3)); } }, Says{"A.jpg and another photo hold the color profile 'Display P3': converted"}},
        {"photos", "in sRGB, by their profile", with_profile_a(icc_profile(srgb)), Never{"profile"}},
        {"photos", "in linear light, by their profile", with_file("images/A.jpg", linear_gray()), Says{"A.jpg holds the color profile 'Linear sRGB'"}, Holds{"A.jpg=gray(12"}},
        {"photos", "in Adobe RGB, prepared again", with_profile_a(icc_profile(adobe_rgb)), Says{"nothing to do"}, Command{again}},
        {"photos", "a damaged color profile", with_profile_a("none"), Says{"A.jpg holds a color profile, which cannot be used because it is damaged: taken as sRGB"}},
        {"photos", "a color profile of grays", with_profile_a(gray_profile(2.2)), Says{"A.jpg holds the color profile 'Gray', which cannot be used because it is not for RGB: taken as sRGB"}},
        {"photos", "a RAW file that cannot be read", both(moved("images/C.jpg", "images/C.IIQ"), [](Scan& s) { s["images/C.IIQ"] = std::string(1000, 'r'); cameras_named({"A.jpg", "B.jpg", "C.IIQ"})(s); }), Exit::incomplete, Says{"left out C.IIQ: not a readable photo", "Unsupported file format or not RAW file"}, Holds{"A.jpg=red B.jpg=green;"}},
        {"photos", "turned by 90 degrees, as their EXIF says", [](Scan& s) { s.remove("images/C.jpg"); s["images/C.tif"] = photo(".tif", 0.25, 0.3, 0.8, 48, 64, 6); }, Holds{"A.jpg=red B.jpg=green C.tif=blue"}},
        {"photos", "turned by 90 degrees", with_file("images/C.jpg", photo(".jpg", 0, 0, 1, 48, 64)), Exit::incomplete, Says{"left out C.jpg"}, Holds{"A.jpg=red B.jpg=green"}},
        {"photos", "turned by 90 degrees, inspected", with_file("images/C.jpg", photo(".jpg", 0, 0, 1, 48, 64)), Exit::incomplete, Says{"left out C.jpg: is 48x64, but its camera expects 64x48"}, no_package, Command{"vantage inspect {scan}"}},
        {"photos", "twice the size and turned by 90 degrees, as their EXIF says", [](Scan& s) { s.remove("images/C.jpg"); s["images/C.tif"] = photo(".tif", 0.25, 0.3, 0.8, 96, 128, 6); }, Says{"C.tif: is 96x128, but its camera expects 64x48; scaled the camera"}, Holds{"A.jpg=red B.jpg=green C.tif=blue"}},
        {"photos", "turned by 90 degrees, as a long number in their EXIF says", [](Scan& s) { s["images/C.jpg"] = photo(".jpg", 0.25, 0.3, 0.8, 48, 64).insert(2, std::string("\xff\xe1\0\x22""Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x04\0\0\0\x01\0\0\0\x06\0\0\0\0", 36)); }, Holds{"A.jpg=red B.jpg=green C.jpg=blue"}},
        {"photos", "twice the size, all", [](Scan& s) { s["images/A.jpg"] = photo(".jpg", 0.8, 0.25, 0.2, 128, 96); }, Says{"A.jpg: is 128x96, but its camera expects 64x48; scaled the camera"}},

        // ------------------------------------------------------------------------------------------- options
        {"options", "all photos held out", nothing(), Exit::usage, Says{"--hold-out: all 3 photos are held out"}, no_package, Command{with("--hold-out A,B,C")}},
        {"options", "one photo held out", nothing(), Holds{"-A.jpg B.jpg=green C.jpg=blue"}, Command{with("--hold-out A")}},
        {"options", "an unknown photo held out", nothing(), Exit::usage, Says{"--hold-out X: the scene has no such photo"}, no_package, Command{with("--hold-out X")}},
        {"options", "--memory -5", nothing(), Exit::usage, Says{"--memory"}, no_package, Command{with("--memory -5")}},
        {"options", "--memory nonsense", nothing(), Exit::usage, Says{"--memory"}, no_package, Command{with("--memory lots")}},
        {"options", "--memory 1", nothing(), Exit::usage, Says{"--memory 1: ", "may need up to"}, no_package, Command{with("--memory 1")}},
        {"options", "--memory 2G", nothing(), Command{with("--memory 2G")}},
        {"options", "--memory 99999999999999999999", nothing(), Exit::usage, Says{"--memory"}, no_package, Command{with("--memory 99999999999999999999")}},
        {"options", "--threads 100000", nothing(), Exit::usage, Says{"--threads"}, no_package, Command{with("--threads 100000")}},
        {"options", "--threads -1", nothing(), Exit::usage, Says{"--threads"}, no_package, Command{with("--threads -1")}},
        {"options", "--threads 1", nothing(), Command{with("--threads 1")}},
        {"options", "--threads 64", nothing(), Command{with("--threads 64")}},
        {"options", "--shard 0/3", nothing(), Exit::usage, Says{"--shard 0/3: expected"}, no_package, Command{with("--shard 0/3")}},
        {"options", "--shard 4/3", nothing(), Exit::usage, Says{"--shard 4/3: expected"}, no_package, Command{with("--shard 4/3")}},
        {"options", "--shard 4294967297/4294967298", nothing(), Exit::usage, Says{"--shard 4294967297/4294967298: expected"}, no_package, Command{with("--shard 4294967297/4294967298")}},
        {"options", "--shard -1/3", nothing(), Exit::usage, Says{"--shard"}, no_package, Command{with("--shard -1/3")}},
        {"options", "--shard 1/3x", nothing(), Exit::usage, Says{"--shard 1/3x: expected"}, no_package, Command{with("--shard 1/3x")}},
        {"options", "--shard 1/1000000", nothing(), Exit::usage, Says{"--shard 1/1000000: expected"}, no_package, Command{with("--shard 1/1000000")}},
        {"options", "--border-width nan", nothing(), Exit::usage, Says{"--border-width"}, no_package, Command{with("--border-width nan")}},
        {"options", "--border-distance fast", nothing(), Exit::usage, Says{"fast"}, no_package, Command{with("--border-distance fast")}},
        {"options", "--effect none=on", nothing(), Exit::usage, Says{"none"}, no_package, Command{with("--effect none=on")}},
        {"options", "--preset of a missing file", nothing(), Exit::usage, Says{"none"}, no_package, Command{with("--preset none")}},
        {"options", "--preset with a wrong key", with_file("c.toml", "colour = 1\n"), Exit::usage, Says{"c.toml: colour: unknown setting"}, no_package, Command{with("--preset {scan}/c.toml")}},
        {"options", "--preset with a wrong value", with_file("c.toml", "threads = -3\n"), Exit::usage, Says{"c.toml"}, no_package, Command{with("--preset {scan}/c.toml")}},
        {"options", "--preset with memory -5", with_file("c.toml", "memory = -5\n"), Exit::usage, Says{"c.toml"}, no_package, Command{with("--preset {scan}/c.toml")}},
        {"options", "an unknown option", nothing(), Exit::usage, Says{"--frobnicate"}, no_package, Command{with("--frobnicate")}},
        {"options", "no verb", nothing(), Exit::usage, Says{"no verb: expected one of"}, no_package, Command{"vantage"}},
        {"options", "-o in a missing folder", nothing(), Exit::storage, Says{"none/x.vantage"}, no_package, Command{"vantage prepare {scan} -o {out}/none/x.vantage"}, Never{"18446744073"}},
        {"options", "no libEGL, offscreen", with_file("lib/libEGL.so.1", ""), Exit::graphics, Says{"cannot load libEGL.so.1"}, no_package, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; env LD_LIBRARY_PATH={scan}/lib vantage-player {out}.vantage --offscreen --photo A -o {out}.png"}},
        {"options", "no libEGL, prepared by the processor", with_file("lib/libEGL.so.1", ""), Command{"env LD_LIBRARY_PATH={scan}/lib vantage prepare {scan} -o {out}.vantage --no-report"}},
        {"options", "no libEGL, --renderer opengl", with_file("lib/libEGL.so.1", ""), Exit::graphics, Says{"cannot load libEGL.so.1"}, no_package, Command{"env LD_LIBRARY_PATH={scan}/lib vantage prepare {scan} -o {out}.vantage --no-report --renderer opengl"}},
        {"options", "a file size limit, the player", nothing(), Exit::storage, Says{"out.png"}, no_package, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; env MESA_SHADER_CACHE_DISABLE=1 prlimit --fsize=100 vantage-player {out}.vantage --offscreen --photo A -o {out}.png"}},
        {"options", "a file size limit", nothing(), Exit::storage, Says{"out.vantage"}, no_package, Command{"prlimit --fsize=1000000 vantage prepare {scan} -o {out}.vantage"}},
        {"options", "synth prints few lines", with_file("many.toml", "[photos]\ncount = 40\nwidth = 32\nheight = 24\nsamples = 1\n[object]\ntriangles = 200\n"), Says{"scene"}, no_package, Command{"vantage synth {scan}/many.toml -o {out}"}, Never{"17/40"}},

        {"options", "--shard 1/2", nothing(), Says{"vantage merge"}, no_package, Command{"vantage prepare {scan} -o {out}.share --shard 1/2 --no-report ; vantage check {out}.share"}, Exit::damaged},
        {"options", "--shard 3/3 with backslash", nothing(), Exit::usage, Says{"--shard 3\\3: expected"}, no_package, Command{with("--shard 3\\3")}},
        {"options", "--shard empty parts", nothing(), Exit::usage, Says{"--shard /: expected"}, no_package, Command{with("--shard /")}},
        {"options", "--max-photo-size 32", nothing(), Command{with("--max-photo-size 32")}},
        {"options", "--max-photo-size -1", nothing(), Exit::usage, Says{"--max-photo-size"}, no_package, Command{with("--max-photo-size -1")}},
        {"options", "--thumbnail-size 5", nothing(), Exit::usage, Says{"--thumbnail-size"}, no_package, Command{with("--thumbnail-size 5")}},
        {"options", "--refine some", nothing(), Exit::usage, Says{"--refine"}, no_package, Command{with("--refine some")}},
        {"options", "--progress loud", nothing(), Exit::usage, Says{"--progress: 'loud' is none of auto, bar, lines, json, none"}, no_package, Command{with("--progress loud")}},
        {"options", "--strict and a photo without a camera", with_file("images/D.jpg", red()), Exit::input, Says{"D.jpg: has no camera"}, no_package, Command{with("--strict")}},
        {"options", "--hold-out by stem, the rest left out", [](Scan& s) { s.remove("images/C.jpg"); }, Exit::incomplete, Holds{"-A.jpg B.jpg=green;"}, Command{with("--hold-out A")}},
        {"options", "neither INPUT nor --mesh", nothing(), Exit::usage, Says{"expected an INPUT folder"}, no_package, Command{"vantage prepare -o {out}.vantage"}},
        {"options", "no -o", nothing(), Exit::usage, Says{"--output"}, no_package, Command{"vantage prepare {scan}"}},
        {"options", "--mesh, --cameras and --photos without INPUT", nothing(), Command{"vantage prepare --mesh {scan}/mesh.ply --cameras {scan}/sparse --photos {scan}/images -o {out}.vantage --no-report"}},
        {"options", "synth of a missing file", nothing(), Exit::input, Says{"none.toml"}, no_package, Command{"vantage synth {scan}/none.toml -o {out}"}},

        // --------------------------------------------------------------------------------------- comparisons
        {"comparisons", "a larger mesh", with_file("old.ply", box_ply({.scale = 1.5})), Says{"deviation-from-old from -0.5 to -0.5"}, Command{deviation("{scan}/old.ply", "; vantage info {out}.vantage")}},
        {"comparisons", "the mesh moved", with_file("old.ply", box_ply({.x = 0.25})), Says{"deviation-from-old from -0.25 to 0.25"}, Command{deviation("{scan}/old.ply", "; vantage info {out}.vantage")}},
        {"comparisons", "the only mesh of the folder", nothing(), Exit::input, Says{"no mesh found (PLY, OBJ, STL, OFF, glTF, GLB, FBX), and no point cloud other than the files of --deviation-from"}, no_package, Command{deviation("{scan}/mesh.ply", "")}},
        {"comparisons", "a point cloud without normals", with_file("old.ply", points_ply()), Says{"deviation-from-old from 0 to 1"}, Command{deviation("{scan}/old.ply", "; vantage info {out}.vantage")}},
        {"comparisons", "two meshes", [](Scan& s) { s["a.ply"] = box_ply({.scale = 1.5}); s["b.obj"] = box_obj(); }, Says{"deviation-from-a from -0.5 to -0.5; deviation-from-b from 0 to 0"}, Command{deviation("{scan}/a.ply", "--deviation-from {scan}/b.obj ; vantage info {out}.vantage")}},
        {"comparisons", "two meshes of the same name", [](Scan& s) { s["a/m.ply"] = box_ply(); s["b/m.ply"] = box_ply(); }, Exit::usage, Says{"b/m.ply: another --deviation-from file has the same name"}, no_package, Command{deviation("{scan}/a/m.ply", "--deviation-from {scan}/b/m.ply")}},
        {"comparisons", "a missing mesh", nothing(), Exit::input, Says{"old.ply: does not exist"}, no_package, Command{deviation("{scan}/old.ply", "")}},
        {"comparisons", "a photo in its place", nothing(), Exit::input, Says{"A.jpg"}, no_package, Command{deviation("{scan}/images/A.jpg", "")}},
        {"comparisons", "a larger file in the folder is not taken for the mesh", [](Scan& s) { s.move("mesh.ply", "new.ply"); s["old.ply"] = box_ply({.scale = 1.5}) + std::string(100, '\n'); }, Says{"new.ply"}, Command{deviation("{scan}/old.ply", "")}},
        {"comparisons", "again, nothing to do", with_file("old.ply", box_ply({.scale = 1.5})), Says{"is current, nothing to do"}, Command{deviation("{scan}/old.ply", "; " + deviation("{scan}/old.ply", ""))}},
        {"comparisons", "again, without it", with_file("old.ply", box_ply({.scale = 1.5})), Says{"the mesh has no scalar fields"}, Command{deviation("{scan}/old.ply", "; vantage prepare {scan} -o {out}.vantage --no-report ; vantage info {out}.vantage")}},
        {"comparisons", "again, from a mesh that has changed", [](Scan& s) { s["old.ply"] = box_ply({.scale = 1.5}); s["older.ply"] = box_ply({.scale = 2}); }, Says{"deviation-from-old from -1 to -1"}, Command{deviation("{scan}/old.ply", "; cp {scan}/older.ply {scan}/old.ply ; " + deviation("{scan}/old.ply", "; vantage info {out}.vantage"))}},
        {"comparisons", "checked", with_file("old.ply", box_ply({.scale = 1.5})), Says{"valid"}, Command{deviation("{scan}/old.ply", "; vantage check --against {scan} {out}.vantage")}},
        {"comparisons", "checked, from a mesh that has changed", [](Scan& s) { s["old.ply"] = box_ply({.scale = 1.5}); s["older.ply"] = box_ply({.scale = 2}); }, Exit::stale, Says{"old.ply: has changed"}, no_package, Command{deviation("{scan}/old.ply", "; cp {scan}/older.ply {scan}/old.ply ; vantage check --against {scan} {out}.vantage")}},
        {"comparisons", "checked, from a glTF with another buffer", [](Scan& s) { s["old.gltf"] = box_gltf().json("old.bin"); s["old.bin"] = box_gltf({.scale = 1.5}).bytes; s["older.bin"] = box_gltf({.scale = 2}).bytes; }, Exit::stale, Says{"old.bin: has changed"}, no_package, Command{deviation("{scan}/old.gltf", "; cp {scan}/older.bin {scan}/old.bin ; vantage check --against {scan} {out}.vantage")}},
        {"comparisons", "checked, without the mesh in the folder", with_file("old.ply", box_ply({.scale = 1.5})), Says{"valid"}, Command{deviation("{scan}/old.ply", "; rm {scan}/old.ply ; vantage check --against {scan} {out}.vantage")}},
        {"comparisons", "shown", with_file("old.ply", box_ply({.scale = 1.5})), Says{"out.png"}, Command{deviation("{scan}/old.ply", "; vantage-player {out}.vantage --offscreen --photo A --field deviation-from-old -o {out}.png")}},
        {"comparisons", "-o is the mesh to compare with", with_file("old.ply", box_ply()), Exit::usage, Says{"old.ply"}, no_package, Command{"vantage prepare {scan} -o {scan}/old.ply --deviation-from {scan}/old.ply --force"}},

        // -------------------------------------------------------------------------------------- point clouds
        {"point clouds", "beside the mesh", with_file("cloud.ply", points_ply()), Says{"1000 points in cloud.ply"}, Command{cloud("{scan}/cloud.ply", "; vantage info {out}.vantage")}},
        {"point clouds", "two of them", [](Scan& s) { s["a.ply"] = points_ply(); s["b.ply"] = points_ply(10); }, Says{"1010 points in 2 files"}, Command{cloud("{scan}/a.ply", "--points {scan}/b.ply ; vantage info {out}.vantage")}},
        {"point clouds", "one point", with_file("cloud.ply", points_ply(1)), Says{"1 point in cloud.ply"}, Command{cloud("{scan}/cloud.ply", "; vantage check --deep {out}.vantage ; vantage info {out}.vantage")}},
        {"point clouds", "a mesh, of which the vertices are taken", with_file("box.obj", box_obj()), Says{"8 points in box.obj"}, Command{cloud("{scan}/box.obj", "; vantage info {out}.vantage")}},
        {"point clouds", "a GLB", with_file("box.glb", box_gltf().glb()), Exit::input, Says{"box.glb: is not read for its points; expected PLY, LAS, OBJ, STL or OFF"}, no_package, Command{cloud("{scan}/box.glb", "")}},
        {"point clouds", "a stray point", with_file("cloud.ply", text_cloud({"0 0 0", "0 1 0", "1 0 0", "1 1 0", "0 0 1", "1e7 5e6 0"})), Says{"1 points far from all others dropped", "5 points"}, Command{cloud("{scan}/cloud.ply", "; vantage info {out}.vantage")}},
        {"point clouds", "NaN", with_file("cloud.ply", text_cloud({"0 0 0", "nan 1 0", "1 0 0"})), Says{"1 invalid points dropped", "2 points"}, Command{cloud("{scan}/cloud.ply", "; vantage info {out}.vantage")}},
        {"point clouds", "two of the same name", [](Scan& s) { s["a/c.ply"] = points_ply(); s["b/c.ply"] = points_ply(7); }, Says{"is current, nothing to do"}, Command{cloud("{scan}/a/c.ply", "--points {scan}/b/c.ply ; " + cloud("{scan}/a/c.ply", "--points {scan}/b/c.ply"))}},
        {"point clouds", "without points", with_file("cloud.ply", points_ply(0)), Exit::input, Says{"cloud.ply: has no vertices"}, no_package, Command{cloud("{scan}/cloud.ply", "")}},
        {"point clouds", "cut off", with_file("cloud.ply", points_ply().substr(0, points_ply().size() / 2)), Exit::input, Says{"cloud.ply"}, no_package, Command{cloud("{scan}/cloud.ply", "")}},
        {"point clouds", "missing", nothing(), Exit::input, Says{"cloud.ply: does not exist"}, no_package, Command{cloud("{scan}/cloud.ply", "")}},
        {"point clouds", "switched off", with_file("cloud.ply", points_ply()), Says{"points", "off, forced"}, Command{cloud("{scan}/cloud.ply", "--effect points=off ; vantage info {out}.vantage")}},
        {"point clouds", "again, nothing to do", with_file("cloud.ply", points_ply()), Says{"is current, nothing to do"}, Command{cloud("{scan}/cloud.ply", "; " + cloud("{scan}/cloud.ply", ""))}},
        {"point clouds", "checked, from a cloud that has changed", [](Scan& s) { s["cloud.ply"] = points_ply(); s["other.ply"] = points_ply(7); }, Exit::stale, Says{"cloud.ply: has changed"}, no_package, Command{cloud("{scan}/cloud.ply", "; cp {scan}/other.ply {scan}/cloud.ply ; vantage check --against {scan} {out}.vantage")}},
        {"point clouds", "shown alone", with_file("cloud.ply", points_ply()), Says{"out.png"}, Command{cloud("{scan}/cloud.ply", "; vantage-player {out}.vantage --offscreen --photo A --points alone -o {out}.png")}},
        {"point clouds", "not named beside a mesh", with_file("cloud.ply", points_ply()), Says{"cloud.ply: a point cloud, not used; --points shows it"}},
        {"point clouds", "no mesh", with_mesh("cloud.ply", points_ply()), Says{"valid"}, Holds{"A.jpg=red B.jpg=green C.jpg=blue"}, Command{check_against}},
        {"point clouds", "no mesh, --points names one of two", [](Scan& s) { s.remove("mesh.ply"); s["a.ply"] = points_ply(7); s["b.ply"] = points_ply(9); }, Says{"a.ply (7)", "b.ply: a point cloud, not used"}, Holds{"A.jpg=red"}, Command{cloud("{scan}/a.ply", "")}},
        {"point clouds", "no mesh, no photos", [](Scan& s) { s.remove("mesh.ply"); s.remove("images"); s["cloud.ply"] = points_ply(); }, Says{"sparse: not used, no photos found"}, Holds{"2 x 2 x 2"}},
        {"point clouds", "no mesh, no cameras", [](Scan& s) { s.remove("mesh.ply"); s.remove("sparse"); s["cloud.ply"] = points_ply(); }, Says{"images: not used, no cameras found"}, Holds{"2 x 2 x 2"}},
        {"point clouds", "nothing else", [](Scan& s) { s.remove("mesh.ply"); s.remove("sparse"); s.remove("images"); s["cloud.ply"] = points_ply(); }, Says{"valid"}, Holds{"2 x 2 x 2"}, Command{check_against}},
        {"point clouds", "no mesh, points switched off", with_mesh("cloud.ply", points_ply()), Exit::usage, Says{"cloud.ply: the scene has points only, expected --effect points=on or auto"}, no_package, Command{with("--effect points=off")}},
        {"point clouds", "no mesh, a deviation to measure", [](Scan& s) { s.remove("mesh.ply"); s["cloud.ply"] = points_ply(); s["old.ply"] = points_ply(9); }, Exit::usage, Says{"has no mesh, of which --deviation-from could measure the deviation"}, no_package, Command{deviation("{scan}/old.ply", "")}},
        {"point clouds", "a mesh has replaced the cloud", [](Scan& s) { s.remove("mesh.ply"); s["cloud.ply"] = points_ply(); s["later/mesh.txt"] = box_ply(); }, Exit::stale, Says{"mesh.ply: was added after the package was prepared"}, no_package, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; cp {scan}/later/mesh.txt {scan}/mesh.ply ; vantage check --against {scan} {out}.vantage"}},
        {"point clouds", "LAS", with_mesh("scan.las", box_las()), Says{"16 points in scan.las"}, Holds{"A.jpg=red B.jpg=green C.jpg=blue"}, Command{std::string(prepare_command) + " ; vantage info {out}.vantage"}},
        {"point clouds", "LAS, cut off", with_mesh("scan.las", box_las().substr(0, 300)), Exit::input, Says{"scan.las: is cut off: its header counts 16 points, 2 are there"}, no_package},
        {"point clouds", "E57 alone", [](Scan& s) { s.remove("mesh.ply"); s["scan.e57"] = "ASTM-E57"; }, Exit::input, Says{"scan.e57: E57 is not supported; expected LAS or PLY"}, no_package},
        {"point clouds", "LAS, compressed", [](Scan& s) { s.remove("mesh.ply"); s["scan.laz"] = box_las(); s["scan.laz"][104] = char(0x82); }, Exit::input, Says{"scan.laz: is compressed (LAZ), which is not supported"}, no_package},
        {"point clouds", "shown, a wrong size", with_file("cloud.ply", points_ply()), Exit::usage, Says{"--point-size"}, no_package, Command{cloud("{scan}/cloud.ply", "; vantage-player {out}.vantage --offscreen --photo A --point-size 0 -o {out}.png")}},
        // ------------------------------------------------------------------------------------------- image sets
        {"image sets", "images/visible and images/infrared", in_image_sets("visible", "infrared"), Says{"image set     visible (2)", "image set     infrared (1)"}},
        {"image sets", "RGB and UVF, checked", in_image_sets("RGB", "UVF"), Says{"valid"}, Command{check_against}},
        {"image sets", "before and after, the larger one first", in_image_sets("before", "after"), Says{"image set     before (2)", "image set     after (1)"}},
        {"image sets", "images/left and images/right", in_image_sets("left", "right"), Never{"image set "}},
        {"image sets", "left and right, --image-sets folders, prepared again", in_image_sets("left", "right"), Says{"nothing to do"}, Command{with("--image-sets folders ; ") + with("--image-sets folders")}},
        {"image sets", "left and right, --image-sets folders, then without", in_image_sets("left", "right"), Never{"nothing to do", "image set "}, Command{with("--image-sets folders ; ") + prepare_command}},
        {"image sets", "images/infrared and images/extra", in_image_sets("extra", "infrared"), Says{"'infrared' may be an image set, but 'extra' is the name of none"}, Never{"image set  "}},
        {"image sets", "infrared below other photos", [](Scan& s) { s.move("images/C.jpg", "images/infrared/C.jpg"); }, Says{"image set     photos (2)", "image set     infrared (1)"}},
        {"image sets", "visible and infrared, --image-sets off", in_image_sets("visible", "infrared"), Never{"image set "}, Command{with("--image-sets off")}},
        {"image sets", "visible and infrared, --effect image-sets=off", in_image_sets("visible", "infrared"), Says{"image sets              off (forced)"}, Command{with("--effect image-sets=off ; vantage info {out}.vantage")}},
        {"image sets", "by file names", with_file("image_sets.toml", "normal = [\"A.*\", \"B.jpg\"]\nuv = \"C*\"\n"), Says{"image set     normal (2)", "image set     uv (1)"}, Command{with("--image-sets {scan}/image_sets.toml")}},
        {"image sets", "by file names, the file has changed", with_file("image_sets.toml", "normal = [\"A.*\", \"B.jpg\"]\nuv = \"C*\"\n"), Exit::stale, Says{"image_sets.toml: has changed"}, Command{with("--image-sets {scan}/image_sets.toml ; cp {scan}/sparse/images.txt {scan}/image_sets.toml ; vantage check --against {scan} {out}.vantage")}},
        {"image sets", "by file names in other case", with_file("image_sets.toml", "normal = \"[ab].JPG\"\nuv = \"c*\"\n"), Says{"image set     normal (2)", "image set     uv (1)"}, Command{with("--image-sets {scan}/image_sets.toml")}},
        {"image sets", "a photo in two image sets", with_file("image_sets.toml", "a = \"*.jpg\"\nb = \"C*\"\n"), Exit::input, Says{"image_sets.toml: C.jpg is in two image sets, a and b; expected one"}, no_package, Command{with("--image-sets {scan}/image_sets.toml")}},
        {"image sets", "a photo in no image set", with_file("image_sets.toml", "a = \"A*\"\n"), Exit::input, Says{"image_sets.toml: B.jpg is in no image set"}, no_package, Command{with("--image-sets {scan}/image_sets.toml")}},
        {"image sets", "an image set without photos", with_file("image_sets.toml", "a = \"*.jpg\"\nuv = \"uv/*\"\n"), Exit::input, Says{"image_sets.toml: the image set uv has no photo that can be used"}, no_package, Command{with("--image-sets {scan}/image_sets.toml")}},
        {"image sets", "--image-sets of a misspelled word", nothing(), Exit::usage, Says{"--image-sets folder: expected auto, folders, off, or a file that names the image sets"}, no_package, Command{with("--image-sets folder")}},
        {"image sets", "cameras in each image set's folder", [](Scan& s) { for (const auto& [image_set, photos] : {std::pair("visible", std::vector<std::string>{"A.jpg", "B.jpg"}), std::pair("infrared", std::vector<std::string>{"C.jpg"})}) { for (const std::string& p : photos) s.move("images/" + p, std::string(image_set) + "/images/" + p); s[std::string(image_set) + "/sparse/cameras.txt"] = s["sparse/cameras.txt"]; s[std::string(image_set) + "/sparse/images.txt"] = colmap_images(photos); } s.remove("sparse/cameras.txt"); s.remove("sparse/images.txt"); }, Says{"and 1 more (COLMAP text)", "image set     visible (2)"}, Never{"not used"}},
        {"image sets", "the output is the file that names the image sets", with_file("image_sets.toml", "a = \"*\"\n"), Exit::usage, Says{"image_sets.toml"}, no_package, Command{"vantage prepare {scan} -o {scan}/image_sets.toml --image-sets {scan}/image_sets.toml --force"}},

        // ------------------------------------------------------------------------------------------ packages
        {"packages", "show a missing package", nothing(), Exit::input, Says{"none.vantage: cannot open"}, no_package, Command{"vantage-player {out}/none.vantage --offscreen --photo A -o {out}.png"}},
        {"packages", "show a photo", nothing(), Exit::damaged, Says{"not a Vantage package"}, no_package, Command{"vantage-player {scan}/images/A.jpg --offscreen --photo A -o {out}.png"}},
        {"packages", "show a newer format", nothing(), Exit::input, Says{"newer"}, no_package, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; vantage-newer {out}.vantage ; vantage-player {out}.vantage --offscreen --photo A -o {out}.png"}},
        {"packages", "a photo the package lacks", nothing(), Exit::usage, Says{"X"}, no_package, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; vantage-player {out}.vantage --offscreen --photo X -o {out}.png"}},
        {"packages", "info", nothing(), Says{"A.jpg"}, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; vantage info {out}.vantage"}},
        {"packages", "info of a mesh", nothing(), Exit::damaged, Says{"not a Vantage package"}, no_package, Command{"vantage info {scan}/mesh.ply"}},
        {"packages", "extract", nothing(), Command{"vantage prepare {scan} -o {out}.vantage --no-report ; vantage extract {out}.vantage -o {out}-files ; vantage info {out}.vantage"}},
        {"packages", "diff with a missing package", nothing(), Exit::input, Says{"none.vantage"}, no_package, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; vantage diff {out}.vantage {out}/none.vantage"}},
        {"packages", "diff of a package with itself", nothing(), Says{"identical"}, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; vantage diff {out}.vantage {out}.vantage"}},
        {"packages", "a photo added after preparing", nothing(), Exit::stale, Says{"D.jpg: was added"}, no_package, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; cp {scan}/images/A.jpg {scan}/images/D.jpg ; vantage check --against {scan} {out}.vantage"}},
        {"packages", "a RAW added after preparing", nothing(), Says{"valid"}, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; cp {scan}/mesh.ply {scan}/images/A.DNG ; vantage check --against {scan} {out}.vantage"}},
        {"packages", "a hidden file added after preparing", nothing(), Says{"valid"}, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; cp {scan}/images/A.jpg {scan}/images/._A.jpg ; vantage check --against {scan} {out}.vantage"}},
        {"packages", "a photo in a subfolder removed after preparing", [](Scan& s) { s.move("images/A.jpg", "images/left/A.jpg"); }, Exit::stale, Says{"left/A.jpg: no longer exists"}, no_package, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; rm {scan}/images/left/A.jpg ; vantage check --against {scan} {out}.vantage"}},
        {"packages", "check --against a missing folder", nothing(), Exit::input, Says{"/none", "does not exist"}, no_package, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; vantage check --against {scan}/none {out}.vantage"}, Never{"out.vantage: unreadable"}},
        {"packages", "check --against a folder without a scan", [](Scan& s) { s.folders.insert("empty"); }, Exit::input, Says{"no mesh found"}, no_package, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; vantage check --against {scan}/empty {out}.vantage"}, Never{"out.vantage: unreadable"}},
        {"packages", "refine a missing package", nothing(), Exit::input, Says{"none.vantage: cannot open"}, no_package, Command{"vantage refine {out}/none.vantage"}},
        {"packages", "check of a missing package", nothing(), Exit::input, Says{"none.vantage", "cannot open"}, no_package, Command{"vantage check {out}/none.vantage"}},
        {"packages", "check of a photo", nothing(), Exit::damaged, Says{"not a Vantage package"}, no_package, Command{"vantage check {scan}/images/A.jpg"}},
        {"packages", "check of a folder", nothing(), Exit::input, Says{"cannot open"}, no_package, Command{"vantage check {scan}"}},
        {"packages", "verify without views.path", [](Scan& s) { s.folders.insert("golden"); }, Exit::input, Says{"views.path", "--update"}, no_package, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; vantage-player verify {out}.vantage --golden {scan}/golden --size 64x48"}, Never{"out.vantage: unreadable"}},
        {"packages", "prepared twice", nothing(), Says{"nothing to do"}, Command{again}},
        {"packages", "diff names the values that differ", nothing(), Exit::different, Says{"settings: photo_size: 0 vs. 32", "inputs: effects: per-fragment: measured: "}, no_package, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; vantage prepare {scan} -o {out}.2.vantage --no-report --max-photo-size 32 ; vantage diff {out}.vantage {out}.2.vantage"}, Never{"{\""}},
        {"packages", "a newer format", nothing(), Exit::input, Says{"format version", "newer"}, no_package, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; vantage-newer {out}.vantage ; vantage check {out}.vantage"}, Never{"damaged"}},
        {"packages", "a newer format is not overwritten", nothing(), Exit::input, Says{"format version", "newer"}, no_package, Command{"vantage prepare {scan} -o {out}.vantage --no-report ; vantage-newer {out}.vantage ; vantage prepare {scan} -o {out}.vantage --no-report"}},
    };
}
// clang-format on

}  // namespace

std::span<const Row> table() {
    static const std::vector<Row> all = rows();
    return all;
}

}  // namespace vantage::real_inputs
