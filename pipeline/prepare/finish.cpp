#include "pipeline/prepare/finish.h"

#include <array>
#include <future>
#include <utility>

#include "base/files/part_file.h"
#include "base/values/bytes_of.h"
#include "pipeline/background/find_background.h"
#include "pipeline/output/meta.h"
#include "pipeline/prepare/joined_image_sets.h"
#include "pipeline/prepare/photo/moved_photo.h"
#include "pipeline/prepare/pose_refinement_reuse.h"
#include "pipeline/prepare/transient_masks.h"
#include "pipeline/refine/folds.h"
#include "pipeline/run/for_each_photo.h"
#include "scene/agreement/image_set_photos.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {
namespace {

using package::Type;

PoseRefinement find_pose_refinement(const FinishInput& in, const PackageReader& part,
                                    const PhotoTables& photos, const PhotoSamples& samples,
                                    std::span<const std::uint64_t> fingerprints, EffectChoice choice) {
    const Traced traced(in.geometry.trace, "register");
    const auto spans = samples.spans();
    const std::vector<SurfaceDisc> discs = thinned(in.geometry.discs, samples.step);
    std::vector<PoseRefinement> image_sets;
    for (std::uint32_t b = 0; b < in.image_sets.size(); ++b) {
        const auto records = records_of_image_set(photos.records, b);
        const auto shown = samples_of_image_set(spans, photos.records, b);
        const MatchViews views(part, records);
        const PoseRefinementInput input{.package = part,
                                        .views = views,
                                        .photos = records,
                                        .samples = shown,
                                        .discs = discs,
                                        .fingerprints = fingerprints,
                                        .known = in.known_pairs,
                                        .threads = in.threads,
                                        .validate = in.validate,
                                        .progress = in.progress};
        image_sets.push_back(register_photos(input, choice));
    }
    return joined(std::move(image_sets), photos.records, in.image_sets);
}

/// Determines the photos' cameras and rewrites the chunks that depend on the cameras that move.
PoseRefinement register_cameras(const FinishInput& in, const PackageReader& part, const PhotoSamples& samples,
                                PhotoTables& photos) {
    const auto fingerprints = pose_refinement_fingerprints(photos.states, photos.records, in.given,
                                                           in.geometry.renderer.by_opengl());
    const EffectChoice choice = choice_of(in.choices, Effect::pose_refinement);
    const PoseRefinement found =
        in.known ? *in.known : find_pose_refinement(in, part, photos, samples, fingerprints, choice);
    for_each_photo(photos.records.size(), in.threads, [&](std::size_t i) {
        const auto& pose = found.photos[i].pose;
        if (pose) photos.records[i].flags |= package::photo_registered;
        if (pose && !in.known)
            move_photo(in.geometry, part, std::uint32_t(i), *pose, photos.records[i], photos.states[i]);
    });
    write_pose_refinement(in.geometry.writer, found, in.given,
                          pose_refinement_key(fingerprints, choice, in.validate));
    return found;
}

void write_results(const FinishInput& in, Agreement& agreement, PhotoTables& photos) {
    PackageWriter& writer = in.geometry.writer;
    std::vector<EffectDecision> decisions;
    for (const EffectDecision* d : decisions_of(agreement)) decisions.push_back(*d);
    package::SceneRecord scene = in.scene;
    for (const EffectDecision& d : decisions)
        if (d.on) scene.effects |= effect_bit(d.effect);
    std::ranges::copy(agreement.shade, scene.shade);
    std::ranges::copy(agreement.presentation.up, scene.up);
    const FirstView& first = agreement.presentation.first;
    scene.first_photo = first.photo;
    std::ranges::copy(first.target, scene.first_target);
    scene.first_fov = first.fov;
    scene.first_aspect = first.aspect;
    const std::string meta = with_results(in.meta, decisions, agreement.pose_refinement.warnings);
    for (std::size_t i = 0; i < photos.records.size(); ++i) seal(photos.states[i], photos.records[i]);
    writer.write(Type::meta, package::scene_wide, std::as_bytes(std::span(meta)));
    writer.write(Type::scene, package::scene_wide, bytes_of_one(scene));
    write_image_sets(writer, in.image_sets, effects_of_image_sets(decisions, in.image_sets.size()));
    writer.write(Type::photos, package::scene_wide, bytes_of(photos.records));
    writer.write(Type::states, package::scene_wide, bytes_of(photos.states));
    writer.finish();
}

/// The colors of one image set's photos.
struct ImageSetColors {
    std::uint32_t image_set;
    std::vector<std::span<const package::SampleRecord>> samples;
    ColorFit fit;
};

/// Opens the part file again to see its current chunks, because a rewritten compact chunk has a different
/// length.
PackageReader open_part(const FinishInput& in) {
    return PackageReader(part_of(in.out), PackageReader::Expect::part);
}

Background add_background(const FinishInput& in, Samples samples, const ColorRefinement& colors,
                          std::span<const package::PhotoRecord> photos, KindOfScan kind) {
    if (points_only(in.scene))
        return {
            decide(Effect::background, EffectChoice::automatic, 0, "the scene contains only points"), {}, {}};
    const Traced traced(in.geometry.trace, "background");
    const PackageReader part = open_part(in);
    Background found = find_background({.package = part,
                                        .photos = photos,
                                        .samples = samples,
                                        .discs = in.geometry.discs,
                                        .lens = colors.lens,
                                        .colors = colors.fit,
                                        .kind = kind,
                                        .choice = choice_of(in.choices, Effect::background),
                                        .validate = in.validate,
                                        .threads = in.threads});
    if (found.decision.on) in.geometry.writer.append(Type::background, found.chunk);
    return found;
}

/// The colors of each image set's photos.
std::vector<ImageSetColors> fit_image_sets(const FinishInput& in, const PhotoSamples& samples,
                                           std::span<const package::PhotoRecord> photos) {
    const Traced traced(in.geometry.trace, "colors");
    const std::vector<std::uint32_t> lens = lenses_of(photos);
    const bool vignetting = choice_of(in.choices, Effect::vignetting) != EffectChoice::off;
    const auto spans = samples.spans();
    std::vector<ImageSetColors> out;
    for (std::uint32_t b = 0; b < in.image_sets.size(); ++b) {
        out.push_back({b, samples_of_image_set(spans, photos, b), {}});
        out.back().fit = fit_colors(out.back().samples, lens, vignetting);
    }
    return out;
}

/// The results from the photos of one image set, computed once their cameras are known. In `photos`, the
/// photos of other image sets have no pixels.
struct ImageSetAgreement {
    ColorRefinement colors;
    TransientMasks transients;
};
ImageSetAgreement agree(const FinishInput& in, const PackageReader& part, ImageSetColors& of,
                        std::span<const SurfaceDisc> discs, std::vector<std::uint32_t> lens,
                        PhotoTables& photos) {
    ImageSetAgreement out;
    const Folds folds({part, photos.records, of.samples, discs, in.threads});
    {
        const Traced traced(in.geometry.trace, "colors");
        out.colors = refine_colors(std::move(of.fit), std::move(lens), of.samples, in.choices,
                                   in.validate ? &folds : nullptr);
        apply_colors(out.colors, photos.records);
    }
    out.transients = find_transients(in, part, folds, out.colors, photos);
    return out;
}

/// Computes the results of each image set in order.
void agree_by_image_set(const FinishInput& in, const PackageReader& part, std::vector<ImageSetColors> colors,
                        std::span<const SurfaceDisc> discs, PhotoTables& photos, Agreement& out) {
    const std::vector<std::uint32_t> lens = lenses_of(photos.records);
    std::vector<ColorRefinement> refined;
    std::vector<TransientMasks> transients;
    for (ImageSetColors& of : colors) {
        PhotoTables own{records_of_image_set(photos.records, of.image_set), photos.states};
        ImageSetAgreement found = agree(in, part, of, discs, lens, own);
        if (of.image_set == 0) {
            Background around =
                add_background(in, of.samples, found.colors, own.records, out.presentation.kind);
            out.background = std::move(around.decision);
            out.shade = around.shade;
        }
        for (std::size_t i = 0; i < photos.records.size(); ++i)
            if (photos.records[i].image_set == of.image_set) {
                photos.records[i] = own.records[i];
                photos.states[i] = own.states[i];
            }
        refined.push_back(std::move(found.colors));
        transients.push_back(std::move(found.transients));
    }
    out.colors = joined(std::move(refined), photos.records, in.image_sets);
    out.transients = joined(std::move(transients), photos.records, in.image_sets);
}

/// The results for a scene without photos.
Agreement no_agreement() {
    Agreement out;
    std::size_t next = 0;
    for (const EffectRow& row : effect_table())
        if (from_all_photos(row))
            *decisions_of(out).at(next++) =
                decide(row.effect, EffectChoice::automatic, 0, "the scene has no photos");
    return out;
}

}  // namespace

