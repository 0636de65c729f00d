#include "player/interface/overlays/photo_marks.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

using namespace vantage;

namespace {

class PhotoMarks : public ::testing::Test {
  protected:
    PhotoMarks() : context_(ImGui::CreateContext()) {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = ImVec2(400, 300);
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
        ImGui::NewFrame();
    }
    ~PhotoMarks() override {
        ImGui::EndFrame();
        ImGui::DestroyContext(context_);
    }
    /// The shapes that are drawn, without their colors.
    static std::vector<std::pair<float, float>> shapes(const PhotoState& state) {
        ImDrawList list(ImGui::GetDrawListSharedData());
        list._ResetForNewFrame();
        list.PushClipRectFullScreen();
        list.PushTextureID(ImGui::GetIO().Fonts->TexID);
        draw_photo_marks(list, ImVec2(10, 10), ImVec2(110, 80), state, IM_COL32(200, 30, 30, 255));
        std::vector<std::pair<float, float>> out;
        for (const ImDrawVert& v : list.VtxBuffer) out.emplace_back(v.pos.x, v.pos.y);
        return out;
    }

  private:
    ImGuiContext* context_;
};

}  // namespace

TEST_F(PhotoMarks, TellEveryStateWithoutColors) {
    std::set<std::vector<std::pair<float, float>>> drawn;
    std::set<std::string> named;
    for (int bits = 0; bits < 16; ++bits) {
        const PhotoState state{.blended = (bits & 1) != 0,
                               .excluded = (bits & 2) != 0,
                               .viewed_from = (bits & 4) != 0,
                               .shows_point = (bits & 8) != 0};
        drawn.insert(shapes(state));
        named.insert(photo_state_text(state));
    }
    EXPECT_EQ(drawn.size(), 16u);
    EXPECT_EQ(named.size(), 16u);
    EXPECT_TRUE(shapes({}).empty()) << "a photo without marks has no shapes";
}
