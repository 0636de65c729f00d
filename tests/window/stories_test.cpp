// A curator writes notes and a tour in the window, and visitors see the notes and the tour.
#include <fmt/format.h>

#include <fstream>

#include "player/render/picture.h"
#include "player/survey/ray_cast.h"
#include "scene/story/story_file.h"
#include "tests/window/shown_text.h"
#include "tests/window/window_test.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

class WindowStories : public WindowTest {
  protected:
    WindowStories() {
        std::filesystem::create_directories(dir);
        package = copy_of(WindowScene::tiny);
        Picture p{40, 20, std::vector<std::uint8_t>(40 * 20 * 4, 200), {}};
        write_png(dir / "picture.png", p);
    }
    Story saved() const { return read_story(story_file_of(package)).story; }
    static Vector3d stands_at(const HeadlessWindow& w) {
        return w.session.viewpoint.camera.eye + Eigen::Map<const Vector3d>(w.package().scene().origin);
    }
    static void add_note(HeadlessWindow& w, const std::string& title) {
        w.point_at({450, 300});
        w.drag(2, 20, 0);
        w.press("Add a note");
        w.point_at({w.view().intrinsics.cx, w.view().intrinsics.cy}), w.frames();
        w.click();
        w.wait(1);  // no double click
        w.press("Title of the note"), w.type(title);
        w.press("Picture file of the note"), w.type("picture.png");
    }
    static std::string titles(const Story& story) {
        std::string out;
        for (const StoryNote& n : story.notes) out += (out.empty() ? "" : " ") + n.title.plain;
        return out;
    }
    /// Writes a tour and five notes at different positions. The first note has all properties.
    void write_five_notes() const {
        HeadlessWindow w(package);
        w.resize(1400, 900);
        w.key(GLFW_KEY_E, KeyPress::With::control);
        w.press("Set the opening view");
        for (const char* title : {"Tower", "Door", "Roof", "Gate", "Stairs"}) {
            add_note(w, title);
            if (std::string(title) == "Tower") w.press("Text of the note"), w.type("Built in 1702");
        }
        w.press("Make a tour of all notes");
        w.press("Save the story");
    }
    std::filesystem::path package;
};

}  // namespace

