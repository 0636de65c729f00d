// Whole programs with a headset: an OpenXR runtime that plays scenarios and checks each call (tests/openxr).
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "base/gl/context.h"
#include "base/text/error.h"
#include "player/composition/object_set.h"
#include "player/headset/menu_place.h"
#include "player/headset/runtime/eye_frustum.h"
#include "player/options/shown/blending_options.h"
#include "player/view/view.h"
#include "scene/story/story_file.h"
#include "tests/headset/menu_alone.h"
#include "tests/one_line.h"
#include "tests/programs/garden_package.h"

using namespace vantage;
namespace fs = std::filesystem;
using Eigen::Vector3d;
using nlohmann::json;

namespace {

constexpr double degree = std::numbers::pi / 180;

json pose(const Vector3d& at, const Eigen::Quaterniond& turn = Eigen::Quaterniond::Identity()) {
    return {{"position", {at.x(), at.y(), at.z()}},
            {"orientation", {turn.x(), turn.y(), turn.z(), turn.w()}}};
}
/// A hand that points from one place of the room to another.
json pointing(const Vector3d& from, const Vector3d& to) {
    return pose(from, Eigen::Quaterniond::FromTwoVectors(-Vector3d::UnitZ(), to - from));
}
json hand(int frame, const char* which, const json& place, const json& inputs) {
    return {{"frame", frame}, {"hand", which}, {"active", true},
            {"aim", place},   {"grip", place}, {"inputs", inputs}};
}
json eye(int width, int height, double left, double right, double up, double down, double x) {
    return {{"width", width}, {"height", height}, {"fov", {left, right, up, down}}, {"offset", {x, 0, 0}}};
}

class HeadsetProgram : public GardenPackage {
  protected:
    struct Run {
        int code;
        std::string message, violations, events;
        std::vector<json> frames;
    };
    void SetUp() override {
        GardenPackage::SetUp();
        make_package({{Effect::background, EffectChoice::on}});
        ::setenv("MESA_SHADER_CACHE_DIR", fs::temp_directory_path().c_str(), 1);
    }
    static void expect_valid(const Run& run) {
        EXPECT_EQ(run.code, 0) << run.message;
        EXPECT_EQ(run.violations, "");
        EXPECT_EQ(run.message, "");
    }
    /// Without a display: the program takes EGL, which the runtime then has to offer.
    json scenario(int frames) const {
        return {
            {"end", frames},
            {"eyes", {eye(96, 108, -52, 43, 47, -50, -0.032), eye(96, 108, -43, 52, 47, -50, 0.032)}},
            {"extensions", {"XR_KHR_opengl_enable", "XR_MNDX_egl_enable", "XR_KHR_composition_layer_depth"}}};
    }
    Run play(const json& scenario, const std::string& options = "",
             const std::string& before = "env -u DISPLAY") const {
        const fs::path message = dir / "message", out = dir / "out";
        fs::remove_all(out);
        std::ofstream(dir / "scenario.json") << scenario;
        const int status = std::system(
            ("cd " + dir.string() + " && XR_RUNTIME_JSON=" OPENXR_MANIFEST " VANTAGE_TEST_XR=" +
             (dir / "scenario.json").string() + " VANTAGE_TEST_XR_OUT=" + out.string() + " " + before +
             " timeout 300 " VANTAGE_PLAYER " " + file.string() +
             " --xr --no-saved-settings --quiet --photo 0002 " + options + " >" + message.string() + " 2>&1")
                .c_str());
        Run run{WIFEXITED(status) ? WEXITSTATUS(status) : -1,
                slurp(message),
                slurp(out / "violations.txt"),
                slurp(out / "events.txt"),
                {}};
        std::istringstream lines(slurp(out / "frames.jsonl"));
        for (std::string line; std::getline(lines, line);) run.frames.push_back(json::parse(line));
        return run;
    }
    Picture saved(int frame, const char* eye) const {
        char name[32];
        std::snprintf(name, sizeof name, "%04d-%s.png", frame, eye);
        return read_png(dir / "out" / name);
    }
};

/// What takes many runs.
class HeadsetProgramAtLength : public HeadsetProgram {};

std::size_t shown_frames(const std::vector<json>& frames) {
    return std::size_t(std::ranges::count_if(frames, [](const json& f) { return !f["layers"].empty(); }));
}

/// The scene as seen by eyes in the room, by hand: the room is level, its -z leads from the photo's camera to
/// what it sees, and the head was at the photo's camera when it was first seen.
struct Room {
    Eigen::Matrix3d axes;
    Vector3d at;
    double scale;

