#include "base/cli/notes.h"

#include <sstream>

namespace vantage {
namespace {

void close(Notes& out, std::string& paragraph) {
    if (paragraph.starts_with("Exit code"))
        out.exit_codes = paragraph;
    else if (!paragraph.empty())
        out.paragraphs.push_back(paragraph);
    paragraph.clear();
}

}  // namespace

Notes divided(const std::string& notes) {
    Notes out;
    std::istringstream in(notes);
    std::string paragraph;
    bool in_examples = false;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("  ")) {
            if (in_examples) out.examples.push_back(line.substr(2));
            continue;
        }
        in_examples = line == "Example:" || line == "Examples:";
        if (line.ends_with(':') || line.empty()) {
            close(out, paragraph);
            continue;
        }
        paragraph += (paragraph.empty() ? "" : " ") + line;
        if (line.ends_with('.')) close(out, paragraph);
    }
    close(out, paragraph);
    return out;
}

}  // namespace vantage
