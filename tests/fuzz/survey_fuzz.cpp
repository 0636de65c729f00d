// Measurement files. Checks that all errors are of type Error, and that values are finite.
#include <cmath>
#include <cstdlib>
#include <string>

#include "base/text/error.h"
#include "player/survey/survey_file.h"
#include "tests/fuzz/support/fuzz_target.h"
#include "tests/fuzz/support/memory_file.h"

using namespace vantage;

FUZZ_TARGET(survey)(const std::uint8_t* data, std::size_t size) {
    try {
        const Survey survey = survey_from(std::string(fuzz::text_of(data, size)), "fuzz.measurements.json");
        for (const Measurement& m : survey.measurements) {
            const Measured is = evaluate(m, survey.scale, survey.up);
            if ((is.value && !std::isfinite(*is.value)) || (is.uncertainty && !(*is.uncertainty >= 0)))
                std::abort();
            text_of(is);
        }
        survey_from(survey_text(survey), "written.measurements.json");
        survey_csv(survey);
    } catch (const Error&) {
    }
    return 0;
}