    Room(const package::PhotoRecord& photo, const Vector3d& up, const Vector3d& head, double units_per_meter)
        : scale(units_per_meter) {
        const Pose camera = view_of_photo(photo, 1).cam_from_origin;
        const Vector3d ahead = camera.R.row(2), z = -(ahead - up * up.dot(ahead)).normalized();
        axes << up.cross(z), up, z;
        at = camera.center() - scale * (axes * head);
    }
    Vector3d in_scene(const Vector3d& p) const { return at + scale * (axes * p); }
    Vector3d in_room(const Vector3d& p) const { return axes.transpose() * (p - at) / scale; }
    /// `submitted`: a view of frames.jsonl.
    View view(const json& submitted) const {
        const auto& p = submitted["position"];
        const auto& q = submitted["orientation"];
        const auto tangent = [&](int i) { return std::tan(submitted["fov"][std::size_t(i)].get<double>()); };
        const int width = submitted["rect"][2], height = submitted["rect"][3];
        View out;
        Intrinsics& k = out.intrinsics;
        k.width = width, k.height = height;
        k.fx = width / (tangent(1) - tangent(0));
        k.fy = height / (tangent(2) - tangent(3));
        k.cx = -tangent(0) * k.fx;
        k.cy = tangent(2) * k.fy;
        const Eigen::Quaterniond turn(q[3].get<double>(), q[0].get<double>(), q[1].get<double>(),
                                      q[2].get<double>());
        const Eigen::Matrix3d eye_in_scene = axes * turn.normalized().toRotationMatrix();
        out.cam_from_origin.R << eye_in_scene.col(0).transpose(), -eye_in_scene.col(1).transpose(),
            -eye_in_scene.col(2).transpose();
        out.cam_from_origin.t =
            -out.cam_from_origin.R * in_scene({p[0].get<double>(), p[1].get<double>(), p[2].get<double>()});
        return out;
    }
};

/// What the offscreen renderer makes of a view, from thumbnails.
Picture offscreen_picture(const PackageReader& package, const View& view,
                          const std::vector<std::uint32_t>& photos, bool thumbnails) {
    BlendingOptions options;
    options.photos = 0;
    options.render.thumbnails = thumbnails;
    Renderer renderer(package, MemoryBudget{});
    return take_picture(renderer, view, render_settings(package, options, Purpose::window), photos, 1);
}

/// The same of two eyes, as a window renders them.
std::vector<Picture> window_pictures(const PackageReader& package, const std::vector<View>& eyes,
                                     const std::vector<std::uint32_t>& photos) {
    BlendingOptions options;
    options.photos = 0;
    options.render.thumbnails = true;
    RenderSettings settings = render_settings(package, options, Purpose::window);
    settings.complete = false;
    settings.wait_for_tiles = true;
    Renderer renderer(package, MemoryBudget{});
    ObjectSet objects(renderer, {{"garden", package.path(), {}, true}}, MemoryBudget{});
    std::vector<Picture> out(2);
    for (int frame = 0; frame < 6; ++frame)
        objects.draw_eyes(eyes, settings, photos, {}, 10.0 * frame, nullptr, [&](std::size_t e) {
            out[e] = picture_of(frame_size(eyes[e]),
                                [&](GLuint target) { objects.show(eyes[e], settings, target, false, e); });
        });
    return out;
}

/// Pixels that differ, and the largest difference in codes.
struct Difference {
    std::size_t pixels = 0;
    int codes = 0;
};
Difference difference(const Picture& a, const Picture& b) {
    if (a.rgba.size() != b.rgba.size()) return {a.rgba.size(), 256};
    Difference out;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
        int most = 0;
        for (std::size_t c = 0; c < 4; ++c) most = std::max(most, std::abs(a.rgba[i + c] - b.rgba[i + c]));
        out.pixels += most > 0;
        out.codes = std::max(out.codes, most);
    }
    return out;
}

/// In dB.
double psnr(const Picture& a, const Picture& b) {
    if (a.rgba.size() != b.rgba.size()) return 0;
    double squares = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) squares += std::pow(a.rgba[i] - b.rgba[i], 2);
    return -10 * std::log10(squares / double(a.rgba.size()) / (255.0 * 255));
}

/// Where an eye of frames.jsonl is.
RoomPose eye_pose(const json& view) {
    const auto number = [&](const char* of, std::size_t i) { return double(view[of][i].get<float>()); };
    return {Eigen::Quaterniond(number("orientation", 3), number("orientation", 0), number("orientation", 1),
                               number("orientation", 2))
                .normalized(),
            {number("position", 0), number("position", 1), number("position", 2)}};
}

/// Between two of them.
RoomPose head_between(const json& views) {
    const RoomPose left = eye_pose(views[0]), right = eye_pose(views[1]);
    return {left.turn.slerp(0.5, right.turn), (left.at + right.at) / 2};
}

/// The same view by the player's own functions, to the last bit of its numbers.
View players_view(const package::PhotoRecord& photo, const Vector3d& up, const RoomPose& head, double scale,
                  const json& v) {
    const Pose camera = view_of_photo(photo, 1).cam_from_origin;
    const Vector3d ahead = camera.R.row(2);
    const Stance stance =
        standing(head, camera.center(), camera.center() + seen_distance(photo) * ahead, up, scale);
    const auto angle = [&](std::size_t i) { return double(v["fov"][i].get<float>()); };
    const auto frustum = eye_frustum(eye_pose(v), angle(0), angle(1), angle(2), angle(3));
    return view_of_eye(stance, *frustum, {v["rect"][2], v["rect"][3]});
}

