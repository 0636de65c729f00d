// Commands from keys, menus, dialogs and dropped files.
#include <fstream>

#include "player/window/input/numbered_file.h"
#include "tests/window/window_test.h"

using namespace vantage;

namespace {

class WindowCommands : public WindowTest {
  protected:
    /// The name of the file that the window asks to open.
    static std::string opened(HeadlessWindow& w) {
        const auto open = take<OpenFile>(w.session.window.commands);
        return open ? std::filesystem::path(open->file).filename().string() : "";
    }
};

}  // namespace

TEST_F(WindowCommands, AreAllKeptInTheirOrder) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.tap(GLFW_KEY_P), w.tap(GLFW_KEY_Q, control), w.tap(GLFW_KEY_P);
    w.frames(4);
    ASSERT_EQ(w.session.window.commands.size(), 3u);
    EXPECT_TRUE(take<Quit>(w.session.window.commands));
    EXPECT_TRUE(take<SaveScreenshot>(w.session.window.commands) &&
                take<SaveScreenshot>(w.session.window.commands));
    EXPECT_FALSE(take<SaveScreenshot>(w.session.window.commands));
}

TEST_F(WindowCommands, EscClosesAMenuFirst) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.key(GLFW_KEY_TAB);
    w.key(GLFW_KEY_M);
    w.press("View");
    EXPECT_TRUE(w.there("Radar"));
    w.key(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(w.there("Radar"));
    EXPECT_TRUE(w.there("Snap to vertices")) << "Esc leaves measuring while a menu is open";
}

TEST_F(WindowCommands, TheDialogListsFoldersFirstAndIsUsedByKeysAlone) {
    const auto folder = dir / "folder";
    std::filesystem::create_directory(folder);
    std::filesystem::copy_file(package_of(WindowScene::tiny), folder / "two.vantage");
    HeadlessWindow w(copy_of(WindowScene::tiny));
    w.key(GLFW_KEY_O);
    const auto& places = w.controls.places();
    std::vector<std::string> entries;
    for (const auto& p : places)
        if (p.name.ends_with("/") || p.name.ends_with(".vantage")) entries.push_back(p.name);
    EXPECT_EQ(entries, (std::vector<std::string>{"../", "folder/", "one.vantage"}));
    w.point_at(w.place("folder/")), w.frames();
    w.double_click();
    EXPECT_TRUE(w.there("two.vantage")) << "a double-click opens a folder";
    w.key(GLFW_KEY_DOWN), w.key(GLFW_KEY_DOWN);
    w.key(GLFW_KEY_ENTER);
    EXPECT_EQ(opened(w), "two.vantage");
    EXPECT_FALSE(w.there("File name"));
    w.key(GLFW_KEY_O);
    w.type("nbv");
    w.key(GLFW_KEY_ENTER);
    EXPECT_EQ(opened(w), "nbv") << "letters are typed and do nothing else";
    EXPECT_FALSE(w.session.viewpoint.flight);
    w.key(GLFW_KEY_O);
    w.press("one.vantage");
    w.press("Open");
    EXPECT_EQ(opened(w), "one.vantage");
}

TEST_F(WindowCommands, AViewIsCopiedAsACommandLineAndPasted) {
    ShowOptions options;
    options.pictures.view = "1,-9,3,1,0,3,40";
    HeadlessWindow w(package_of(WindowScene::tiny), options);
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(w.package().scene().origin),
                          eye = w.session.viewpoint.camera.eye;
    EXPECT_LT((eye + origin - Eigen::Vector3d(1, -9, 3)).norm(), 1e-6);
    w.key(GLFW_KEY_C, control);
    const std::string copied = ImGui::GetClipboardText();
    EXPECT_NE(copied.find(" --view "), copied.npos) << copied;
    w.key(GLFW_KEY_N), w.wait(1);
    EXPECT_GT((w.session.viewpoint.camera.eye - eye).norm(), 1);
    w.key(GLFW_KEY_V, control), w.wait(1);
    EXPECT_LT((w.session.viewpoint.camera.eye - eye).norm(), 1e-4);
    EXPECT_NEAR(w.session.viewpoint.camera.fov, 40, 1e-4);
    ImGui::SetClipboardText("no view");
    w.key(GLFW_KEY_V, control), w.frames(3);
    EXPECT_TRUE(w.there("Message"));
    EXPECT_LT((w.session.viewpoint.camera.eye - eye).norm(), 1e-4);
}

TEST_F(WindowCommands, FilesThatCannotBeWrittenAreSaid) {
    if (!std::filesystem::exists("/proc/self")) GTEST_SKIP() << "this test needs a read-only folder";
    std::filesystem::create_directory("scans");
    HeadlessWindow w(copy_of(WindowScene::tiny, "scans/one.vantage"));
    std::filesystem::rename("scans", "moved");
    std::filesystem::current_path("/proc");
    w.key(GLFW_KEY_R), w.wait(0.5), w.key(GLFW_KEY_R);
    EXPECT_TRUE(w.there("Message"));
    EXPECT_NE(w.session.message.text.find("/proc/one-0001.path"), std::string::npos)
        << w.session.message.text;
    EXPECT_FALSE(w.there("Copy path")) << "no file was written";
}

