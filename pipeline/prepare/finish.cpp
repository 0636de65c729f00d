#include "pipeline/prepare/finish.h"

#include <array>
#include <future>
#include <utility>

#include "base/files/part_file.h"
#include "base/values/bytes_of.h"
#include "pipeline/output/meta.h"
#include "pipeline/prepare/consensus_masks.h"
#include "pipeline/prepare/joined_bands.h"
#include "pipeline/prepare/photo/moved_photo.h"
#include "pipeline/prepare/registration_reuse.h"
#include "pipeline/refine/folds.h"
#include "pipeline/run/for_each_photo.h"
#include "pipeline/surroundings/find_surroundings.h"
#include "scene/agreement/band_photos.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {
namespace {

using package::Type;

Registration find_registration(const FinishInput& in, const PackageReader& part, const PhotoTables& photos,
                               const PhotoSamples& samples, std::span<const std::uint64_t> fingerprints,
                               EffectChoice choice) {
    const Traced traced(in.geometry.trace, "register");
    const auto spans = samples.spans();
    const std::vector<SurfaceDisc> discs = thinned(in.geometry.discs, samples.step);
    std::vector<Registration> bands;
    for (std::uint32_t b = 0; b < in.bands.size(); ++b) {
        const auto records = records_of_band(photos.records, b);
        const auto shown = samples_of_band(spans, photos.records, b);
        const MatchViews views(part, records);
        const RegistrationInput input{.package = part,
                                      .views = views,
                                      .photos = records,
                                      .samples = shown,
                                      .discs = discs,
                                      .fingerprints = fingerprints,
                                      .known = in.known_pairs,
                                      .border_width = in.geometry.border_width,
                                      .threads = in.threads,
                                      .judge = in.judge,
                                      .progress = in.progress};
        bands.push_back(register_photos(input, choice));
    }
    return joined(std::move(bands), photos.records, in.bands);
}

/// Determines the photos' cameras and rewrites the chunks that depend on those that move.
Registration register_cameras(const FinishInput& in, const PackageReader& part, const PhotoSamples& samples,
                              PhotoTables& photos) {
    const auto fingerprints =
        registration_fingerprints(photos.states, photos.records, in.given, in.geometry.renderer.by_opengl());
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
    std::ranges::copy(agreement.shade, scene.shade);
    std::ranges::copy(agreement.presentation.up, scene.up);
    const FirstView& first = agreement.presentation.first;
    scene.first_photo = first.photo;
    std::ranges::copy(first.target, scene.first_target);
    scene.first_fov = first.fov;
    scene.first_aspect = first.aspect;
    const std::string meta = with_results(in.meta, decisions, agreement.registration.warnings);
    for (std::size_t i = 0; i < photos.records.size(); ++i) seal(photos.states[i], photos.records[i]);
    writer.write(Type::meta, package::scene_wide, std::as_bytes(std::span(meta)));
    writer.write(Type::scene, package::scene_wide, bytes_of_one(scene));
    write_bands(writer, in.bands, effects_of_bands(agreement, in.bands.size()));
    writer.write(Type::photos, package::scene_wide, bytes_of(photos.records));
    writer.write(Type::states, package::scene_wide, bytes_of(photos.states));
    writer.finish();
}

/// Of one band.
struct BandColors {
    std::uint32_t band;
    std::vector<std::span<const package::SampleRecord>> samples;
    ColorFit fit;
};

/// The photos' chunks as they are now: a compact one that was rewritten has another length.
PackageReader open_part(const FinishInput& in) {
    return PackageReader(part_of(in.out), PackageReader::Expect::part);
}

Surroundings add_surroundings(const FinishInput& in, Samples samples, const ColorRefinement& colors,
                              std::span<const package::PhotoRecord> photos, KindOfScan kind) {
    if (points_only(in.scene))
        return {
            decide(Effect::surroundings, EffectChoice::automatic, 0, "the scene has points only"), {}, {}};
    const Traced traced(in.geometry.trace, "surroundings");
    const PackageReader part = open_part(in);
    Surroundings found = find_surroundings({.package = part,
                                            .photos = photos,
                                            .samples = samples,
                                            .discs = in.geometry.discs,
                                            .lens = colors.lens,
                                            .colors = colors.fit,
                                            .kind = kind,
                                            .choice = choice_of(in.choices, Effect::surroundings),
                                            .judge = in.judge,
                                            .threads = in.threads});
    if (found.decision.on) in.geometry.writer.append(Type::surroundings, found.chunk);
    return found;
}

/// The colors of each band's photos.
std::vector<BandColors> fit_bands(const FinishInput& in, const PhotoSamples& samples,
                                  std::span<const package::PhotoRecord> photos,
                                  std::span<const std::uint32_t> lens) {
    const Traced traced(in.geometry.trace, "colors");
    const bool falloff = choice_of(in.choices, Effect::falloff) != EffectChoice::off;
    const auto spans = samples.spans();
    std::vector<BandColors> out;
    for (std::uint32_t b = 0; b < in.bands.size(); ++b) {
        out.push_back({b, samples_of_band(spans, photos, b), {}});
        out.back().fit = fit_colors(out.back().samples, lens, falloff);
    }
    return out;
}

/// What the photos of one band decide once their cameras are known. Photos of other bands have no pixels in
/// `photos`.
struct BandAgreement {
    ColorRefinement colors;
    Consensus consensus;
    Surroundings surroundings;  ///< of the first band
};
BandAgreement agree(const FinishInput& in, const PackageReader& part, BandColors of,
                    std::span<const SurfaceDisc> discs, std::vector<std::uint32_t> lens, KindOfScan kind,
                    PhotoTables& photos) {
    BandAgreement out;
    const Folds folds({part, photos.records, of.samples, discs, in.geometry.border_width, in.threads});
    {
        const Traced traced(in.geometry.trace, "colors");
        out.colors = refine_colors(std::move(of.fit), std::move(lens), of.samples, in.choices,
                                   in.judge ? &folds : nullptr);
        apply_colors(out.colors, photos.records);
    }
    out.consensus = find_consensus(in, part, folds, out.colors, photos);
    if (of.band == 0) out.surroundings = add_surroundings(in, of.samples, out.colors, photos.records, kind);
    return out;
}

/// What each band's photos decide, one band after the other.
void agree_by_band(const FinishInput& in, const PackageReader& part, std::vector<BandColors> colors,
                   std::span<const SurfaceDisc> discs, std::span<const std::uint32_t> lens,
                   PhotoTables& photos, Agreement& out) {
    std::vector<ColorRefinement> refined;
    std::vector<Consensus> consensus;
    for (BandColors& of : colors) {
        const std::uint32_t band = of.band;
        PhotoTables own{records_of_band(photos.records, band), photos.states};
        BandAgreement found =
            agree(in, part, std::move(of), discs, {lens.begin(), lens.end()}, out.presentation.kind, own);
        for (std::size_t i = 0; i < photos.records.size(); ++i)
            if (photos.records[i].band == band) {
                photos.records[i] = own.records[i];
                photos.states[i] = own.states[i];
            }
        if (band == 0) {
            out.surroundings = std::move(found.surroundings.decision);
            out.shade = found.surroundings.shade;
        }
        refined.push_back(std::move(found.colors));
        consensus.push_back(std::move(found.consensus));
    }
    out.colors = joined(std::move(refined), photos.records, in.bands);
    out.consensus = joined(std::move(consensus), photos.records, in.bands);
}

/// What there is to say about no photos.
Agreement no_agreement() {
    const auto none = [](Effect e) {
        return decide(e, EffectChoice::automatic, 0, "the scene has no photos");
    };
    Agreement out;
    out.registration.decision = none(Effect::registration);
    out.colors.exposure = none(Effect::exposure);
    out.colors.falloff = none(Effect::falloff);
    out.consensus.decision = none(Effect::consensus);
    out.surroundings = none(Effect::surroundings);
    return out;
}

}  // namespace