/// A pixel of a saved depth picture, from its upper left corner, as distance along the eye's axis in meters;
/// `submitted`: its view.
double distance_at(const fs::path& pfm, const json& submitted, int x, int y) {
    std::ifstream in(pfm, std::ios::binary);
    std::string kind;
    int width = 0, height = 0;
    double order = 0;
    in >> kind >> width >> height >> order;
    in.get();
    std::vector<float> rows(std::size_t(width) * std::size_t(height));
    in.read(reinterpret_cast<char*>(rows.data()), std::streamsize(rows.size() * sizeof(float)));
    const double depth = double(rows.at(std::size_t(height - 1 - y) * std::size_t(width) + std::size_t(x)));
    const auto limit = [&](const char* name) {
        const json& at = submitted["depth"][name];
        return at.is_string() ? std::numeric_limits<double>::infinity() : at.get<double>();
    };
    return 1 / (1 / limit("near") + depth * (1 / limit("far") - 1 / limit("near")));
}
double middle_distance(const fs::path& pfm, const json& submitted) {
    return distance_at(pfm, submitted, submitted["rect"][2].get<int>() / 2,
                       submitted["rect"][3].get<int>() / 2);
}

/// What somebody does with the right hand, frame by frame, with a headset at (0, 1.6, 0) that looks ahead.
struct Script {
    static constexpr int hold = 2;  ///< frames for which a button is down, and up again
    json hands = json::array();
    int frame = 6;
    const Vector3d from{0.15, 1.3, -0.1};
    const MenuPlace menu = menu_in_front_of({Eigen::Quaterniond::Identity(), {0, 1.6, 0}});

    void press(const Vector3d& at, const char* button) {
        hands.push_back(hand(frame, "right", pointing(from, at),
                             {{button, button == menu_button ? json(false) : json(0)}}));
        frame += hold;
        hands.push_back(hand(frame, "right", pointing(from, at),
                             {{button, button == menu_button ? json(true) : json(1)}}));
        frame += hold;
        hands.push_back(hand(frame, "right", pointing(from, at),
                             {{button, button == menu_button ? json(false) : json(0)}}));
        frame += hold;
    }
    void open_or_close_menu() { press({0, 0, -5}, menu_button); }
    void select(const Vector3d& at) { press(at, "/input/trigger/value"); }
    /// A place of the menu, in panel pixels.
    void click(const Eigen::Vector2d& pixel) {
        const Panel panel = menu_panel(menu, {}, SceneInterface::width, SceneInterface::height);
        select(point_on(panel, pixel));
    }
    static constexpr const char* menu_button = "/input/b/click";
};

/// The middles of the controls that are noted in a file, by name; those on the menu.
std::vector<std::pair<std::string, Eigen::Vector2d>> controls_in(const std::string& text) {
    std::vector<std::pair<std::string, Eigen::Vector2d>> out;
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);  // the frame's number
    while (std::getline(lines, line)) {
        const auto tab = line.find('\t');
        double x = 0, y = 0, w = 0, h = 0;
        std::istringstream(line.substr(tab)) >> x >> y >> w >> h;
        const Eigen::Vector2d middle(x + std::min(w / 2, 60.0), y + h / 2);
        if (middle.x() < SceneInterface::width && middle.y() < SceneInterface::height)
            out.emplace_back(line.substr(0, tab), middle);
    }
    return out;
}

using Corners = std::array<Vector3d, 3>;

/// The distance along a ray at which it meets a triangle; infinity if it does not.
double meets(const Vector3d& from, const Vector3d& along, const Corners& c) {
    Eigen::Matrix3d m;
    m << c[1] - c[0], c[2] - c[0], -along;
    const Vector3d x = m.fullPivLu().solve(from - c[0]);
    const bool inside =
        std::abs(m.determinant()) > 1e-14 && x[0] >= 0 && x[1] >= 0 && x[0] + x[1] <= 1 && x[2] > 0;
    return inside ? x[2] : std::numeric_limits<double>::infinity();
}

/// The mesh, without a background.
std::vector<Corners> triangles_of(const PlanScene& scene) {
    std::vector<Corners> mesh;
    for (const package::ClusterRecord& c :
         std::span(scene.clusters)
             .first(std::min<std::size_t>(scene.first_surrounding, scene.clusters.size())))
        for (std::size_t t = c.first_triangle; t < c.first_triangle + c.triangles; ++t) {
            Corners& corners = mesh.emplace_back();
            for (std::size_t k = 0; k < 3; ++k)
                corners[k] = scene.positions[scene.indices[3 * t + k]].cast<double>();
        }
    return mesh;
}

/// How far a mesh that was moved is along a view's axis, at a pixel; infinity if it is not there.
double distance_by_hand(const View& view, int x, int y, const std::vector<Corners>& mesh,
                        const Vector3d& moved = Vector3d::Zero()) {
    const Intrinsics& k = view.intrinsics;
    const Vector3d along =
        view.cam_from_origin.R.transpose() * Vector3d((x + 0.5 - k.cx) / k.fx, (y + 0.5 - k.cy) / k.fy, 1);
    double out = std::numeric_limits<double>::infinity();
    for (const Corners& c : mesh) out = std::min(out, meets(view.cam_from_origin.center() - moved, along, c));
    return out;
}

