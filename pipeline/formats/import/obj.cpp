#include "pipeline/formats/import/obj.h"

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/formats/import/color_bytes.h"
#include "pipeline/formats/import/number.h"
#include "pipeline/formats/import/ply.h"
#include "pipeline/formats/import/tokens.h"

namespace vantage {
namespace {

using Words = std::vector<std::string_view>;

class ObjReader {
  public:
    explicit ObjReader(const std::filesystem::path& file) : in_(file) {}

    Mesh read() {
        for (Words words; next_line(words);) {
            if (words.empty()) continue;  // only a comment
            if (words[0] == "v")
                add_vertex(words);
            else if (words[0] == "vn")
                normals_.push_back(point(words).cast<float>());
            else if (words[0] == "f")
                add_face(words);
        }
        if (colored_) mesh_.colors = color_bytes(colors_, true);
        return std::move(mesh_);
    }

  private:
    /// The words of a line and of those it continues on; views of the file's text.
    bool next_line(Words& words) {
        words.clear();
        if (in_.at_end()) return false;
        while (!in_.at_line_end()) {
            const std::string_view found = in_.word("a word");
            std::string_view word = found.substr(0, found.find('#'));
            if (word.size() < found.size()) in_.skip_to_line_end();
            const bool continues = found.ends_with('\\') && in_.at_line_end();
            if (continues) word.remove_suffix(1), in_.next_line();
            if (!word.empty()) words.push_back(word);
        }
        return true;
    }
    [[noreturn]] void fail(const std::string& expected, std::string_view found) const {
        in_.fail(expected, "'" + std::string(found.substr(0, 40)) + "'");
    }
    double real(std::string_view word) const {
        double value = 0;
        if (!parse_number(word, value)) fail("a number", word);
        return value;
    }
    Eigen::Vector3d point(const Words& words) const {
        if (words.size() < 4) fail("three coordinates", words[0]);
        return {real(words[1]), real(words[2]), real(words[3])};
    }
    void add_vertex(const Words& words) {
        mesh_.positions.push_back(point(words));
        const bool colored = words.size() >= 7;  // a fourth number alone is a weight
        colored_ |= colored;
        for (std::size_t c = 0; c < 3; ++c) colors_[c].push_back(colored ? real(words[4 + c]) : 1);
    }
    /// The element that an index of a corner means, counted from 1 or back from the last; `no_vertex`: none.
    std::uint32_t element(std::string_view index, std::size_t count) const {
        std::int64_t i = 0;
        if (!parse_number(index, i)) fail("the index of a corner", index);
        if (i < 0) i += std::int64_t(count) + 1;
        return i >= 1 && std::size_t(i) <= count ? std::uint32_t(i - 1) : no_vertex;
    }
    std::uint32_t corner(std::string_view word) {
        const std::uint32_t v = element(word.substr(0, word.find('/')), mesh_.positions.size());
        const std::size_t normal =
            word.find('/') == word.npos ? word.npos : word.find('/', word.find('/') + 1);
        if (v == no_vertex || normal == word.npos || normal + 1 == word.size()) return v;
        const std::uint32_t n = element(word.substr(normal + 1), normals_.size());
        if (n == no_vertex) return v;
        mesh_.normals.resize(mesh_.positions.size(), Eigen::Vector3f::Zero());
        mesh_.normals[v] += normals_[n];
        return v;
    }
    void add_face(const Words& words) {
        std::vector<std::uint32_t> corners;
        for (std::size_t i = 1; i < words.size(); ++i) corners.push_back(corner(words[i]));
        for (std::size_t i = 2; i < corners.size(); ++i)
            mesh_.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }

    Tokens in_;
    Mesh mesh_;
    std::vector<Eigen::Vector3f> normals_;
    std::array<std::vector<double>, 4> colors_;
    bool colored_ = false;
};

}  // namespace

Mesh read_obj(const std::filesystem::path& file) { return ObjReader(file).read(); }

}  // namespace vantage
