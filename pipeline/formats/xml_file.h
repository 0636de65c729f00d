#pragma once
#include <filesystem>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace vantage {

/// An XML file. Its functions throw Error(input) naming the line.
class XmlFile {
  public:
    explicit XmlFile(std::filesystem::path file);

    pugi::xml_node child(const char* name) const { return document_.child(name); }
    /// "file, line 12: <element>: expected ..., found ..."
    [[noreturn]] void fail(pugi::xml_node at, const std::string& expected, const std::string& found) const;

    /// The numbers in an element, separated by whitespace; throws unless there are `count` of them.
    std::vector<double> numbers(pugi::xml_node element, std::size_t count) const;
    /// The number in an element's child, or `otherwise` if there is no such child.
    double number(pugi::xml_node element, const char* child, double otherwise) const;
    /// The number in an element's child; throws if there is no such child.
    double number(pugi::xml_node element, const char* child) const;
    /// The number in an attribute, or `otherwise` if there is none.
    double attribute(pugi::xml_node element, const char* name, double otherwise) const;
    /// The number in an attribute; throws if there is none.
    double attribute(pugi::xml_node element, const char* name) const;
    /// The numbers in a string from an element; throws unless there are `count` of them.
    std::vector<double> numbers(pugi::xml_node element, const std::string& text, std::size_t count) const;
    /// The width or height of a photo. Throws unless the number is an integer from 1 to 2^20.
    int size(pugi::xml_node element, double value) const;

  private:
    std::filesystem::path file_;
    std::string text_;
    pugi::xml_document document_;
};

}  // namespace vantage