/// Middles of triangles that are seen from a place, between two distances, one per so many triangles.
std::vector<Vector3d> seen_middles(const PlanScene& scene, const Vector3d& from, double nearest,
                                   double farthest, std::size_t wanted) {
    const std::vector<Corners> mesh = triangles_of(scene);
    std::vector<Vector3d> out;
    for (std::size_t i = 0; i < mesh.size() && out.size() < wanted; i += 37) {
        const Vector3d middle = (mesh[i][0] + mesh[i][1] + mesh[i][2]) / 3, along = middle - from;
        if (along.norm() < nearest || along.norm() > farthest) continue;
        double first = std::numeric_limits<double>::infinity();
        for (const Corners& c : mesh) first = std::min(first, meets(from, along, c));
        if (std::abs(first - 1) < 1e-9 && (out.empty() || (middle - out.back()).norm() > 0.5))
            out.push_back(middle);
    }
    return out;
}

}  // namespace

TEST_F(HeadsetProgram, ShowsToEachEyeWhatOffscreenPicturesShowToTheBit) {
    json s = scenario(40);
    s["eyes"] = {eye(160, 144, -52, 31, 47, -50, -0.032), eye(160, 144, -28, 55, 40, -53, 0.032)};
    for (const int e : {0, 1})  // canted outward
        s["eyes"][std::size_t(e)]["orientation"] = {0.0, (1 - 2 * e) * std::sin(5 * degree), 0.0,
                                                    std::cos(5 * degree)};
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.3, Vector3d(1, 2, 0.5).normalized()));
    s["head"] = {pose({0.1, 1.5, -0.2}), pose({0.25, 1.4, 0.1}, turned)};
    s["head"][0]["frame"] = 0, s["head"][1]["frame"] = 20;
    s["save"] = {18, 38};
    for (const int frame : {14, 16, 34, 36})
        s["events"].push_back({{"frame", frame}, {"late", 180}});  // all fades in
    const Run run = play(s, "--fps 0 --max-photos 0 --thumbnails --meters-per-unit 0.5");
    expect_valid(run);
    const PackageReader package(file);
    const Room room(package.photos()[2], Vector3d::UnitZ(), {0.1, 1.5, -0.2}, 2);
    const gl::HeadlessContext context;
    const RoomPose head = head_between(run.frames.at(10)["layers"][0]["views"]);
    for (const int frame : {18, 38}) {
        const json& views = run.frames.at(std::size_t(frame - 1))["layers"][0]["views"];
        std::vector<View> exact, by_hand;
        for (const json& view : views) {
            exact.push_back(players_view(package.photos()[2], Vector3d::UnitZ(), head, 2, view));
            by_hand.push_back(room.view(view));
        }
        const std::vector<Picture> truth = window_pictures(package, exact, all(package));
        for (const std::size_t e : {0, 1}) {
            const Picture seen = saved(frame, e == 0 ? "left" : "right");
            ASSERT_EQ(seen.width, 160);
            EXPECT_EQ(difference(seen, truth[e]).codes, 0) << "frame " << frame << ", eye " << e;
            // By hand, and in pictures of one eye, numbers are rounded in other places.
            const Difference single =
                difference(seen, offscreen_picture(package, by_hand[e], all(package), true));
            EXPECT_LE(single.codes, 1);
            EXPECT_LT(single.pixels, 160u * 144 / 1000);
        }
    }
}

TEST_F(HeadsetProgramAtLength, FinePicturesAreThoseOfOffscreenRenderingToTheEye) {
    json s = scenario(40);
    s["save"] = {38};
    for (const int frame : {20, 34})
        s["events"].push_back({{"frame", frame}, {"late", 180}});  // all fades in
    const Run run = play(s, "--fps 0 --max-photos 0 --meters-per-unit 0.5");
    expect_valid(run);
    const PackageReader package(file);
    const gl::HeadlessContext context;
    const json& views = run.frames.at(37)["layers"][0]["views"];
    const View view = players_view(package.photos()[2], Vector3d::UnitZ(), head_between(views), 2, views[0]);
    // Which tiles are there depends on when they came: where few pixels would show it, a coarser one stays.
    const Picture seen = saved(38, "left"), truth = offscreen_picture(package, view, all(package), false);
    EXPECT_GT(psnr(seen, truth), 45) << "dB";
}

TEST_F(HeadsetProgramAtLength, KeepsToTheSpecificationWhateverTheRuntimeSays) {
    json s = scenario(120);
    s["profile"] = "/interaction_profiles/valve/index_controller";
    s["hands"] = {hand(8, "left", pointing({-0.2, 1.2, -0.2}, {0, 1, -3}), {{"/input/thumbstick", {0, 1}}}),
                  hand(10, "right", pointing({0.2, 1.2, -0.2}, {0, 1, -3}), {{"/input/thumbstick", {1, 0}}})};
    const auto event = [&](int frame, const char* what, const json& value) {
        s["events"].push_back({{"frame", frame}, {what, value}});
    };
    event(12, "state", "visible"), event(14, "state", "synchronized"), event(18, "state", "focused");
    event(22, "should_render", false), event(26, "should_render", true);
    event(30, "untracked", true), event(34, "untracked", false);
    event(38, "late", 3), event(40, "events_lost", 7);
    event(42, "recenter", pose({0.5, 0, 0.5}));
    event(46, "rate", 72), event(52, "rate", 120), event(58, "rate", 0.5);
    event(60, "profile_changed", "/interaction_profiles/htc/vive_controller");
    event(64, "profile_changed", nullptr),
        event(68, "profile_changed", "/interaction_profiles/khr/simple_controller");
    s["events"].push_back({{"frame", 80}, {"state", "stopping"}, {"then", "ready"}});
    const Run run = play(s);
    expect_valid(run);
    EXPECT_EQ(run.frames.size(), 120u);
    const std::size_t hidden = 4 + 4 + 4;  // synchronized, not to be rendered, untracked
    EXPECT_GE(shown_frames(run.frames), 120 - hidden - 8);
    EXPECT_LE(shown_frames(run.frames), 120 - hidden);
    for (const json& f : run.frames)
        EXPECT_TRUE(f["should_render"].get<bool>() || f["layers"].empty()) << f["frame"];
}

