#include "player/composition/object_set.h"

#include <algorithm>
#include <numeric>

#include "base/text/error.h"
#include "player/composition/object_view.h"
#include "scene/package/contents/point_cloud.h"
#include "scene/remote/remote_package.h"

namespace vantage {
namespace {

Eigen::Vector3d origin_of(const PackageReader& package) {
    return Eigen::Map<const Eigen::Vector3d>(package.scene().origin);
}

}  // namespace

template <class Of>
auto ObjectSet::sum(Of of) const {
    auto out = of(first_);
    for (const auto& o : others_) out = out + of(*o->renderer);
    return out;
}

ObjectSet::ObjectSet(Renderer& first, const std::vector<SceneObject>& objects, const MemoryBudget& budget)
    : first_(first), first_object_(objects.front()), budget_(budget) {
    for (std::size_t i = 1; i < objects.size(); ++i) add(objects[i]);
}

std::string ObjectSet::free_name(const std::string& wanted) const {
    const auto taken = [&](const std::string& name) {
        return first_object_.name == name ||
               std::ranges::any_of(others_, [&](const auto& o) { return o->object.name == name; });
    };
    std::string name = wanted;
    for (int n = 2; taken(name); ++n) name = wanted + " " + std::to_string(n);
    return name;
}

void ObjectSet::add(const SceneObject& object) {
    if (size() == max_objects)
        throw Error(Exit::usage, object.package.string() + ": a scene has at most " +
                                     std::to_string(max_objects) + " objects");
    auto other = std::make_unique<Other>(
        Other{object, open_package(object.package, {.cache_bytes = budget_.cache}), {}, {}});
    other->package.fetch_scene();
    other->object.name = free_name(object.name);
    if (object.matrix) {
        other->object.placement = placement_of(*object.matrix, origin_of(other->package));
        other->object.matrix.reset();
    }
    other->photos.resize(other->package.photos().size());
    std::iota(other->photos.begin(), other->photos.end(), 0u);
    other->renderer = std::make_unique<Renderer>(other->package, budget_);
    others_.push_back(std::move(other));
    divide_budget();
}

void ObjectSet::remove(std::size_t object) {
    if (object == 0 || object >= size()) return;
    others_.erase(others_.begin() + std::ptrdiff_t(object - 1));
    composition_ = {};
    divide_budget();
}

/// Divides a limit on graphics memory evenly; without a limit, each object gets the memory that its frame
/// needs.
void ObjectSet::divide_budget() {
    const std::uint64_t held = sum([](const Renderer& r) { return r.held(); });
    MemoryBudget share = budget_;
    share.graphics = budget_.graphics / size();
    const auto set = [&](Renderer& renderer) {
        share.elsewhere = held - renderer.held();
        renderer.planner().set_budget(share);
    };
    set(first_);
    for (const auto& o : others_) set(*o->renderer);
}

const SceneObject& ObjectSet::at(std::size_t object) const {
    return object == 0 ? first_object_ : others_.at(object - 1)->object;
}

SceneObject& ObjectSet::object_at(std::size_t object) {
    return object == 0 ? first_object_ : others_.at(object - 1)->object;
}

void ObjectSet::place(std::size_t object, const Placement& placement) {
    if (object > 0) object_at(object).placement = placement;
}

void ObjectSet::show_object(std::size_t object, bool shown) { object_at(object).shown = shown; }

void ObjectSet::set_opacity(std::size_t object, double opacity) {
    object_at(object).opacity = std::clamp(opacity, 0.0, 1.0);
}

void ObjectSet::show_only(std::size_t object) {
    for (std::size_t i = 0; i < size(); ++i) show_object(i, i == object);
}

std::vector<SceneObject> ObjectSet::objects() const {
    std::vector<SceneObject> out;
    for (std::size_t i = 0; i < size(); ++i) out.push_back(at(i));
    return out;
}

std::vector<PlacedMesh> ObjectSet::meshes() const {
    std::vector<PlacedMesh> out;
    const auto has_mesh = [](const PackageReader& p) { return !points_only(p.scene()); };
    if (first_object_.shown && has_mesh(first_.package())) out.push_back({&first_.scene()});
    for (const auto& o : others_) {
        if (!o->object.shown || !has_mesh(o->package)) continue;
        const Placement& p = o->object.placement;
        out.push_back({&o->renderer->scene(), rotation_of(p),
                       origin_of(o->package) + p.move - origin_of(first_.package()), p.scale});
    }
    return out;
}

const FrameReport& ObjectSet::report(std::size_t object) const {
    return object == 0 ? first_report_ : others_.at(object - 1)->report;
}

StreamedSoFar ObjectSet::streamed() const {
    return sum([](const Renderer& r) { return r.resources().store.streamed(); });
}

std::uint64_t ObjectSet::graphics_budget() const {
    return sum([](const Renderer& r) { return r.planner().graphics_budget(); });
}

void ObjectSet::use_trials(const RenderTrials& trials) {
    first_.resources().trials = trials;
    for (const auto& o : others_) o->renderer->resources().trials = trials;
}

bool ObjectSet::alone() const {
    const bool others = std::ranges::any_of(others_, [](const auto& o) { return o->object.shown; });
    return !others && first_object_.shown && first_object_.opacity == 1;
}

RenderSettings ObjectSet::settings_of_others(const RenderSettings& settings) const {
    RenderSettings out = settings;
    out.fill_background = false;
    out.plain_background.soft_edges = 0;   // those of the whole picture
    out.background = ShowBackground::off;  // that of one object would hide the others
    out.field.index = -1;
    out.image_sets = {};
    out.compare = Compare::nothing;
    out.compare_photo = 0;
    out.exposure.reset();
    return out;
}

FrameReport ObjectSet::draw(const View& view, const RenderSettings& settings,
                            std::span<const std::uint32_t> photos, PixelSample sample, double now,
                            const View* next) {
    return draw_eyes({{&view, 1}, settings, photos, sample, now, next}, [](std::size_t) {});
}

bool ObjectSet::draws_first(const RenderSettings& settings) const {
    return first_object_.shown || settings.compare != Compare::nothing;
}

std::vector<PixelSample> ObjectSet::samples(std::span<const View> eyes, const RenderSettings& settings,
                                            int side) const {
    const bool one_picture = alone() && eyes.size() == 1;
    return one_picture ? first_.samples(eyes.front(), settings, side) : single_samples(side);
}

FrameReport ObjectSet::draw_eyes(const FrameRequest& request,
                                 const std::function<void(std::size_t eye)>& drawn) {
    if (alone())
        first_report_ = first_.prepare(request);
    else
        prepare(request);
    const bool paints_first = draws_first(request.settings);
    for (std::size_t eye = 0; eye < request.eyes.size(); ++eye) {
        paint(eye, paints_first);
        drawn(eye);
    }
    FrameReport all;
    all.settled = true;
    if (paints_first) all = first_report_;
    for (const auto& o : others_)
        if (o->object.shown) all = joined(all, o->report);
    return all;
}

void ObjectSet::paint(std::size_t eye, bool paints_first) {
    if (paints_first) first_.paint(eye, first_report_);
    for (const auto& o : others_)
        if (o->object.shown) o->renderer->paint(eye, o->report);
}

void ObjectSet::prepare(const FrameRequest& request) {
    const RenderSettings& settings = request.settings;
    divide_budget();
    RenderSettings of_first = settings;
    of_first.fill_background = false;
    // An even share of the frame's upload budget, plus the unused shares of previous objects.
    std::size_t uploaded = 0;
    auto to_draw = std::size_t(draws_first(settings)) +
                   std::size_t(std::ranges::count_if(others_, [](const auto& o) { return o->object.shown; }));
    const auto upload_share = [&] {
        return (settings.upload_bytes - std::min(settings.upload_bytes, uploaded)) / to_draw--;
    };
    if (draws_first(settings)) {
        of_first.upload_bytes = upload_share();
        first_report_ = first_.prepare(
            {request.eyes, of_first, request.photos, request.sample, request.now, request.next});
        uploaded += first_report_.uploaded;
    }
    RenderSettings of_others = settings_of_others(settings);
    for (const auto& o : others_) {
        if (!o->object.shown) continue;
        of_others.weights_from = settings.weights_from;
        of_others.sections = settings.sections;
        of_others.upload_bytes = upload_share();
        divide_budget();  // memory held by previous objects may have changed
        prepare_other(*o, request, of_others);
        uploaded += o->report.uploaded;
    }
}

void ObjectSet::prepare_other(Other& o, const FrameRequest& request, RenderSettings& settings) const {
    const auto seen_by = [&](const View& v) {
        return view_of_object(v, origin_of(first_.package()), origin_of(o.package), o.object.placement);
    };
    o.views.clear();
    for (const View& eye : request.eyes) o.views.push_back(seen_by(eye));
    if (settings.weights_from) settings.weights_from = seen_by(*settings.weights_from);
    for (SectionPlane& plane : settings.sections)
        plane = plane_of_object(plane, origin_of(first_.package()), origin_of(o.package), o.object.placement);
    std::optional<View> ahead;
    if (request.next) ahead = seen_by(*request.next);
    o.report = o.renderer->prepare(
        {o.views, settings, o.photos, request.sample, request.now, ahead ? &*ahead : nullptr});
}

void ObjectSet::show(const View& view, const RenderSettings& settings, const ShowTarget& target) {
    if (alone() || settings.compare != Compare::nothing) return first_.show(view, settings, target);
    RenderSettings of_first = settings;
    of_first.fill_background = false;
    of_first.plain_background.soft_edges = 0;
    const RenderSettings of_others = settings_of_others(settings);
    std::vector<ObjectFrame> frames;
    if (first_object_.shown) frames.push_back({&first_, view, of_first, 1, first_object_.opacity});
    for (const auto& o : others_)
        if (o->object.shown)
            frames.push_back({o->renderer.get(), o->views[target.eye], of_others, o->object.placement.scale,
                              o->object.opacity});
    composition_.show(frames, view, settings, target);
}

DrawnDepth ObjectSet::depth(const RenderSettings& settings, double near) {
    if (alone() || settings.compare != Compare::nothing)
        return {first_.resources().targets.surface().depth.id(), first_.resources().targets.depth_terms};
    return {composition_.nearest_depth(near).id(), {0, near}};
}

FrameReport draw_samples(ObjectSet& objects, const View& view, const RenderSettings& settings,
                         std::span<const std::uint32_t> photos, int side, double now) {
    FrameReport report;
    for (const PixelSample sample : objects.samples({&view, 1}, settings, side))
        report = objects.draw(view, settings, photos, sample, now);
    return report;
}

FrameReport draw_eye_samples(ObjectSet& objects, std::span<const View> eyes, const PictureSpec& spec,
                             const std::function<GLuint(std::size_t eye)>& target) {
    FrameReport report;
    const std::vector<PixelSample> samples = objects.samples(eyes, spec.settings, spec.side);
    for (const PixelSample& sample : samples)
        report =
            objects.draw_eyes({eyes, spec.settings, spec.photos, sample, spec.now}, [&](std::size_t eye) {
                if (&sample == &samples.back())
                    objects.show(eyes[eye], spec.settings, {target(eye), false, eye});
            });
    return report;
}

Picture take_picture(ObjectSet& objects, const View& view, const RenderSettings& settings,
                     std::span<const std::uint32_t> photos, int side, double now) {
    const FrameReport report = draw_samples(objects, view, settings, photos, side, now);
    Picture p = picture_of(frame_size(view), [&](GLuint target) { objects.show(view, settings, {target}); });
    p.report = report;
    return p;
}

}  // namespace vantage
