#pragma once
#include <Eigen/Core>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vantage {

/// A value of a JSON file that knows where it is, so that errors name the place. What is read from it must
/// be of the expected kind: everything else throws Error(input), one line with the file, the place, what was
/// found and what was expected.
class LocatedJson {
  public:
    /// The whole of a file. The arguments must outlive it; keys that are not known go to `unknown`.
    LocatedJson(const std::string& file, const nlohmann::json& value, std::vector<std::string>& unknown)
        : file_(&file), value_(&value), unknown_(&unknown) {}

    [[noreturn]] void fail(const std::string& expected) const;
    /// "notes[2].view: "
    std::string place() const;

    /// Expects an object; reports keys other than these.
    void expect_object(std::initializer_list<std::string_view> known) const;
    bool has(const char* key) const;
    /// Expects that the object has the key.
    LocatedJson at(const char* key) const;
    /// Expects an array of at most so many.
    std::vector<LocatedJson> items(std::size_t most) const;
    /// Expects an object of at most so many keys.
    std::vector<std::pair<std::string, LocatedJson>> entries(std::size_t most) const;

    bool is_object() const;
    bool is_text() const;
    bool is_true() const;
    bool is_null() const;
    /// At most so many bytes, without control characters other than line feeds if `lines`.
    std::string text(std::size_t most, bool lines = false) const;
    /// Finite, within the range.
    double number(double low, double high) const;
    /// An array of three numbers, none larger than 1e12.
    Eigen::Vector3d vector() const;

  private:
    LocatedJson(const LocatedJson& parent, const nlohmann::json& value, std::string path)
        : file_(parent.file_), value_(&value), unknown_(parent.unknown_), path_(std::move(path)) {}

    const std::string* file_;
    const nlohmann::json* value_;
    std::vector<std::string>* unknown_;
    std::string path_;
};

/// Parses a file's text. Refuses what is no JSON or no UTF-8, is nested deeper than `depth`, or has a key
/// twice in an object. Throws Error(input).
nlohmann::json parsed_json(const std::string& text, const std::string& file, int depth = 64);

}  // namespace vantage