TEST_F(HeadsetProgramAtLength, GoesOnWhenSessionOrRuntimeWereLost) {
    json s = scenario(90);
    s["events"] = {{{"frame", 20}, {"lose", "session"}},
                   {{"frame", 50}, {"lose", "instance"}, {"unavailable", 2}}};
    const Run run = play(s);
    expect_valid(run);
    EXPECT_NE(run.events.find("20 session destroyed"), std::string::npos) << run.events;
    const auto shown_between = [&](int first, int last) {
        return std::ranges::count_if(run.frames, [&](const json& f) {
            return f["frame"] > first && f["frame"] < last && !f["layers"].empty();
        });
    };
    EXPECT_GT(shown_between(0, 20), 10);
    EXPECT_GT(shown_between(20, 50), 20);
    EXPECT_GT(shown_between(50, 90), 30);
}

TEST_F(HeadsetProgramAtLength, ShowsOddFieldsOfViewAndDoesNotMindErrorsThatTheRuntimeLeaves) {
    json s = scenario(20);
    s["rate"] = 72;
    s["careless"] = true;
    s["eyes"] = {eye(80, 120, -10, 70, 20, -80, -0.03), eye(80, 120, -70, -10, 80, 20, 0.03)};
    s["save"] = {12};
    const Run run = play(s, "--fps 0");
    expect_valid(run);
    EXPECT_GE(shown_frames(run.frames), 17u);
}

TEST_F(HeadsetProgram, WaitsForFieldsOfViewThatAPictureFits) {
    json s = scenario(15);
    s["eyes"][0]["fov"] = {-90, 90, 45, -45};
    const Run run = play(s);
    EXPECT_EQ(run.code, 0) << run.message;
    EXPECT_EQ(shown_frames(run.frames), 0u);
}

TEST_F(HeadsetProgram, SaysInOneLineWhatIsMissing) {
    const auto says = [&](const json& changes, const std::string& wanted,
                          const std::string& before = "env -u DISPLAY") {
        json s = scenario(10);
        s.update(changes);
        const Run run = play(s, "", before);
        EXPECT_EQ(run.code, int(Exit::graphics)) << wanted;
        EXPECT_TRUE(one_line(run.message)) << run.message;
        EXPECT_NE(run.message.find(wanted), std::string::npos) << run.message;
    };
    says(json::object(), "no OpenXR runtime answers", "env XR_RUNTIME_JSON=/nowhere.json");
    says({{"create_instance", "XR_ERROR_RUNTIME_UNAVAILABLE"}}, "no OpenXR runtime answers");
    says({{"create_instance", "XR_ERROR_LIMIT_REACHED"}}, "XR_ERROR_LIMIT_REACHED");
    says({{"get_system", "XR_ERROR_FORM_FACTOR_UNAVAILABLE"}}, "finds no headset");
    says({{"get_system", "XR_ERROR_FORM_FACTOR_UNSUPPORTED"}}, "finds no headset");
    says({{"create_session", "XR_ERROR_INITIALIZATION_FAILED"}}, "XR_ERROR_INITIALIZATION_FAILED");
    says({{"extensions", {"XR_MNDX_egl_enable"}}}, "does not show OpenGL");
    says({{"extensions", {"XR_KHR_opengl_enable"}}}, "needs an X display");
    says({{"formats", {"GL_RGBA16F"}}}, "no sRGB pictures");
    says({{"events",
           {{{"frame", 5}, {"fail", {{"call", "xrEndFrame"}, {"result", "XR_ERROR_RUNTIME_FAILURE"}}}}}}},
         "xrEndFrame: XR_ERROR_RUNTIME_FAILURE");
}

TEST_F(HeadsetProgramAtLength, MirrorsTheLeftEyeInAWindow) {
    if (std::system("command -v xvfb-run >/dev/null") != 0) GTEST_SKIP() << "no X server available";
    json s = scenario(30);
    s["extensions"] = {"XR_KHR_opengl_enable"};  // a context of GLX, and no depth
    const Run run = play(s, "--size 300x200", "xvfb-run -a -s '-screen 0 640x480x24'");
    expect_valid(run);
    EXPECT_GE(shown_frames(run.frames), 27u);
    EXPECT_TRUE(run.frames[20]["layers"][0]["views"][0]["depth"].is_null());
}

