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

/// Depths of the drawn picture, top row first: a + b / z, where a and b are the `terms` and z is in scene
/// units; 0 beside the surfaces.
struct DrawnDepth {
    GLuint texture;
    Eigen::Vector2d terms;
};

/// The objects of a scene. The first object is drawn by the caller's renderer, and its coordinates are those
/// of the scene; the others have renderers of their own. Each object blends its own photos; at each pixel the
/// nearest object is shown. Use it only on the OpenGL thread.
class ObjectSet {
  public:
    static constexpr std::size_t max_objects = 16;

    /// `first` and its package must outlive the set; `objects.front()` describes `first`. `budget` covers all
    /// objects together. Throws the errors of add().
    ObjectSet(Renderer& first, const std::vector<SceneObject>& objects, const MemoryBudget& budget);

    /// Adds an object. Appends a number to a duplicate name and converts a matrix to a placement. Throws
    /// Error if the package cannot be shown, Error(usage) if there are too many objects.
    void add(const SceneObject& object);
    /// Removes an object other than the first one and frees its memory.
    void remove(std::size_t object);

    std::size_t size() const { return 1 + others_.size(); }
    /// Must not be called for the first object.
    const SceneObject& at(std::size_t object) const;
    void place(std::size_t object, const Placement& placement);
    void show_object(std::size_t object, bool shown);
    /// 0 to 1. Other objects show through an object whose opacity is below 1.
    void set_opacity(std::size_t object, double opacity);
    /// Shows only this object.
    void show_only(std::size_t object);
    /// The objects as listed in a scene file.
    std::vector<SceneObject> objects() const;
    /// The meshes of the visible objects, except the placeholder meshes of point-only scenes.
    std::vector<PlacedMesh> meshes() const;
    const FrameReport& report(std::size_t object) const;
    /// The sum over all objects.
    StreamedSoFar streamed() const;
    std::uint64_t graphics_budget() const;  ///< bytes
    /// Applies the trials to all renderers.
    void use_trials(const RenderTrials& trials);

    /// The samples of a pixel for all objects, as from Renderer::samples(). With stereo or several objects,
    /// there is always one frame per sample.
    std::vector<PixelSample> samples(std::span<const View> eyes, const RenderSettings& settings,
                                     int side) const;
    /// Draws all visible objects as Renderer::draw() draws one. The objects share `settings.upload_bytes`,
    /// but each may upload at least one tile. `photos`: the photos that the first object blends; the other
    /// objects blend all their photos. Scalar fields, image sets, background and comparisons are those of the
    /// first object.
    FrameReport draw(const View& view, const RenderSettings& settings, std::span<const std::uint32_t> photos,
                     PixelSample sample, double now, const View* next = nullptr);
    /// Draws all visible objects for one or two eyes, see Renderer::prepare(). Calls `drawn` after each eye;
    /// show() shows the eye that was drawn last.
    FrameReport draw_eyes(const FrameRequest& request, const std::function<void(std::size_t eye)>& drawn);
    /// Shows the last frame as Renderer::show() does. Comparisons show only the first object.
    void show(const View& view, const RenderSettings& settings, const ShowTarget& target);
    /// Depth of the last frame shown. For several objects, see Composition::nearest_depth().
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
    /// The sum over all renderers.
    template <class Of>
    auto sum(Of of) const;
    bool alone() const;
    SceneObject& object_at(std::size_t object);
    RenderSettings settings_of_others(const RenderSettings& settings) const;
    /// `settings.weights_from` is a view of the scene; it is transformed to the object's coordinates.
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

/// Draws `side` * `side` samples per pixel. `now`: as for Renderer::draw(). Returns the report of the last
/// sample.
FrameReport draw_samples(ObjectSet& objects, const View& view, const RenderSettings& settings,
                         std::span<const std::uint32_t> photos, int side, double now = 0);

/// Draws `side` * `side` samples per pixel for one or two eyes, and shows each eye in the framebuffer given
/// by `target`.
FrameReport draw_eye_samples(ObjectSet& objects, std::span<const View> eyes, const PictureSpec& spec,
                             const std::function<GLuint(std::size_t eye)>& target);

/// Renders all objects with `side` * `side` samples per pixel, like take_picture() for one object. `now`: as
/// for Renderer::draw().
Picture take_picture(ObjectSet& objects, const View& view, const RenderSettings& settings,
                     std::span<const std::uint32_t> photos, int side, double now = 0);

}  // namespace vantage
