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

/// A JSON value that knows its location, so that errors can name it. Reading a value of an unexpected kind
/// throws Error(input): one line with the file, the location, the value found and the value expected.
class LocatedJson {
  public:
    /// The root value of a file. The arguments must outlive this object; unknown keys are added to `unknown`.
    LocatedJson(const std::string& file, const nlohmann::json& value, std::vector<std::string>& unknown)
        : file_(&file), value_(&value), unknown_(&unknown) {}

    [[noreturn]] void fail(const std::string& expected) const;
    /// "notes[2].view: "
    std::string place() const;

    /// Expects an object. Adds keys other than these to the list of unknown keys.
    void expect_object(std::initializer_list<std::string_view> known) const;
    bool has(const char* key) const;
    /// Expects the object to have the key.
    LocatedJson at(const char* key) const;
    /// Expects an array of at most `most` items.
    std::vector<LocatedJson> items(std::size_t most) const;
    /// Expects an object with at most `most` keys.
    std::vector<std::pair<std::string, LocatedJson>> entries(std::size_t most) const;

    bool is_object() const;
    bool is_text() const;
    bool is_true() const;
    bool is_null() const;
    /// Expects a string of at most `most` bytes without control characters; line feeds are permitted if
    /// `lines` is set.
    std::string text(std::size_t most, bool lines = false) const;
    bool boolean() const;  ///< expects true or false
    /// Expects a finite number within the range.
    double number(double low, double high) const;
    /// Expects an array of three numbers whose magnitudes are at most 1e12.
    Eigen::Vector3d vector() const;

  private:
    LocatedJson(const LocatedJson& parent, const nlohmann::json& value, std::string path)
        : file_(parent.file_), value_(&value), unknown_(parent.unknown_), path_(std::move(path)) {}

    const std::string* file_;
    const nlohmann::json* value_;
    std::vector<std::string>* unknown_;
    std::string path_;
};

/// Parses a file's text. Throws Error(input) if the text is not JSON or not UTF-8, if it is nested more than
/// `depth` levels deep, or if a key appears twice in an object.
nlohmann::json parsed_json(const std::string& text, const std::string& file, int depth = 64);

}  // namespace vantage
