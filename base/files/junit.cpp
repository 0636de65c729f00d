#include "base/files/junit.h"

#include <algorithm>
#include <sstream>

#include "base/files/replace_file.h"
#include "base/text/formatted.h"
#include "base/text/markup.h"

namespace vantage {
namespace {

/// The text, escaped for an XML attribute. XML forbids control characters even when they are escaped.
std::string attribute(const std::string& text) {
    std::string plain, out;
    for (const char c : text) plain += (c >= 0 && c < 32 && c != '\t' && c != '\n') ? '?' : c;
    for (const char c : escaped(plain)) out += c == '\n' ? std::string("&#10;") : std::string(1, c);
    return out;
}

std::string seconds(double s) { return formatted("%.3f", s); }

}  // namespace

void write_junit(const std::filesystem::path& file, const std::string& suite,
                 const std::vector<CheckCase>& cases) {
    std::ostringstream out;
    const auto failures = std::ranges::count_if(cases, [](const CheckCase& c) { return !c.kind.empty(); });
    double total = 0;
    for (const CheckCase& c : cases) total += c.seconds;
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"" << attribute(suite)
        << "\" tests=\"" << cases.size() << "\" failures=\"" << failures
        << "\" errors=\"0\" skipped=\"0\" time=\"" << seconds(total) << "\">\n";
    for (const CheckCase& c : cases) {
        out << "  <testcase classname=\"" << attribute(suite) << "\" name=\"" << attribute(c.name)
            << "\" time=\"" << seconds(c.seconds) << "\"";
        if (c.kind.empty())
            out << "/>\n";
        else
            out << ">\n    <failure type=\"" << attribute(c.kind) << "\" message=\"" << attribute(c.text)
                << "\"/>\n  </testcase>\n";
    }
    out << "</testsuite>\n";
    replace_file(file, out.view());
}

}  // namespace vantage
