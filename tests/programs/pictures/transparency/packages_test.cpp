// Tests packages with and without transparent surfaces.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "base/gl/context.h"
#include "pipeline/prepare/merge_packages.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/prepare/refine_package.h"
#include "pipeline/reports/check.h"
#include "tests/fuzz/support/valid_package.h"
#include "tests/programs/pictures/transparency/transparent_scene.h"

using namespace vantage;

TEST_F(Transparent, NothingOfItIsThereWithoutAlpha) {
    const gl::HeadlessContext context;
    struct Shown {
        std::vector<std::uint8_t> rgba;
        std::uint64_t memory;
        bool symbol, buffer;
        bool operator==(const Shown&) const = default;
    };
    const auto shown = [&](const PackageReader& package) {
        Renderer renderer(package, MemoryBudget{.graphics = std::uint64_t(200) << 20});
        Shown out{taken(renderer, view_of_photo(package.photos()[0], 0.5), {}).rgba, gl::memory_held(), false,
                  false};
        for (GLuint id = 1; id < 2000; ++id) {
            if (glIsProgram(id))
                out.symbol |=
                    glGetUniformLocation(id, "transparent_sums") >= 0 ||
                    glGetUniformLocation(id, "shows_transparent") >= 0 ||
                    glGetUniformLocation(id, "nearness") >= 0 ||
                    glGetProgramResourceIndex(id, GL_SHADER_STORAGE_BLOCK, "Fragments") != GL_INVALID_INDEX;
            char label[64] = "";
            if (glIsBuffer(id)) glGetObjectLabel(GL_BUFFER, id, sizeof label, nullptr, label);
            out.buffer |= std::string(label).starts_with("fragment");
        }
        return out;
    };
    settings.effects[Effect::transparency] = EffectChoice::on;
    const PackageReader forced = prepared("forced");
    EXPECT_FALSE(effect_on(forced.scene(), Effect::transparency)) << "nothing to show";
    settings.effects.erase(Effect::transparency);
    const PackageReader none = prepared("none");
    EXPECT_EQ(none.meta().find("transparency"), std::string_view::npos)
        << "the package should not mention transparency";
    const Shown bare = shown(none);
    EXPECT_FALSE(bare.symbol || bare.buffer);
    EXPECT_EQ(shown(forced), bare);
    input.mesh.colors.assign(input.mesh.positions.size(), {255, 255, 255, 255});
    const PackageReader opaque = prepared("opaque");
    EXPECT_FALSE(effect_on(opaque.scene(), Effect::transparency));
    EXPECT_EQ(slurp(opaque.path()).find("transparency"), std::string::npos);
    input.mesh.colors[input.mesh.triangles[10][0]][3] = 254;
    settings.effects[Effect::transparency] = EffectChoice::off;
    const PackageReader off = prepared("off");
    EXPECT_FALSE(effect_on(off.scene(), Effect::transparency));
    EXPECT_EQ(shown(off), shown(opaque)) << "the mesh should be shown as if it had no alpha";
    settings.effects.erase(Effect::transparency);
    const PackageReader on = prepared("on");
    EXPECT_TRUE(effect_on(on.scene(), Effect::transparency));
    const Shown with = shown(on);
    EXPECT_TRUE(with.symbol && with.buffer);
    EXPECT_GT(with.memory, bare.memory);
    for (std::size_t v = 0; v < input.mesh.colors.size(); ++v) input.mesh.colors[v][3] = 0;
    EXPECT_FALSE(effect_on(prepared("unset").scene(), Effect::transparency))
        << "an alpha of 0 everywhere means that alpha was never set";
}

TEST_F(Transparent, SurvivesSharesAndRefining) {
    add_quad({-2, -6, 0}, {4, 0, 0}, {0, 0, 4}, {200, 100, 50, 128});
    settings.validate = true;
    const PackageReader whole = prepared();
    for (const std::uint32_t share : {1u, 2u}) {
        PrepareRun run;
        run.share = {share, 2};
        prepare(
            input, settings, dir / (std::to_string(share) + ".share"), [](const Progress&) {}, run);
    }
    merge({dir / "1.share", dir / "2.share"}, dir / "merged.vantage", [](const Progress&) {});
    EXPECT_TRUE(slurp(dir / "merged.vantage") == slurp(whole.path()));
    refine_package(dir / "merged.vantage", {}, dir / "refined.vantage", [](const Progress&) {});
    EXPECT_TRUE(check_package(dir / "refined.vantage", {.deep = true}).empty());
    EXPECT_TRUE(effect_on(PackageReader(dir / "refined.vantage").scene(), Effect::transparency));
}

TEST_F(Transparent, HasNoPartInScores) {
    const auto scores = [&](const std::string& name) {
        prepared(name);
        const std::string file = (dir / name).string();
        const std::string command = std::string(VANTAGE_PLAYER) + " evaluate " + file +
                                    ".vantage --level 2 --photo 0001 -o " + file + "-scores >" + file +
                                    ".txt 2>&1";
        EXPECT_EQ(std::system(command.c_str()), 0) << slurp(file + ".txt");
        return slurp(file + "-scores/photos.csv");
    };
    input.mesh.colors.assign(input.mesh.positions.size(), {255, 255, 255, 255});
    const std::string without = scores("without");
    EXPECT_FALSE(without.empty());
    add_quad({-2, -5, 0.5}, {4, 0, 0}, {0, 0, 4}, {200, 100, 50, 128});
    EXPECT_EQ(scores("with"), without);
}

TEST_F(Transparent, DamagedAlphaIsReported) {
    add_quad({-2, -5, 0.5}, {4, 0, 0}, {0, 0, 4}, {200, 100, 50, 128});
    std::vector<std::uint8_t> bytes;
    std::uint64_t colors = 0;
    settings.effects[Effect::compact] = EffectChoice::off;  // so that alpha can be changed in the file
    {
        const PackageReader package = prepared();
        colors = package.find(package::Type::colors)->offset;
        const std::string text = slurp(package.path());
        bytes.assign(text.begin(), text.end());
    }
    const auto issues = [&](std::uint64_t vertex, std::uint8_t alpha) {
        std::vector<std::uint8_t> changed = bytes;
        changed[colors + 4 * vertex + 3] = alpha;
        fuzz::fix_checksums(changed);
        std::ofstream(dir / "changed.vantage", std::ios::binary)
            .write(reinterpret_cast<const char*>(changed.data()), std::streamsize(changed.size()));
        return check_package(dir / "changed.vantage", {});
    };
    EXPECT_TRUE(issues(0, 255).empty());
    const auto mixed = issues(0, 254);
    ASSERT_FALSE(mixed.empty());
    EXPECT_NE(mixed[0].text.find("CLUS: triangle"), std::string::npos) << mixed[0].text;
    EXPECT_THROW(make_plan_scene(PackageReader(dir / "changed.vantage")), Error);
}