TEST_F(HeadsetProgramAtLength, ValidationLayerOfKhronosFindsNothing) {
    bool there = false;
    const fs::path layers = "/usr/share/openxr/1/api_layers/explicit.d";
    if (fs::exists(layers))
        for (const auto& e : fs::directory_iterator(layers))
            there |= e.path().filename().string().find("core_validation") != std::string::npos;
    if (!there) GTEST_SKIP() << "needs openxr-layer-corevalidation";
    if (std::system("command -v xvfb-run >/dev/null") != 0) GTEST_SKIP() << "no X server available";
    json s = scenario(60);
    s["extensions"] = {"XR_KHR_opengl_enable", "XR_KHR_composition_layer_depth"};  // it does not know EGL
    s["hands"] = {hand(8, "right", pointing({0.2, 1.2, -0.2}, {0, 1, -3}), {{"/input/b/click", true}}),
                  hand(12, "left", pointing({-0.2, 1.2, -0.2}, {0, 1, -3}), {{"/input/thumbstick", {0, 1}}})};
    s["events"] = {{{"frame", 20}, {"lose", "session"}}, {{"frame", 40}, {"lose", "instance"}}};
    const Run run = play(s, "",
                         "env XR_ENABLE_API_LAYERS=XR_APILAYER_LUNARG_core_validation "
                         "XR_CORE_VALIDATION_EXPORT_TYPE=text xvfb-run -a -s '-screen 0 640x480x24'");
    EXPECT_EQ(run.code, 0);
    EXPECT_NE(run.message.find("Core Validation"), std::string::npos)
        << "the layer is there: " << run.message;
    EXPECT_EQ(run.message.find("VALID_"), std::string::npos) << run.message;
}

TEST_F(HeadsetProgram, SticksTurnAndTeleportOntoTheFloor) {
    json s = scenario(90);
    s["eyes"] = {eye(97, 97, -45, 45, 45, -45, -0.032), eye(97, 97, -45, 45, 45, -45, 0.032)};
    // Looks ahead; teleports ahead; looks down; turns by 30 degrees and looks ahead.
    const Eigen::Quaterniond down(Eigen::AngleAxisd(-90 * degree, Vector3d::UnitX()));
    s["head"] = {pose({0, 1.6, 0}), pose({0, 1.6, 0}, down), pose({0, 1.6, 0})};
    s["head"][0]["frame"] = 0, s["head"][1]["frame"] = 40, s["head"][2]["frame"] = 60;
    const json upward = pointing({0.2, 1.2, -0.2}, {0.2, 1.2 + std::tan(35 * degree), -1.2});
    const auto stick = [&](int frame, double right, double ahead) {
        return hand(frame, "right", upward, {{"/input/thumbstick", {right, ahead}}});
    };
    const auto away = [](int frame) {  // nothing of it is in the picture
        return json{{"frame", frame}, {"hand", "right"}, {"active", false}};
    };
    s["hands"] = {stick(10, 0, 0), stick(20, 0, 1), stick(26, 0, 0), away(30),
                  stick(60, 0, 0), stick(64, 1, 0), stick(70, 0, 0), away(74)};
    s["save"] = {38, 58, 88};
    for (const int frame : {34, 36, 84, 86}) s["events"].push_back({{"frame", frame}, {"late", 180}});
    const Run run = play(s, "--fps 0 --max-photos 0 --thumbnails --meters-per-unit 1");
    expect_valid(run);
    const auto distance = [&](int frame) {
        char name[40];
        std::snprintf(name, sizeof name, "%04d-left-depth.pfm", frame);
        return middle_distance(dir / "out" / name,
                               run.frames.at(std::size_t(frame - 1))["layers"][0]["views"][0]);
    };
    // A stone that is thrown up at 35 degrees, at 7.5 m/s, from 1.2 m over the floor to the ground at 0.
    const PackageReader package(file);
    Room room(package.photos()[2], Vector3d::UnitZ(), {0, 1.6, 0}, 1);
    const double ground = room.in_room({0, 0, -package.scene().origin[2]}).y();
    const double up = 7.5 * std::sin(35 * degree), g = 9.81;
    const double seconds = (up + std::sqrt(up * up + 2 * g * (1.2 - ground))) / g;
    const double thrown = 7.5 * std::cos(35 * degree) * seconds;
    EXPECT_GT(thrown, 6);
    room.at = room.in_scene({0.2, ground, -0.2 - thrown});
    const gl::HeadlessContext context;
    const View there = room.view(run.frames.at(37)["layers"][0]["views"][0]);
    EXPECT_GT(psnr(saved(38, "left"), offscreen_picture(package, there, all(package), true)), 35);
    EXPECT_NEAR(distance(58), 1.6, 0.03) << "the eyes are 1.6 m over the ground";
    // Turned by 30 degrees to the right, about the head.
    room.axes = room.axes * Eigen::AngleAxisd(-30 * degree, Vector3d::UnitY()).toRotationMatrix();
    const View turned = room.view(run.frames.at(87)["layers"][0]["views"][0]);
    EXPECT_GT(psnr(saved(88, "left"), offscreen_picture(package, turned, all(package), true)), 35);
}