TEST_F(WindowStories, ACuratorWritesOrdersAndDeletesNotes) {
    HeadlessWindow w(package);
    w.resize(1400, 900);
    w.key(GLFW_KEY_E, KeyPress::With::control);
    const Vector3d opening = stands_at(w);
    w.press("Title of the story"), w.type("Chapel");
    w.press("Set the opening view");
    EXPECT_TRUE(w.there("Message"));
    EXPECT_EQ(w.session.viewpoint.home.eye, w.session.viewpoint.camera.eye) << "H flies there";
    add_note(w, "Tower");
    w.press("Text of the note"), w.type("Built in 1702");
    w.key(GLFW_KEY_ESCAPE);  // ends typing, and keeps the text
    for (const char* title : {"Door", "Roof", "Gate", "Stairs"}) add_note(w, title);
    w.press("Make a tour of all notes");
    w.fill_in("Flight", "1.5"), w.fill_in("Stay", "9999");
    w.fill_in("Title of the tour all", "Round"), w.fill_in("Title of the tour all", "Square");
    w.key(GLFW_KEY_Z, KeyPress::With::control);
    w.press("Make a tour of all notes");
    w.press("Save the story");
    Story story = saved();
    EXPECT_EQ(story.title.plain, "Chapel");
    EXPECT_EQ(titles(story), "Tower Door Roof Gate Stairs");
    EXPECT_EQ(story.notes[0].text.plain, "Built in 1702");
    EXPECT_EQ(story.notes[0].picture, "picture.png");
    EXPECT_TRUE(story.notes[0].anchor && story.notes[0].view);
    ASSERT_TRUE(story.opening);
    EXPECT_LT((story.opening->eye - opening).norm(), 0.01);
    EXPECT_GT((story.notes[4].view->eye - story.notes[0].view->eye).norm(), 0.1) << "each view is different";
    ASSERT_EQ(story.tours.size(), 1u);
    ASSERT_EQ(story.tours[0].stops.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(story.tours[0].stops[i].note, story.notes[i].id);
    EXPECT_EQ(story.tours[0].title.plain, "Round") << "undone";
    EXPECT_EQ(story.tours[0].stops[4].fly, 1.5) << "kept when the tour is made again";
    EXPECT_EQ(story.tours[0].stops[4].stay, 3600) << "the longest";
    w.press("Move up");
    w.press("Save the story");
    EXPECT_EQ(titles(saved()), "Tower Door Roof Stairs Gate");
    w.press("Move down");
    w.press("List 2");
    w.press("Delete");
    w.press("Save the story");
    EXPECT_EQ(titles(saved()), "Tower Roof Gate Stairs");
    const Vector3d before = saved().notes[0].view->eye;
    w.press("List 1"), w.wait(2);
    w.point_at({450, 300}), w.drag(2, 100, 0);
    w.press("Set its view");
    w.press("Save the story");
    EXPECT_GT((saved().notes[0].view->eye - before).norm(), 0.1);
}

TEST_F(WindowStories, UnsavedChangesAreAskedAbout) {
    HeadlessWindow w(package);
    w.resize(1400, 900);
    UserCommands& commands = w.session.window.commands;
    const auto quits = [&] {
        w.key(GLFW_KEY_Q, KeyPress::With::control);
        return take<Quit>(commands).has_value();
    };
    w.key(GLFW_KEY_E, KeyPress::With::control);
    EXPECT_TRUE(quits()) << "nothing has changed";
    w.press("Set the opening view");
    w.key(GLFW_KEY_Z, KeyPress::With::control);
    EXPECT_TRUE(quits()) << "all is undone";
    w.press("Set the opening view");
    EXPECT_FALSE(quits());
    EXPECT_NE(shown_text().find("Save the changes to the story one.story.json?"), std::string::npos);
    w.key(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(w.there("Discard") || holds<Quit>(commands));
    commands.push_back(OpenFile{"two.vantage"}), w.frames(3);
    EXPECT_FALSE(holds<OpenFile>(commands)) << "another scene waits for the answer, too";
    w.press("Discard");
    EXPECT_EQ(take<OpenFile>(commands).value_or(OpenFile{}).file, "two.vantage");
    w.frames();
    EXPECT_FALSE(std::filesystem::exists(story_file_of(package)));
    EXPECT_FALSE(quits());
    w.key(GLFW_KEY_ENTER);
    EXPECT_TRUE(take<Quit>(commands));
    EXPECT_TRUE(saved().opening);
    EXPECT_TRUE(quits()) << "all is saved";
    w.press("Set the opening view");
    std::ofstream(story_file_of(package)) << "{}";
    EXPECT_FALSE(quits());
    w.press("Save");
    EXPECT_FALSE(w.there("Discard") || holds<Quit>(commands)) << "the story could not be saved";
    EXPECT_TRUE(w.there("Message"));
}

TEST_F(WindowStories, AVisitorFollowsNotesAndTours) {
    write_five_notes();
    const Story story = saved();
    HeadlessWindow w(package);
    EXPECT_LT((stands_at(w) - story.opening->eye).norm(), 0.01) << "the window opens at the opening view";
    EXPECT_TRUE(w.there("List 5"));
    w.press("Note 2");
    w.wait(2);
    EXPECT_LT((stands_at(w) - story.notes[1].view->eye).norm(), 0.01);
    for (int i = 0; i < 200 && !w.there("Picture of the note"); ++i) {
        w.frames();
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    EXPECT_TRUE(w.there("Picture of the note"));
    w.press("Next note"), w.wait(2);
    EXPECT_LT((stands_at(w) - story.notes[2].view->eye).norm(), 0.01);
    w.press("Previous note"), w.wait(2);
    EXPECT_LT((stands_at(w) - story.notes[1].view->eye).norm(), 0.01);
    w.key(GLFW_KEY_H), w.wait(1);
    EXPECT_LT((stands_at(w) - story.opening->eye).norm(), 0.01);
    const auto shows = [](const std::string& text) { return shown_text().find(text) != std::string::npos; };
    const auto play = [&] {
        w.press("Play All notes"), w.frames(2);
        EXPECT_FALSE(w.there("Bar Home") || w.there("Photo 1") || w.there("List 1") || w.there("Note 1"));
        EXPECT_TRUE(shows("Esc or a click ends the tour")) << shown_text();
        w.point_at({450, 300});
    };
    play(), w.wait(4);
    EXPECT_TRUE(w.there("Caption") && shows("Tower") && shows("Built in 1702")) << shown_text();
    w.key(GLFW_KEY_ESCAPE);
    EXPECT_TRUE(w.there("Play All notes") && w.there("Bar Home") && w.there("Photo 1")) << "Esc ends a tour";
    EXPECT_FALSE(w.there("Caption"));
    w.session.window.panels.measure = true;
    play(), w.click();
    EXPECT_TRUE(w.there("Play All notes") && w.there("Snap to vertices")) << "a click does, too";
    EXPECT_FALSE(w.session.viewpoint.flight);
    w.key(GLFW_KEY_M);
    play(), w.key(GLFW_KEY_F1);
    EXPECT_TRUE(w.there("Play All notes") && w.session.window.panels.help) << "so does a key for a panel";
    w.key(GLFW_KEY_F1);
    w.key(GLFW_KEY_H), w.wait(1);
    play(), w.wait(120);
    EXPECT_FALSE(w.session.viewpoint.flight);
    EXPECT_LT((stands_at(w) - story.notes[4].view->eye).norm(), 0.01) << "a tour ends at its last stop";
    w.key(GLFW_KEY_J);
    EXPECT_FALSE(w.there("List 1"));
    EXPECT_FALSE(w.there("Note 1"));
    w.key(GLFW_KEY_J);
    EXPECT_TRUE(w.there("List 1"));
}

TEST_F(WindowStories, WhatAnotherProgramWroteIsNotReplaced) {
    write_five_notes();
    HeadlessWindow w(package);
    w.resize(1400, 900);
    const auto file = story_file_of(package);
    std::string text = slurp(file);
    text.replace(text.find("Door"), 4, "Yard");
    std::ofstream(file) << text;
    w.key(GLFW_KEY_E, KeyPress::With::control);
    w.press("List 1");
    w.press("Set its view");
    w.press("Save the story");
    EXPECT_TRUE(w.there("Message"));
    EXPECT_EQ(slurp(file), text);
}

TEST_F(WindowStories, AnIdleKioskShowsItsLoopAndAnInvitation) {
    write_five_notes();
    Story story = saved();
    story.attract = StoryAttract{5, "", {{story.notes[0].id, {}, 3, 60}}, 0};
    write_story(story_file_of(package), story);
    ShowOptions options;
    options.window.kiosk = true;
    HeadlessWindow w(package, options);
    w.point_at({450, 200}), w.frames(3);
    EXPECT_TRUE(w.there("Bar Home"));
    EXPECT_FALSE(w.there("Caption"));
    w.press("Note 2"), w.wait(2);
    EXPECT_TRUE(w.there("Next note"));
    w.wait(12);
    EXPECT_TRUE(w.there("Caption"));
    EXPECT_FALSE(w.there("Bar Home") || w.there("Note 2"));
    w.point_at({451, 200}), w.frames(3);
    EXPECT_TRUE(w.there("Bar Home"));
    EXPECT_FALSE(w.there("Caption"));
    EXPECT_FALSE(w.there("Next note")) << "the next visitor chooses a note";
    w.wait(2);
    EXPECT_EQ(w.session.viewpoint.camera.eye, w.session.viewpoint.home.eye)
        << "and begins at the opening view";
    w.press("Bar Compare"), w.wait(1);
    EXPECT_TRUE(w.there("Swipe"));
    EXPECT_FALSE(w.there("Note 2") || w.there("List 2")) << "they would cover the photo";
    w.press("Bar Compare"), w.wait(1);
    w.press("Play All notes"), w.wait(15);
    EXPECT_TRUE(w.session.viewpoint.flight && w.there("Caption")) << "a visitor's tour is not idleness";
    EXPECT_EQ(shown_text().find("Touch to begin"), std::string::npos) << shown_text();
}

TEST_F(WindowStories, AKioskShowsAndDoesNotEditThem) {
    write_five_notes();
    Story story = saved();
    set_text(story, story.notes[1].title, "it", "Porta");
    write_story(story_file_of(package), story);
    const std::string text = slurp(story_file_of(package));
    ShowOptions options;
    options.window.kiosk = true;
    HeadlessWindow w(package, options);
    ASSERT_TRUE(w.there("Note 2"));
    w.press("Note 2"), w.wait(2);
    ASSERT_TRUE(w.there("Next note"));
    const Eigen::Vector2d card = w.place("Next note");
    for (const double left : {20.0, 80.0}) {  // where the card's title has a button to collapse it; the title
        w.point_at({left, 26}), w.frames();
        w.click(), w.frames(3);
        w.drag(0, 90, 120), w.frames(3);
    }
    ASSERT_TRUE(w.there("Next note"));
    EXPECT_LT((w.place("Next note") - card).norm(), 60) << "a visitor cannot move the card away";
    EXPECT_FALSE(w.there("Language")) << "the bar has the only choice of a language";
    w.choose("Bar Language", "Italiano");
    EXPECT_NE(shown_text().find("Porta"), std::string::npos) << shown_text();
    w.key(GLFW_KEY_EQUAL, KeyPress::With::control);
    EXPECT_EQ(w.session.window.text_scale, 1) << "the next visitor would find it";
    w.key(GLFW_KEY_E, KeyPress::With::control);
    EXPECT_FALSE(w.there("Save the story"));
    EXPECT_EQ(slurp(story_file_of(package)), text);
}

TEST_F(WindowStories, ANoteIsPlacedAndMovedWithTheMouse) {
    ShowOptions options;
    options.package.photos = {"0002.jpg"};
    HeadlessWindow w(package, options);
    w.resize(1400, 900);
    const Vector3d origin = Eigen::Map<const Vector3d>(w.package().scene().origin), eye = stands_at(w);
    const auto pixel_of = [&](const Vector3d& place) {
        return project(w.view().intrinsics, w.view().cam_from_origin, place - origin)->pixel;
    };
    const auto click_at = [&](const Eigen::Vector2d& pixel) {
        w.wait(1);
        w.point_at(pixel), w.frames();
        w.click();
    };
    const Vector3d low(1.6, 0, 3.7), high(1.6, 0, 5.3);  // on the wall
    const auto saved_anchor = [&] {
        w.press("Save the story");
        return saved().notes.at(0).anchor.value_or(Vector3d::Zero());
    };
    w.key(GLFW_KEY_E, KeyPress::With::control);
    w.press("Add a note");
    click_at({1390, 450});
    EXPECT_TRUE(w.there("Message")) << "the click missed the model";
    click_at(pixel_of(low));
    EXPECT_LT((saved_anchor() - low).norm(), 0.02);
    click_at(pixel_of(high));
    EXPECT_FALSE(w.there("List 2")) << "only one click places a note";
    w.point_at(w.place("Note 1"));
    const Eigen::Vector2d by = pixel_of(high) - w.place("Note 1");
    w.drag(0, by.x(), by.y());
    EXPECT_FALSE(w.session.viewpoint.flight) << "the end of a drag is not a click";
    EXPECT_LT((saved_anchor() - high).norm(), 0.02);
    EXPECT_LT((stands_at(w) - eye).norm(), 1e-9) << "dragging a mark is neither a click nor an orbit";
    w.press("Move its mark");
    click_at(pixel_of(low));
    EXPECT_LT((saved_anchor() - low).norm(), 0.02);
    w.press("Add a note");
    w.point_at(pixel_of(high)), w.frames();
    w.key(GLFW_KEY_ESCAPE);
    click_at(pixel_of(high));
    EXPECT_FALSE(w.there("List 2")) << "Esc cancels";
}

TEST_F(WindowStories, ACuratorHidesAPieceForVisitors) {
    ShowOptions options;
    options.package.photos = {"0002.jpg"};
    const Vector3d on_wall(1.6, 0, 3.7);
    const auto shows_wall = [&](HeadlessWindow& w) {
        const Vector3d place = on_wall - Eigen::Map<const Vector3d>(w.package().scene().origin);
        const auto hit = first_hit(
            w.scene(),
            ray_through(w.view(), project(w.view().intrinsics, w.view().cam_from_origin, place)->pixel));
        return hit && (hit->position - place).norm() < 0.1;
    };
    {
        HeadlessWindow w(package, options);
        w.resize(1400, 900);
        ASSERT_TRUE(shows_wall(w));
        const auto click_on_wall = [&] {
            const Vector3d place = on_wall - Eigen::Map<const Vector3d>(w.package().scene().origin);
            w.wait(1);
            w.point_at(project(w.view().intrinsics, w.view().cam_from_origin, place)->pixel), w.frames();
            w.click();
        };
        w.key(GLFW_KEY_E, KeyPress::With::control);
        w.press("Hide pieces");
        click_on_wall();
        EXPECT_FALSE(shows_wall(w));
        w.key(GLFW_KEY_Z, KeyPress::With::control);
        EXPECT_TRUE(shows_wall(w)) << "undone";
        w.wait(1);
        click_on_wall();
        w.key(GLFW_KEY_ESCAPE);
        click_on_wall();
        w.press("Save the story");
        const std::vector<StoryBall> hidden = saved().hidden;
        ASSERT_EQ(hidden.size(), 1u) << "after Esc, clicks hide nothing";
        EXPECT_LT((hidden[0].center - on_wall).norm(), 0.02);
    }
    Story story = saved();
    story.notes = {{"a", {}, {}, "", {}, on_wall}};
    write_story(story_file_of(package), story);
    options.window.kiosk = true;
    HeadlessWindow visitor(package, options);
    EXPECT_FALSE(shows_wall(visitor));
    EXPECT_TRUE(visitor.there("List 1"));
    EXPECT_FALSE(visitor.there("Note 1")) << "its mark is hidden, too";
}

TEST_F(WindowStories, TheBarSharesTheStorysPage) {
    Story story;
    story.web = "https://example.org/chapel";
    {
        HeadlessWindow w(package);
        EXPECT_FALSE(w.there("Bar Share")) << "the story has no page";
    }
    write_story(story_file_of(package), story);
    for (const bool kiosk : {false, true}) {
        ShowOptions options;
        options.window.kiosk = kiosk;
        HeadlessWindow w(package, options);
        w.press("Bar Share");
        EXPECT_TRUE(w.there("QR code"));
        EXPECT_NE(shown_text().find(story.web), std::string::npos) << shown_text();
        EXPECT_NE(w.there("Copy address"), kiosk);
    }
}

TEST_F(WindowStories, OpenWithOnlyTheObjectIfSavedThatWay) {
    const auto garden = copy_of(WindowScene::garden, "garden.vantage");
    const auto shown_after = [&](const char* pressed) {
        HeadlessWindow w(garden);
        const ShowBackground shown = w.session.settings.background;
        w.resize(1400, 900);
        w.press(pressed);
        w.key(GLFW_KEY_E, KeyPress::With::control);
        w.press("Set the opening view"), w.press("Save the story");
        return shown;
    };
    EXPECT_EQ(shown_after("Bar Only the object"), ShowBackground::on);
    EXPECT_EQ(shown_after("Bar Only the object"), ShowBackground::off);
    EXPECT_EQ(shown_after("Bar Home"), ShowBackground::on);
}
