#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/gl/context.h"
#include "player/headset/headset_menu.h"
#include "player/headset/scene_interface.h"
#include "player/options/show_options.h"
#include "player/window/start_session.h"

namespace vantage {

/// The headset menu, tested without a headset.
class MenuAlone {
  public:
    explicit MenuAlone(const std::filesystem::path& file, double unit_meters = 0)
        : package_(file),
          options_(options_of(file)),
          session(start_session(package_, options_, start_settings(package_, options_, {}), state_)),
          scene_(package_, {{"scene", file, {}, true}}, options_, session),
          active(scene_.active),
          unit_meters_(unit_meters) {
        locomotion.usual_scale = locomotion.stance.scale = unit_meters > 0 ? 1 / unit_meters : 1;
        session.window.keyboard = session.window.panels.measure = false;
        scene_.renderer.draw(view_of(session.viewpoint.camera, 32, 24), session.settings, {}, {},
                             0);  // menus need a previous frame
        frames(3);
    }
    void frames(int count, const PanelPointer& pointer = {}) {
        for (int i = 0; i < count; ++i) {
            now_ += 1.0 / 90;
            scene_.attend(session);
            interface_.begin(pointer, 1.0 / 90);
            scene_.measure.attend(session, now_);
            headset_menu(interface_.controls(), session, {scene_, page, locomotion, unit_meters_, vignette},
                         {SceneInterface::width, SceneInterface::height}, now_);
            popup_open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
            interface_.end({}, {{100, 100, 100, 100, 50, 50}, {}});
        }
    }
    void press(const Eigen::Vector2d& at) {
        frames(2, {at});
        frames(2, {at, true});
        frames(2, {at});
    }
    void press(const std::string& name) { press(place(name)); }
    /// The positions of the controls on the panel, where a ray can hit them.
    std::vector<std::pair<std::string, Eigen::Vector2d>> places() {
        std::vector<std::pair<std::string, Eigen::Vector2d>> out;
        for (const Controls::Place& p : interface_.controls().places()) {
            const Eigen::Vector2d middle(double(p.low.x + std::min((p.high.x - p.low.x) / 2, 60.0f)),
                                         double(p.low.y + p.high.y) / 2);
            if (middle.x() < SceneInterface::width && middle.y() < SceneInterface::height)
                out.emplace_back(p.name, middle);
        }
        return out;
    }
    bool has(const std::string& name) {
        const auto all = places();
        return std::ranges::count(all, name, [](const auto& p) { return p.first; }) > 0;
    }
    Eigen::Vector2d place(const std::string& name) {
        const auto all = places();
        const auto at = std::ranges::find(all, name, [](const auto& p) { return p.first; });
        EXPECT_NE(at, all.end()) << name;
        return at == all.end() ? Eigen::Vector2d(0, 0) : at->second;
    }

  private:
    static ShowOptions options_of(const std::filesystem::path& file) {
        ShowOptions options;
        options.package.file = file.string();
        options.window.fresh = true;
        return options;
    }
    const gl::HeadlessContext context_;
    PackageReader package_;
    ShowOptions options_;
    WindowState state_;

  public:
    Session session;
    Locomotion locomotion;
    MenuPage page = MenuPage::move;
    bool vignette = true, popup_open = false;

  private:
    LoadedScene scene_;

  public:
    ActiveStory& active;

  private:
    double unit_meters_, now_ = 0;
    SceneInterface interface_;
};

}  // namespace vantage
