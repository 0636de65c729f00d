#pragma once
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "tests/temporary_folder.h"
#include "tests/window/headless_window.h"
#include "tests/window/window_scenes.h"

namespace vantage {

inline constexpr auto control = KeyPress::With::control;

/// Each test has its own folder; the window writes its files there.
class WindowTest : public TemporaryFolder {
  protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        std::filesystem::current_path(dir);
        ::unsetenv("XDG_CURRENT_DESKTOP");  // no system file chooser
    }
    void TearDown() override {
        std::filesystem::current_path(std::filesystem::temp_directory_path());
        TemporaryFolder::TearDown();
    }
    /// Copies a package, so that the window may write beside it.
    std::filesystem::path copy_of(WindowScene scene, const std::string& name = "one.vantage") const {
        std::filesystem::copy_file(package_of(scene), dir / name);
        return dir / name;
    }
    /// Runs the window until `done` accepts the file's text. Fails the test if this takes more than a few
    /// seconds.
    template <class Done>
    std::string written_until(HeadlessWindow& w, const std::filesystem::path& file, const Done& done) const {
        std::string text;
        for (int i = 0; i < 500 && !done(text = slurp(file)); ++i) {
            w.frames();
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        EXPECT_TRUE(done(text)) << file << ": " << text.substr(0, 2000);
        return text;
    }
    std::string written(HeadlessWindow& w, const std::filesystem::path& file, const std::string& part) const {
        return written_until(w, file,
                             [&](const std::string& text) { return text.find(part) != std::string::npos; });
    }
};

}  // namespace vantage
