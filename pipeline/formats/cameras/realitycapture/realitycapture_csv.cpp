#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <string_view>

#include "base/text/error.h"
#include "base/text/lower_extension.h"
#include "base/text/parse_number.h"
#include "pipeline/formats/camera_axes.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/formats/cameras/realitycapture/realitycapture.h"
#include "pipeline/run/read_file.h"

namespace vantage {
namespace {

/// The cells of a line. Quotes are not supported, because no program writes them.
std::vector<std::string_view> cells(std::string_view line) {
    std::vector<std::string_view> out;
    for (;;) {
        const std::size_t end = std::min(line.find(','), line.size());
        std::string_view cell = line.substr(0, end);
        while (!cell.empty() && cell.front() == ' ') cell.remove_prefix(1);
        while (!cell.empty() && (cell.back() == ' ' || cell.back() == '\r')) cell.remove_suffix(1);
        out.push_back(cell);
        if (end == line.size()) return out;
        line.remove_prefix(end + 1);
    }
}

/// A table with user-selected columns.
class Table {
  public:
    explicit Table(std::filesystem::path file) : file_(std::move(file)), text_(read_plain_text(file_)) {
        rest_ = text_;
        while (next_line())
            if (!line_.starts_with("#cameras")) break;
        if (line_.starts_with('#')) line_.remove_prefix(1);
        const std::vector<std::string_view> names = cells(line_);
        width_ = names.size();
        for (std::size_t i = 0; i < names.size(); ++i) columns_.emplace(names[i], i);
        if (!has("name")) fail("a column 'name'", "'" + std::string(line_.substr(0, 60)) + "'");
    }
    bool has(std::string_view column) const { return columns_.contains(column); }
    /// Reads the next camera; returns false at the end.
    bool next() {
        if (!next_line()) return false;
        row_ = cells(line_);
        if (row_.size() < width_) fail(std::to_string(width_) + " columns", std::to_string(row_.size()));
        return true;
    }
    std::string name() const { return std::string(row_[columns_.at("name")]); }
    /// The value of the first of these columns that exists. Throws if none does.
    double number(std::initializer_list<const char*> columns) const {
        for (const char* c : columns)
            if (has(c)) return read(c);
        fail(std::string("a column '") + *columns.begin() + "'", "none");
    }
    double number(std::initializer_list<const char*> columns, double otherwise) const {
        return std::ranges::any_of(columns, [&](const char* c) { return has(c); }) ? number(columns)
                                                                                   : otherwise;
    }
    [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
        throw Error(Exit::input, file_.string() + ", line " + std::to_string(at_) + ": expected " + expected +
                                     ", found " + found);
    }

  private:
    /// The next line that is not blank.
    bool next_line() {
        for (line_ = {}; !rest_.empty() && line_.find_first_not_of(" \t\r") == line_.npos; ++at_) {
            const std::size_t end = std::min(rest_.find('\n'), rest_.size());
            line_ = rest_.substr(0, end);
            rest_.remove_prefix(std::min(end + 1, rest_.size()));
        }
        return line_.find_first_not_of(" \t\r") != line_.npos;
    }
    double read(const char* column) const {
        const std::string_view cell = row_[columns_.at(column)];
        double value = 0;
        if (!parse_number(cell, value) || !std::isfinite(value))
            fail(std::string("a number in column '") + column + "'",
                 "'" + std::string(cell.substr(0, 40)) + "'");
        return value;
    }

