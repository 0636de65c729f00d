#include "pipeline/prepare/finish.h"

#include <array>
#include <future>
#include <utility>

#include "pipeline/agree/folds.h"
#include "pipeline/package/meta.h"
#include "pipeline/prepare/consensus_masks.h"
#include "pipeline/prepare/moved_photo.h"
#include "pipeline/prepare/registration_reuse.h"
#include "pipeline/run/for_each_photo.h"
#include "pipeline/surroundings/find_surroundings.h"
#include "scene/part_file.h"
#include "values/bytes_of.h"

namespace vantage {
namespace {

using package::Type;

Registration find_registration(const FinishInput& in, const PackageReader& part, const PhotoTables& photos,
                               const PhotoSamples& samples, std::span<const std::uint64_t> fingerprints,
                               EffectChoice choice) {
    const Traced traced(in.geometry.trace, "register");
    const auto spans = samples.spans();
    const std::vector<SurfaceDisc> discs = thinned(in.geometry.discs, samples.step);
    const RegistrationInput input{.package = part,
                                  .photos = photos.records,
                                  .samples = spans,
                                  .discs = discs,
                                  .fingerprints = fingerprints,
                                  .known = in.known_pairs,
                                  .border_width = in.geometry.border_width,
                                  .threads = in.threads,
                                  .judge = in.judge,
                                  .progress = in.progress};
    return register_photos(input, choice);
}

/// Determines the photos' cameras and rewrites the chunks that depend on those that move.
Registration register_cameras(const FinishInput& in, const PackageReader& part, const PhotoSamples& samples,
                              PhotoTables& photos) {
    const auto fingerprints =
        registration_fingerprints(photos.states, in.given, in.geometry.renderer.by_opengl());
    const EffectChoice choice = choice_of(in.choices, Effect::registration);
    const Registration found =
        in.known ? *in.known : find_registration(in, part, photos, samples, fingerprints, choice);
    for_each_photo(photos.records.size(), in.threads, [&](std::size_t i) {
        const auto& pose = found.photos[i].pose;
        if (pose) photos.records[i].flags |= package::photo_registered;
        if (pose && !in.known)
            move_photo(in.geometry, part, std::uint32_t(i), *pose, photos.records[i], photos.states[i]);
    });
    write_registration(in.geometry.writer, found, in.given, registration_key(fingerprints, choice, in.judge));
    return found;
}

void write_results(const FinishInput& in, const Agreement& agreement, PhotoTables& photos) {
    PackageWriter& writer = in.geometry.writer;
    const std::array decisions{agreement.registration.decision, agreement.colors.exposure,
                               agreement.colors.falloff, agreement.consensus.decision,
                               agreement.surroundings};
    package::SceneRecord scene = in.scene;
    for (const EffectDecision& d : decisions)
        if (d.on) scene.effects |= effect_bit(d.effect);
    const std::string meta = with_results(in.meta, decisions, agreement.registration.warnings);
    for (std::size_t i = 0; i < photos.records.size(); ++i) seal(photos.states[i], photos.records[i]);
    writer.write(Type::meta, package::scene_wide, std::as_bytes(std::span(meta)));
    writer.write(Type::scene, package::scene_wide, bytes_of_one(scene));
    writer.write(Type::photos, package::scene_wide, bytes_of(photos.records));
    writer.write(Type::states, package::scene_wide, bytes_of(photos.states));
    writer.finish();
}

EffectDecision add_surroundings(const FinishInput& in, const PackageReader& part, const PhotoSamples& samples,
                                const ColorRefinement& colors, const PhotoTables& photos) {
    const Traced traced(in.geometry.trace, "surroundings");
    const auto spans = samples.spans();
    const Surroundings found = find_surroundings({.package = part,
                                                  .photos = photos.records,
                                                  .samples = spans,
                                                  .discs = in.geometry.discs,
                                                  .lens = colors.lens,
                                                  .colors = colors.fit,
                                                  .choice = choice_of(in.choices, Effect::surroundings),
                                                  .judge = in.judge,
                                                  .threads = in.threads});
    if (found.decision.on) in.geometry.writer.append(Type::surroundings, found.chunk);
    return found.decision;
}

}  // namespace

Agreement finish_package(const FinishInput& in, PhotoTables& photos) {
    const auto read = [&](std::uint32_t photo) { return in.geometry.writer.read(Type::samples, photo); };
    const PackageReader part(part_of(in.out), PackageReader::Expect::part);
    PhotoSamples samples = read_samples(photos.records, read);
    const std::vector<std::uint32_t> lens = lenses_of(photos.records);
    const auto fit = [&] {
        const Traced traced(in.geometry.trace, "colors");
        return fit_colors(samples.spans(), lens, choice_of(in.choices, Effect::falloff) != EffectChoice::off);
    };
    Agreement out;
    // In the meantime, because cameras seldom move.
    std::future<ColorFit> fitting = std::async(std::launch::async, fit);
    out.registration = register_cameras(in, part, samples, photos);
    ColorFit colors = fitting.get();
    if (out.registration.decision.on && !in.known) {
        samples = read_samples(photos.records, read);
        colors = fit();
    }
    const auto spans = samples.spans();
    const std::vector<SurfaceDisc> discs = thinned(in.geometry.discs, samples.step);
    const Folds folds({part, photos.records, spans, discs, in.geometry.border_width, in.threads});
    {
        const Traced traced(in.geometry.trace, "colors");
        out.colors = refine_colors(std::move(colors), lens, spans, in.choices, in.judge ? &folds : nullptr);
        apply_colors(out.colors, photos.records);
    }
    out.consensus = find_consensus(in, part, folds, out.colors, photos);
    out.surroundings = add_surroundings(in, part, samples, out.colors, photos);
    write_results(in, out, photos);
    return out;
}

}  // namespace vantage