TEST_F(HeadsetProgramAtLength, TwoHandsMakeTheModelTwiceAsLarge) {
    json s = scenario(60);
    s["eyes"] = {eye(97, 97, -45, 45, 45, -45, -0.032), eye(97, 97, -45, 45, 45, -45, 0.032)};
    const auto at = [&](int frame, const char* which, double x, bool closed) {
        return hand(frame, which, pointing({x, 1.6, 0}, {x, 1.6, -3}),
                    {{"/input/squeeze/value", closed ? 1 : 0}});
    };
    s["hands"] = {at(10, "left", -0.2, false), at(10, "right", 0.2, false), at(20, "left", -0.2, true),
                  at(20, "right", 0.2, true),  at(30, "left", -0.4, true),  at(30, "right", 0.4, true),
                  at(40, "left", -0.4, false), at(40, "right", 0.4, false)};
    s["save"] = {18, 58};
    const Run run = play(s, "--fps 0 --meters-per-unit 1");
    expect_valid(run);
    const double before =
        middle_distance(dir / "out" / "0018-left-depth.pfm", run.frames[17]["layers"][0]["views"][0]);
    const double after =
        middle_distance(dir / "out" / "0058-left-depth.pfm", run.frames[57]["layers"][0]["views"][0]);
    EXPECT_NEAR(after / before, 2, 0.01) << "about the middle between the hands, where the eyes are";
}

TEST_F(HeadsetProgramAtLength, HandsOverTheDepthOfTheNearestObject) {
    const PackageReader package(file);
    const package::PhotoRecord& photo = package.photos()[2];
    const std::vector<Corners> mesh = triangles_of(make_plan_scene(package));
    // The same again, nearer and to one side.
    const Eigen::Matrix3d axes = view_of_photo(photo, 1).cam_from_origin.R;
    const Vector3d moved = seen_distance(photo) * (0.2 * axes.row(0) - 0.3 * axes.row(2)).transpose();
    SceneObject other{"second", file, {}};
    other.placement.move = moved;
    file = dir / "both.toml";
    write_scene_file(file, {{"first", dir / package.path().filename(), {}}, other});
    json s = scenario(20);
    s["save"] = {18};
    const Run run = play(s, "--fps 0 --meters-per-unit 1");
    expect_valid(run);
    const json& submitted = run.frames[17]["layers"][0]["views"][0];
    const View view = Room(photo, Vector3d::UnitZ(), {0, 1.6, 0}, 1).view(submitted);
    int of_first = 0, of_second = 0;
    for (int y = 6; y < 108; y += 12)
        for (int x = 6; x < 96; x += 12) {
            const double first = distance_by_hand(view, x, y, mesh),
                         second = distance_by_hand(view, x, y, mesh, moved), truth = std::min(first, second);
            if (!std::isfinite(truth)) continue;
            ++(first < second ? of_first : of_second);
            EXPECT_NEAR(distance_at(dir / "out" / "0018-left-depth.pfm", submitted, x, y), truth,
                        0.02 * truth)
                << x << ", " << y;
        }
    EXPECT_GT(of_first, 3);
    EXPECT_GT(of_second, 3);
}

TEST_F(HeadsetProgramAtLength, TakesAVisitorFromStopToStopOfATour) {
    const PackageReader package(file);
    const std::vector<Corners> mesh = triangles_of(make_plan_scene(package));
    const Vector3d origin = Eigen::Map<const Vector3d>(package.scene().origin);
    const auto looking = [&](std::size_t p) {
        const Pose camera = view_of_photo(package.photos()[p], 1).cam_from_origin;
        return StoryView{
            camera.center() + origin,
            camera.center() + origin + camera.R.row(2).transpose() * seen_distance(package.photos()[p])};
    };
    const std::array<StoryView, 2> stops{looking(0), looking(4)};
    Story story;
    story.notes = {{"gate", {"Gate", {}}, {"Of iron.", {}}, "", stops[1], {}}};
    story.tours = {{"round", {"Round", {}}, {{"", stops[0], 0.15, 0.3}, {"gate", {}, 0.15, 0.3}}}};
    write_story(story_file_of(file), story);
    MenuAlone menu(file, 1);
    Script script;
    script.open_or_close_menu();
    for (const char* name : {"Page Story", "Play Round"}) {
        script.click(menu.place(name));
        menu.press(name);
    }
    menu.told.open = 0;
    menu.frames(2);
    const std::array<int, 2> at{script.frame + 20, script.frame + 20 + 40};
    const auto played = [&](const Script& with) {
        json s = scenario(with.frame + 4);
        s["hands"] = with.hands;
        s["save"] = at;
        const Run run = play(s, "--fps 0 --meters-per-unit 1 --max-photos 1 --thumbnails --controls " +
                                    (dir / "controls").string());
        expect_valid(run);
        return run;
    };
    const auto has = [&](const std::string& name) {
        const auto controls = controls_in(slurp(dir / "controls"));
        return std::ranges::any_of(controls, [&](const auto& c) { return c.first == name; });
    };
    // The card of the last stop stays open when the tour is over.
    Script whole = script;
    whole.frame = at[1] + 30;
    whole.click(menu.place("All notes"));
    const Run run = played(whole);
    EXPECT_TRUE(has("Play Round"));
    for (const std::size_t stop : {0, 1}) {
        const json& views = run.frames[std::size_t(at[stop]) - 1]["layers"][0]["views"];
        const Stance stance = standing(head_between(views), stops[stop].eye - origin,
                                       stops[stop].target - origin, Vector3d::UnitZ(), 1);
        const auto angle = [&](std::size_t i) { return double(views[0]["fov"][i].get<float>()); };
        const View view = view_of_eye(
            stance, *eye_frustum(eye_pose(views[0]), angle(0), angle(1), angle(2), angle(3)), {96, 108});
        char name[32];
        std::snprintf(name, sizeof name, "%04d-left-depth.pfm", at[stop]);
        int right = 0, all = 0;
        for (int y = 6; y < 108; y += 16)
            for (int x = 6; x < 96; x += 16) {
                const double truth = distance_by_hand(view, x, y, mesh);
                if (!std::isfinite(truth)) continue;
                ++all;
                right += std::abs(distance_at(dir / "out" / name, views[0], x, y) - truth) < 0.02 * truth;
            }
        EXPECT_GT(all, 8);
        EXPECT_GE(right, all - 2) << "stop " << stop << ": but for outlines";
    }
    // Somebody who flies leaves the tour before its note.
    for (const int y : {0, 1, 0}) {
        script.frame += 6;
        script.hands.push_back(hand(script.frame, "left", pointing({-0.2, 1.3, -0.1}, {-3, 1.3, -0.1}),
                                    {{"/input/thumbstick", {0, y}}}));
    }
    script.frame = at[1];
    played(script);
    EXPECT_TRUE(has("Play Round"));
}