TEST_F(WindowCommands, AWrittenFileIsBesideThePackageAndItsMessageLeadsThere) {
    std::filesystem::create_directory("scans");
    std::filesystem::create_directory("programs");
    std::ofstream("programs/xdg-open") << "#!/bin/sh\nprintf %s \"$1\" >'" << dir.string() << "/shown'\n";
    std::filesystem::permissions("programs/xdg-open", std::filesystem::perms::owner_all);
    HeadlessWindow w(copy_of(WindowScene::tiny, "scans/one.vantage"));
    w.resize(500, 700);
    w.key(GLFW_KEY_R), w.wait(0.5), w.key(GLFW_KEY_R);
    const std::filesystem::path file = dir / "scans/one-0001.path";
    EXPECT_TRUE(std::filesystem::exists(file));
    EXPECT_NE(w.session.message.text.find(file.string()), std::string::npos) << w.session.message.text;
    w.wait(10);
    EXPECT_TRUE(w.there("Message")) << "longer than messages without buttons";
    w.key(GLFW_KEY_M);
    const Eigen::Vector2d copy = w.place("Copy path"), measure = w.place("Measure");
    ASSERT_LT((copy - measure).norm(), 300) << "the panel is at the same place";
    w.press("Copy path");
    const char* const copied = ImGui::GetClipboardText();
    EXPECT_EQ(copied ? copied : "", file.string()) << "the message is above the panel";
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", (dir / "programs").c_str(), 1);
    w.press("Show the file");
    ::setenv("PATH", path.c_str(), 1);
    written(w, dir / "shown", file.parent_path().string());
    w.point_at({250, 600}), w.wait(20);
    EXPECT_FALSE(w.there("Message"));
}

TEST_F(WindowCommands, PicturesOfAPackageInAReadOnlyFolderAreInTheFolderOfPictures) {
    std::filesystem::create_directories("home/.config");
    std::filesystem::create_directories("home/Bilder");
    std::ofstream("home/.config/user-dirs.dirs") << "# folders\nXDG_PICTURES_DIR=\"$HOME/Bilder\"\n";
    const std::string home = std::getenv("HOME") ? std::getenv("HOME") : "";
    ::setenv("HOME", (dir / "home").c_str(), 1);
    ::unsetenv("XDG_CONFIG_HOME");
    std::filesystem::create_directory("scans");
    const PackageReader package(copy_of(WindowScene::tiny, "scans/one.vantage"));
    EXPECT_EQ(stem_for_files(package, "-a", true), dir / "scans/one-a");
    std::filesystem::rename("scans", "moved");
    EXPECT_EQ(stem_for_files(package, "-a", true), dir / "home/Bilder/one-a");
    EXPECT_EQ(stem_for_files(package, "-a"), dir / "one-a");
    ::setenv("HOME", home.c_str(), 1);
}

TEST_F(WindowCommands, AskWhatToDoWithADroppedPackage) {
    const std::filesystem::path package = copy_of(WindowScene::tiny);
    HeadlessWindow w(package);
    const auto dropped = [&](const char* answer) {
        w.session.window.commands.push_back(PlaceDropped{package.string()});
        w.frames(3);
        w.press(answer);
        EXPECT_FALSE(w.there("Add to the scene")) << answer;
    };
    dropped("Cancel");
    EXPECT_TRUE(w.session.window.commands.empty());
    dropped("Add to the scene");
    EXPECT_TRUE(w.session.window.panels.objects);
    w.key(GLFW_KEY_TAB);
    w.resize(900, 3000);
    EXPECT_TRUE(w.there("Remove one 2")) << "a name that is in use gets a number";
    dropped("Open in place of the scene");
    const auto opened = take<OpenFile>(w.session.window.commands);
    ASSERT_TRUE(opened);
    EXPECT_EQ(opened->file, package.string());
}

TEST_F(WindowCommands, AskAboutEachPackageThatIsDroppedAtOnce) {
    const std::filesystem::path package = copy_of(WindowScene::tiny);
    HeadlessWindow w(package);
    for (int i = 0; i < 2; ++i) w.session.window.commands.push_back(PlaceDropped{package.string()});
    w.frames(3);
    for (const char* answer : {"Add to the scene", "Cancel"}) w.press(answer);
    EXPECT_FALSE(w.there("Cancel"));
    EXPECT_TRUE(w.session.window.commands.empty());
}

TEST_F(WindowCommands, TheProjectionChangesBetweenPictures) {
    HeadlessWindow w(package_of(WindowScene::garden));
    w.session.settings.points.show = false;  // they are in perspective
    w.key(GLFW_KEY_TAB);
    for (const bool orthographic : {true, false}) {
        w.press("View");
        w.point_at(w.place("Orthographic")), w.frames();
        for (const bool down : {true, false}) {
            w.button(0, down);
            for (int frame = 0; frame < 3; ++frame) {
                w.frames();
                ASSERT_NO_THROW(w.draw()) << "a view with the other projection's background";
            }
        }
        EXPECT_EQ(w.session.viewpoint.orthographic, orthographic);
        w.frames(3);
    }
}