    std::filesystem::path file_;
    std::string text_;
    std::string_view rest_, line_;
    std::size_t at_ = 0;
    std::size_t width_ = 0;  ///< number of columns, several of which may have the same name
    std::map<std::string_view, std::size_t> columns_;
    std::vector<std::string_view> row_;
};

/// The pose from world to camera, in the columns tx, ty, tz and R00 to R22.
Pose matrix_pose(const Table& table) {
    Pose pose;
    for (int i = 0; i < 9; ++i) {
        const std::string column = "R" + std::to_string(i / 3) + std::to_string(i % 3);
        pose.R(i / 3, i % 3) = table.number({column.c_str()});
    }
    pose.t = {table.number({"tx"}), table.number({"ty"}), table.number({"tz"})};
    return pose;
}

/// The pose from yaw, pitch and roll in degrees: the camera-to-world rotation, with z backward, is Rz(-yaw)
/// Rx(pitch) Ry(roll).
Pose angle_pose(const Table& table) {
    using Turn = Eigen::AngleAxisd;
    const double degree = std::numbers::pi / 180;
    const double yaw = table.number({"yaw", "heading"}), pitch = table.number({"pitch"}),
                 roll = table.number({"roll"});
    const Eigen::Vector3d center(table.number({"x"}), table.number({"y"}), table.number({"alt", "z"}));
    const Eigen::Matrix3d R =
        (Turn(-yaw * degree, Eigen::Vector3d::UnitZ()) * Turn(pitch * degree, Eigen::Vector3d::UnitX()) *
         Turn(roll * degree, Eigen::Vector3d::UnitY()))
            .toRotationMatrix();
    return from_camera_to_world(backward(R), center);
}

Pose pose_of(const Table& table) {
    if (table.has("R00")) return matrix_pose(table);
    if (table.has("yaw") || table.has("heading")) return angle_pose(table);
    if (table.has("omega"))
        table.fail("yaw, pitch and roll, or a rotation matrix",
                   "omega, phi and kappa, whose meaning differs between versions of RealityCapture; XMP "
                   "sidecars can be exported instead");
    table.fail("columns yaw, pitch and roll, or R00 to R22", "none of them");
}

CameraSet::Entry read_row(const Table& table) {
    const bool in_pixels = table.has("f_pix");
    if (!in_pixels && !table.has("f") && !table.has("f_35mm"))
        table.fail("a focal length, column 'f'",
                   "none; exports of internal and external parameters have one");
    CameraSet::Entry entry{table.name(), {}, CameraSet::Unit::longer_side};
    Intrinsics& k = entry.camera.intrinsics;
    if (in_pixels) {
        entry.unit = CameraSet::Unit::pixels_from_corner;
        k.cx = table.number({"px_pix"});
        k.cy = table.number({"py_pix"});
        k.fx = k.fy = table.number({"f_pix"});
    } else {
        const double film = 36;  // mm
        k.cx = table.number({"px", "px_norm"}, 0);
        k.cy = table.number({"py", "py_norm"}, 0);
        k.fx = k.fy = table.number({"f", "f_35mm"}) / film;
    }
    const auto c = [&](const char* name) { return table.number({name}, 0); };
    entry.camera.lens = brown_lens({c("k1"), c("k2"), c("k3"), c("k4")}, c("t2"), c("t1"), 0);
    entry.camera.cam_from_world = pose_of(table);
    return entry;
}

}  // namespace

bool is_realitycapture_csv(const std::filesystem::path& file) {
    if (lower_extension(file) != ".csv") return false;
    try {
        const std::vector<std::byte> begin = read_file(file, 1000);
        const std::string_view text(reinterpret_cast<const char*>(begin.data()), begin.size());
        if (text.starts_with("#cameras")) return true;
        // Tables of other programs also have names and positions.
        const std::vector<std::string_view> columns = cells(text.substr(0, text.find('\n')));
        const auto has_one = [&](std::initializer_list<const char*> names) {
            return std::ranges::find_first_of(columns, names) != columns.end();
        };
        return (columns[0] == "#name" || columns[0] == "name") && has_one({"x", "tx"}) &&
               has_one({"heading", "yaw", "R00", "omega"});
    } catch (const Error&) {
        return false;
    }
}

CameraSet read_realitycapture_csv(const std::filesystem::path& file) {
    CameraSet set{"RealityCapture CSV", {}, {}};
    Table table(file);
    while (table.next()) set.entries.push_back(read_row(table));
    if (set.entries.empty()) throw NoCamera(file.string() + ": expected a camera, found none");
    return set;
}

}  // namespace vantage
