#include "pipeline/formats/meshes/mtl.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/text/parse_number.h"
#include "pipeline/run/read_file.h"

namespace vantage {
namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::size_t max_listed = 8;  ///< warnings per file

std::string_view trimmed(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

/// Removes the first word of `rest` and returns it.
std::string_view take_word(std::string_view& rest) {
    rest = trimmed(rest);
    const std::string_view word = rest.substr(0, rest.find_first_of(blanks));
    rest = trimmed(rest.substr(word.size()));
    return word;
}

/// A finite number, clamped to [0, 1].
std::optional<double> take_share(std::string_view& rest) {
    double value = 0;
    if (!parse_number(take_word(rest), value) || !std::isfinite(value)) return {};
    return std::clamp(value, 0.0, 1.0);
}

std::uint8_t code(double share) { return std::uint8_t(std::lround(255 * share)); }

class MtlReader {
  public:
    MtlReader(const std::filesystem::path& file, std::vector<std::string>& warnings)
        : file_(file), warnings_(warnings) {}

    std::map<std::string, MaterialColor> read() {
        const std::string text = read_plain_text(file_);
        for (std::string_view rest = text; !rest.empty();) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            ++line_;
            statement(rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        finish();
        return std::move(materials_);
    }

  private:
    /// Adds the material that was read, if any.
    void finish() {
        if (!at_) return;
        const auto [same, is_new] = materials_.try_emplace(name_, *at_);
        if (!is_new && same->second != *at_)
            warn("the material is defined twice, with different values; the last is used", first_line_);
        same->second = *at_;
    }
    void statement(std::string_view line) {
        std::string_view rest = line;
        const std::string_view key = take_word(rest);
        if (key != "newmtl") rest = trimmed(rest.substr(0, rest.find('#')));
        if (key == "newmtl") {
            finish();
            name_.clear();  // words separated by one blank, as in read_obj()
            while (!rest.empty()) name_.append(name_.empty() ? "" : " ").append(take_word(rest));
            at_ = {255, 255, 255, 255};
            first_line_ = line_;
            has_d_ = warned_ = false;
        } else if (at_ && key == "Kd") {
            read_color(rest);
        } else if (at_ && (key == "d" || key == "Tr")) {
            read_alpha(rest, key == "d");
        } else if (at_ && key == "map_d") {
            warn("alpha from a texture (map_d) is not read");
        }
    }
    void read_color(std::string_view rest) {
        std::array<double, 3> color{};
        for (double& c : color) {
            const auto share = take_share(rest);
            if (!share) return warn("expected three numbers after Kd; the color is assumed to be white");
            c = *share;
        }
        for (std::size_t c = 0; c < 3; ++c) (*at_)[c] = code(color[c]);
    }
    void read_alpha(std::string_view rest, bool is_d) {
        if (is_d && rest.starts_with("-halo")) take_word(rest);
        const auto share = take_share(rest);
        if (!share) return warn("expected a number from 0 to 1 as alpha; the value is ignored");
        if (!is_d && has_d_) return;
        has_d_ |= is_d;
        (*at_)[3] = code(is_d ? *share : 1 - *share);
    }
    void warn(const char* what) { warn(what, line_); }
    void warn(const char* what, std::size_t line) {
        if (warned_ || listed_ == max_listed) return;
        warned_ = true;
        ++listed_;
        warnings_.push_back(file_.filename().string() + ", line " + std::to_string(line) + ": " + what);
    }

    std::filesystem::path file_;
    std::vector<std::string>& warnings_;
    std::map<std::string, MaterialColor> materials_;
    std::optional<MaterialColor> at_;  ///< the material being read
    std::string name_;
    bool has_d_ = false, warned_ = false;
    std::size_t line_ = 0, first_line_ = 0, listed_ = 0;
};

/// The name without a trailing comment, which starts with a `#` between blanks; the name "Material #25" has
/// none.
std::string_view bare(std::string_view name) { return trimmed(name.substr(0, name.find(" # "))); }

}  // namespace

std::optional<MaterialColor> material_named(const std::map<std::string, MaterialColor>& materials,
                                            const std::string& name) {
    if (const auto at = materials.find(name); at != materials.end()) return at->second;
    const auto is_meant = [&](const auto& m) { return bare(m.first) == bare(name); };
    const auto first = std::ranges::find_if(materials, is_meant);
    if (std::ranges::count_if(materials, is_meant) != 1) return {};
    return first->second;
}

std::map<std::string, MaterialColor> read_mtl(const std::filesystem::path& file,
                                              std::vector<std::string>& warnings) {
    return MtlReader(file, warnings).read();
}

}  // namespace vantage
