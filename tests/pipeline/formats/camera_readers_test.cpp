// Camera files as users have them: with cameras that no photo uses, without any, or of other things.
#include <gtest/gtest.h>

#include <fstream>

#include "pipeline/formats/cameras.h"
#include "tests/temporary_folder.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

class CameraReaders : public TemporaryFolder {
  protected:
    fs::path put(const std::string& name, const std::string& text) const {
        std::ofstream(dir / name, std::ios::binary) << text;
        return dir / name;
    }
    /// Expects an error of this type whose line contains these words.
    template <class E = Error>
    static void expect_error(const fs::path& cameras, const std::string& words) {
        try {
            read_cameras(cameras);
            ADD_FAILURE() << cameras << " is read; expected: " << words;
        } catch (const E& e) {
            EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
        }
    }
};

TEST_F(CameraReaders, ColmapCameraHasAsManyParametersAsItsModel) {
    put("images.txt", "1 1 0 0 0 0 0 0 1 a.jpg\n\n");
    put("cameras.txt", "1 SIMPLE_PINHOLE 640 480 500 320 240 # of all photos\n");
    EXPECT_EQ(read_cameras(dir).entries.at(0).camera.intrinsics.cy, 240);
    for (const char* wrong : {"1 SIMPLE_PINHOLE 640 480 500 500 320 240\n",
                              "1 SIMPLE_PINHOLE 640 480 500 320\n2 PINHOLE 640 480 500 500 320 240\n"}) {
        put("cameras.txt", wrong);
        expect_error(dir, "cameras.txt, line 1: expected 3 parameters of SIMPLE_PINHOLE, found ");
    }
}

}  // namespace
}  // namespace vantage
