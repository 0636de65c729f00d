#pragma once
#include <fstream>
#include <iomanip>
#include <sstream>

#include "tests/temporary_folder.h"

namespace vantage {

class Import : public TemporaryFolder {
  protected:
    static std::string numbers(std::initializer_list<double> values) {
        std::ostringstream out;
        out << std::setprecision(17);
        for (const double v : values) out << v << ' ';
        return out.str();
    }
    void put(const char* name, const std::string& text) {
        std::ofstream(dir / name, std::ios::binary) << text;
    }

    static std::string replaced(std::string text, const std::string& what, const std::string& by) {
        return text.replace(text.find(what), what.size(), by);
    }
    template <class T>
    static void append(std::string& s, T v) {
        s.append(reinterpret_cast<const char*>(&v), sizeof v);
    }
    /// Writes one OPENCV camera and one image in COLMAP's binary format.
    void put_binary() {
        std::string c, i;
        append<std::uint64_t>(c, 1), append<std::uint32_t>(c, 7), append<std::int32_t>(c, 4);
        append<std::uint64_t>(c, 640), append<std::uint64_t>(c, 480);
        for (const double v : {500., 510., 320.5, 241., .1, -.02, .001, .002}) append(c, v);
        append<std::uint64_t>(i, 1), append<std::uint32_t>(i, 1);
        for (const double v : {0.9, 0.1, -0.2, 0.3, 1., 2., 3.}) append(i, v);
        append<std::uint32_t>(i, 7);
        i += std::string("a.jpg") + '\0';
        append<std::uint64_t>(i, 1), append(i, 1.), append(i, 2.), append<std::int64_t>(i, -1);
        put("cameras.bin", c), put("images.bin", i);
    }
};

}  // namespace vantage