std::array<EffectDecision*, 5> decisions_of(Agreement& a) {
    return {&a.colors.exposure, &a.colors.vignetting, &a.pose_refinement.decision, &a.transients.decision,
            &a.background};
}

Agreement finish_package(const FinishInput& in, PhotoTables& photos) {
    if (photos.records.empty()) {
        Agreement none = no_agreement();
        write_pose_refinement(in.geometry.writer, none.pose_refinement, in.given, 0);
        write_results(in, none, photos);
        return none;
    }
    const auto read = [&](std::uint32_t photo) { return in.geometry.writer.read(Type::samples, photo); };
    PhotoSamples samples = read_samples(photos.records, read);
    // A copy, because the records' poses change in the meantime.
    const std::vector<package::PhotoRecord> given = photos.records;
    Agreement out;
    // Colors are fitted while cameras are being registered, because cameras seldom move.
    std::future<std::vector<ImageSetColors>> fitting =
        std::async(std::launch::async, [&] { return fit_image_sets(in, samples, given); });
    out.pose_refinement = register_cameras(in, open_part(in), samples, photos);
    const PackageReader part = open_part(in);
    std::vector<ImageSetColors> colors = fitting.get();
    if (out.pose_refinement.decision.on && !in.known) {
        samples = read_samples(photos.records, read);
        colors = fit_image_sets(in, samples, given);
    }
    const std::vector<SurfaceDisc> discs = thinned(in.geometry.discs, samples.step);
    out.presentation = presentation_of(photos.records, samples.spans(), discs);
    agree_by_image_set(in, part, std::move(colors), discs, photos, out);
    write_results(in, out, photos);
    return out;
}

}  // namespace vantage
