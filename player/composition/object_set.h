#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "player/composition/composition.h"
#include "player/render/picture.h"
#include "player/survey/scene_point.h"
#include "scene/story/scene_file.h"

namespace vantage {

/// Depths of what was drawn: a + b / z, with `terms` a and b and z in the scene's unit; the picture's top row
/// first. 0: nothing.
struct DrawnDepth {
    GLuint texture;
    Eigen::Vector2d terms;
};

/// The objects of a scene: the first one, which the caller's renderer draws and whose coordinates are the
/// scene's, and others with renderers of their own. Each blends its own photos; at each pixel the nearest
/// object is shown. Belongs to the OpenGL thread.
class ObjectSet {
  public:
    static constexpr std::size_t max_objects = 16;

    /// `first` and its package must outlive the set; `objects.front()` says what it is. `budget` is that of
    /// all objects together. Throws Error, see add().
    ObjectSet(Renderer& first, const std::vector<SceneObject>& objects, const MemoryBudget& budget);

    /// Adds an object. A name that is taken gets a number, and a matrix becomes a placement. Throws Error for
    /// a package that cannot be shown, Error(usage) for one too many.
    void add(const SceneObject& object);
    /// Removes an object other than the first one and returns its memory.
    void remove(std::size_t object);

    std::size_t size() const { return 1 + others_.size(); }
    /// The first one cannot be placed.
    const SceneObject& at(std::size_t object) const;
    void place(std::size_t object, const Placement& placement);
    void show_object(std::size_t object, bool shown);
    /// 0 to 1. What is behind the object's nearest surface, of other objects, shows through it.
    void set_opacity(std::size_t object, double opacity);
    /// Shows this object alone.
    void show_only(std::size_t object);
    /// As a scene file lists them.
    std::vector<SceneObject> objects() const;
    /// The meshes of the objects that are shown, but for stand-ins of scenes of points only.
    std::vector<PlacedMesh> meshes() const;
    const FrameReport& report(std::size_t object) const;
    /// Of all objects together.
    StreamedSoFar streamed() const;
    std::uint64_t graphics_budget() const;  ///< bytes
    /// Of all renderers.
    void use_trials(const RenderTrials& trials);

    /// As Renderer::samples() of all objects; one for each sample with two eyes or several objects.
    std::vector<PixelSample> samples(std::span<const View> eyes, const RenderSettings& settings,
                                     int side) const;
    /// Draws all objects that are shown, as Renderer::draw does; `settings.upload_bytes` is for all
    /// together, but each may upload a tile.
    /// `photos`: of the first object; others blend all of theirs. Scalar fields, image sets, background and
    /// comparisons are those of the first object.
    FrameReport draw(const View& view, const RenderSettings& settings, std::span<const std::uint32_t> photos,
                     PixelSample sample, double now, const View* next = nullptr);
    /// The same for one eye or two, see Renderer::prepare. Calls `drawn` after each eye, which show() shows
    /// as long as the other one has not been drawn.
    FrameReport draw_eyes(const FrameRequest& request, const std::function<void(std::size_t eye)>& drawn);
    /// Shows what was drawn last, as Renderer::show does. A comparison shows the first object alone.
    void show(const View& view, const RenderSettings& settings, const ShowTarget& target);
    /// Of what was shown last; of several objects, of the nearest one, as Composition::nearest_depth().
    DrawnDepth depth(const RenderSettings& settings, double near);

  private:
    struct Other {
        SceneObject object;
        PackageReader package;
        std::unique_ptr<Renderer> renderer;
        std::vector<std::uint32_t> photos;
        std::vector<View> views{};  ///< per eye
        FrameReport report{};
    };
    /// Of all renderers.
    template <class Of>
    auto sum(Of of) const;
    bool alone() const;
    SceneObject& object_at(std::size_t object);
    RenderSettings settings_of_others(const RenderSettings& settings) const;
    /// `settings.weights_from` is a view of the scene, and becomes one of the object.
    void prepare_other(Other& other, const FrameRequest& request, RenderSettings& settings) const;
    void prepare(const FrameRequest& request);
    void paint(std::size_t eye, bool paints_first);
    bool draws_first(const RenderSettings& settings) const;
    void divide_budget();
    std::string free_name(const std::string& wanted) const;

    Renderer& first_;
    SceneObject first_object_;
    MemoryBudget budget_;
    FrameReport first_report_;
    std::vector<std::unique_ptr<Other>> others_;
    Composition composition_;
};

/// Draws `side` * `side` samples per pixel; `now` as for Renderer::draw. Returns the report of the last.
FrameReport draw_samples(ObjectSet& objects, const View& view, const RenderSettings& settings,
                         std::span<const std::uint32_t> photos, int side, double now = 0);

/// The same for one eye or two; shows each in the framebuffer that `target` names.
FrameReport draw_eye_samples(ObjectSet& objects, std::span<const View> eyes, const PictureSpec& spec,
                             const std::function<GLuint(std::size_t eye)>& target);

/// Renders all objects with `side` * `side` samples per pixel, as take_picture() does one; `now` as for
/// Renderer::draw.
Picture take_picture(ObjectSet& objects, const View& view, const RenderSettings& settings,
                     std::span<const std::uint32_t> photos, int side, double now = 0);

}  // namespace vantage
