#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "scene/error.h"
#include "temporary_folder.h"
#include "tests/bench/base64.h"
#include "tests/bench/front.h"
#include "tests/bench/tables.h"

using namespace vantage;
using namespace vantage::bench;

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

Measurement row(std::string setting, std::map<std::string, double> values) {
    return {"border", "hall", "masks at 1/2", std::move(setting), false, false, std::move(values), {}};
}

/// Coarse values, so that many are equal; some lack a metric or are not finite.
std::vector<Measurement> random_rows(unsigned seed, int count) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> value(0, 12), odd(0, 9);
    std::vector<Measurement> out;
    for (int i = 0; i < count; ++i) {
        out.push_back(row(std::to_string(i), {{"photo_ms", value(random)}, {"psnr", value(random)}}));
        const int kind = odd(random);
        if (kind == 0) out.back().values.erase("psnr");
        if (kind == 1) out.back().values.erase("photo_ms");
        if (kind == 2) out.back().values["psnr"] = nan_value;
        if (kind == 3) out.back().values["photo_ms"] = std::numeric_limits<double>::infinity();
    }
    return out;
}

bool complete(const Measurement& m) {
    return m.values.contains("photo_ms") && m.values.contains("psnr") &&
           std::isfinite(m.values.at("photo_ms")) && std::isfinite(m.values.at("psnr"));
}

bool beats(const Measurement& a, const Measurement& b) {
    const double ta = a.values.at("photo_ms"), tb = b.values.at("photo_ms");
    const double qa = a.values.at("psnr"), qb = b.values.at("psnr");
    return ta <= tb && qa >= qb && (ta < tb || qa > qb);
}

TEST(Front, IsWhatComparingAllPairsFinds) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        const std::vector<Measurement> rows = random_rows(seed, int(seed % 60));
        std::vector<std::size_t> expected;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            bool beaten = !complete(rows[i]);
            for (const Measurement& other : rows)
                beaten = beaten || (complete(other) && beats(other, rows[i]));
            if (!beaten) expected.push_back(i);
        }
        std::vector<std::size_t> found = front(rows, "photo_ms", "psnr");
        EXPECT_TRUE(
            std::ranges::is_sorted(found, {}, [&](std::size_t i) { return rows[i].values.at("photo_ms"); }));
        std::ranges::sort(found);
        EXPECT_EQ(found, expected) << "seed " << seed;
    }
}

TEST(Front, BeatenByIsTheDistanceToTheBestThatCostsNoMore) {
    for (unsigned seed = 0; seed < 50; ++seed) {
        const std::vector<Measurement> rows = random_rows(seed, 40);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const double by = beaten_by(rows, i, "photo_ms", "psnr");
            EXPECT_EQ(std::isnan(by), !complete(rows[i]));
            if (!complete(rows[i])) continue;
            double best = rows[i].values.at("psnr");
            for (const Measurement& other : rows)
                if (complete(other) && other.values.at("photo_ms") <= rows[i].values.at("photo_ms"))
                    best = std::max(best, other.values.at("psnr"));
            EXPECT_EQ(by, best - rows[i].values.at("psnr"));
        }
        for (const std::size_t i : front(rows, "photo_ms", "psnr"))
            EXPECT_EQ(beaten_by(rows, i, "photo_ms", "psnr"), 0);
    }
}

TEST(Front, AnUnknownMetricIsAMistake) { EXPECT_THROW(front({}, "photo_ms", "beauty"), std::out_of_range); }

TEST(Base64, EncodesAsTheStandardSays) {
    const char* vectors[][2] = {{"", ""},
                                {"f", "Zg=="},
                                {"fo", "Zm8="},
                                {"foo", "Zm9v"},
                                {"foob", "Zm9vYg=="},
                                {"fooba", "Zm9vYmE="},
                                {"foobar", "Zm9vYmFy"},
                                {"\xff\xfe\xfd", "//79"}};
    for (const auto& [bytes, text] : vectors) EXPECT_EQ(base64(bytes), text);
    EXPECT_EQ(base64(std::string(3, '\0')), "AAAA");
}

class BenchTables : public TemporaryFolder {};

TEST_F(BenchTables, JsonReadsBackAsItWas) {
    bench::Run run{"0.1.0", "short", {"one line", "\"another\""}, {row("jfa^2", {{"psnr", 1.0 / 3}})}};
    run.measurements[0].chosen = true;
    run.measurements[0].values["photo_ms"] = nan_value;
    run.measurements[0].exhibits = {{"a caption", "exhibits/a.jpg"}};
    write_json(dir / "run.json", run);
    const bench::Run back = read_json(dir / "run.json");
    EXPECT_EQ(back.version, run.version);
    EXPECT_EQ(back.effort, run.effort);
    EXPECT_EQ(back.machine, run.machine);
    ASSERT_EQ(back.measurements.size(), 1U);
    EXPECT_EQ(back.measurements[0].setting, "jfa^2");
    EXPECT_TRUE(back.measurements[0].chosen);
    EXPECT_EQ(back.measurements[0].values, (std::map<std::string, double>{{"psnr", 1.0 / 3}}));
    EXPECT_EQ(back.measurements[0].exhibits[0].file, "exhibits/a.jpg");
}

TEST_F(BenchTables, WhatIsNoTableIsNamed) {
    const auto complaint = [&](const char* text) -> std::string {
        std::ofstream(dir / "odd.json") << text;
        try {
            read_json(dir / "odd.json");
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::input);
            return e.what();
        }
        return "";
    };
    for (const char* text :
         {"", "[]", "{\"format\": \"another\"}", "{\"format\": \"vantage-bench 1\"}", "\xff"})
        EXPECT_NE(complaint(text).find("odd.json"), std::string::npos) << text;
    EXPECT_THROW(read_json(dir / "none.json"), Error);
}

TEST_F(BenchTables, CsvHasALineAValue) {
    write_csv(dir / "run.csv", std::vector{row("a, \"b\"", {{"psnr", 34.5}, {"photo_ms", nan_value}})});
    EXPECT_EQ(slurp(dir / "run.csv"),
              "sweep,scene,curve,setting,exact,chosen,metric,unit,value\r\n"
              "border,hall,masks at 1/2,\"a, \"\"b\"\"\",0,0,photo_ms,ms,\r\n"
              "border,hall,masks at 1/2,\"a, \"\"b\"\"\",0,0,psnr,dB,34.5\r\n");
}

}  // namespace