TEST_F(HeadsetProgramAtLength, MeasuresBetweenTwoPointsToAMillimeter) {
    const PackageReader package(file);
    const PlanScene scene = make_plan_scene(package);
    const Room room(package.photos()[2], Vector3d::UnitZ(), {0, 1.6, 0}, 1);
    Script script;
    const auto points = seen_middles(scene, room.in_scene(script.from), 3, 20, 2);
    ASSERT_EQ(points.size(), 2u);
    script.open_or_close_menu();
    script.click(MenuAlone(file, 1).place("Page Measure"));
    script.open_or_close_menu();
    for (const Vector3d& p : points) script.select(room.in_room(p));
    json s = scenario(script.frame + 4);
    s["hands"] = script.hands;
    expect_valid(play(s, "--meters-per-unit 1"));
    const json survey = json::parse(slurp(fs::path(file).replace_extension(".measurements.json")));
    ASSERT_EQ(survey["measurements"].size(), 1u) << survey;
    const Vector3d origin = Eigen::Map<const Vector3d>(package.scene().origin);
    for (const std::size_t i : {0, 1}) {
        const json& p = survey["measurements"][0]["points"][i]["position"];
        const Vector3d set(p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
        EXPECT_LT((set - origin - points[i]).norm(), 0.001) << "point " << i;
    }
}

TEST_F(HeadsetProgramAtLength, EveryEntryOfTheMenuCanBePressed) {
    std::size_t pressed = 0;
    for (const auto& [page, at] : MenuAlone(file).places()) {
        if (!page.starts_with("Page ")) continue;
        MenuAlone menu(file);
        menu.press(page);
        Script script;
        script.open_or_close_menu();
        script.click(at);
        for (const auto& [name, place] : menu.places()) {
            if (name.starts_with("Page ") || name == "Leave" || name == "Tooltip") continue;
            script.click(place);
            ++pressed;
        }
        json s = scenario(script.frame + 4);
        s["hands"] = script.hands;
        expect_valid(play(s));
    }
    EXPECT_GT(pressed, 60u);
}

TEST_F(HeadsetProgram, TheMenuDoesWhatItSays) {
    MenuAlone menu(file, 1);
    std::size_t pressed = 0, changed = 0;
    for (const auto& [page, at] : menu.places()) {
        if (!page.starts_with("Page ")) continue;
        menu.press(page);
        EXPECT_TRUE(menu.has(page)) << "pages stay beside the page that is shown";
        for (const auto& [name, place] : menu.places()) {
            if (name.starts_with("Page ") || name == "Leave" || name == "Tooltip" || !menu.has(name))
                continue;
            const RenderSettings before = menu.session.settings;
            const auto photos = menu.session.photos;
            const auto shown = menu.places();
            menu.press(name);
            if (menu.popup_open) {  // a list, whose last entry is chosen
                std::string entry = name;
                for (const auto& [other, at_other] : menu.places())
                    if (std::ranges::count(shown, other, [](const auto& c) { return c.first; }) == 0)
                        entry = other;
                menu.press(entry);
            }
            EXPECT_FALSE(menu.popup_open) << name;
            ++pressed;
            changed += !(before == menu.session.settings && photos == menu.session.photos);
        }
    }
    EXPECT_GT(pressed, 60u);
    EXPECT_GT(changed, 20u);
    menu.press("Page Move");
    menu.press("90");
    EXPECT_EQ(menu.walk.snap_degrees, 90);
    EXPECT_FALSE(menu.session.quit);
    menu.press("Leave");
    EXPECT_TRUE(menu.session.quit);
}

TEST_F(HeadsetProgram, LeavesByTheMenu) {
    Script script;
    script.open_or_close_menu();
    script.click(MenuAlone(file).place("Leave"));
    json s = scenario(10000);
    s["hands"] = script.hands;
    const Run run = play(s);
    expect_valid(run);
    EXPECT_LT(run.frames.size(), 200u);
}