Agreement finish_package(const FinishInput& in, PhotoTables& photos) {
    if (photos.records.empty()) {
        const Agreement none = no_agreement();
        write_registration(in.geometry.writer, none.registration, in.given, 0);
        write_results(in, none, photos);
        return none;
    }
    const auto read = [&](std::uint32_t photo) { return in.geometry.writer.read(Type::samples, photo); };
    PhotoSamples samples = read_samples(photos.records, read);
    const std::vector<std::uint32_t> lens = lenses_of(photos.records);
    // Not the records themselves, whose poses change in the meantime.
    const std::vector<package::PhotoRecord> given = photos.records;
    Agreement out;
    // In the meantime, because cameras seldom move.
    std::future<std::vector<BandColors>> fitting =
        std::async(std::launch::async, [&] { return fit_bands(in, samples, given, lens); });
    out.registration = register_cameras(in, open_part(in), samples, photos);
    const PackageReader part = open_part(in);
    std::vector<BandColors> colors = fitting.get();
    if (out.registration.decision.on && !in.known) {
        samples = read_samples(photos.records, read);
        colors = fit_bands(in, samples, given, lens);
    }
    const std::vector<SurfaceDisc> discs = thinned(in.geometry.discs, samples.step);
    out.presentation = presentation_of(photos.records, samples.spans(), discs);
    agree_by_band(in, part, std::move(colors), discs, lens, photos, out);
    write_results(in, out, photos);
    return out;
}

}  // namespace vantage
