#pragma once
#include <lcms2.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

namespace vantage {

/// An RGB color space: the primaries and the white point as CIE 1931 x and y, and a gamma (0 for the sRGB
/// curve).
struct RgbSpace {
    const char* name;
    std::array<double, 2> red, green, blue, white;
    double gamma;
};
inline constexpr std::array<double, 2> d65{0.3127, 0.3290}, d50{0.3457, 0.3585};
inline constexpr RgbSpace srgb{"sRGB IEC61966-2.1", {0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, d65, 0};
inline constexpr RgbSpace adobe_rgb{"Adobe RGB (1998)", {0.64, 0.33}, {0.21, 0.71},
                                    {0.15, 0.06},       d65,          2.19921875};
inline constexpr RgbSpace display_p3{"Display P3", {0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, d65, 0};
inline constexpr RgbSpace prophoto_rgb{
    "ProPhoto RGB", {0.7347, 0.2653}, {0.1596, 0.8404}, {0.0366, 0.0001}, d50, 1.8};

using Curve = std::unique_ptr<cmsToneCurve, decltype(&cmsFreeToneCurve)>;

inline Curve curve_of(double gamma) {
    const double srgb_curve[] = {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045};
    return {gamma > 0 ? cmsBuildGamma(nullptr, gamma) : cmsBuildParametricToneCurve(nullptr, 4, srgb_curve),
            cmsFreeToneCurve};
}

/// Replaces a profile's description, closes the profile, and returns its bytes.
inline std::string icc_bytes(cmsHPROFILE profile, const char* description) {
    const std::unique_ptr<void, decltype(&cmsCloseProfile)> owned(profile, cmsCloseProfile);
    const std::unique_ptr<cmsMLU, decltype(&cmsMLUfree)> text(cmsMLUalloc(nullptr, 1), cmsMLUfree);
    cmsMLUsetASCII(text.get(), "en", "US", description);
    cmsUInt32Number size = 0;
    if (!cmsWriteTag(profile, cmsSigProfileDescriptionTag, text.get()) ||
        !cmsSaveProfileToMem(profile, nullptr, &size))
        throw std::runtime_error("cannot make a profile");
    std::string bytes(size, '\0');
    cmsSaveProfileToMem(profile, bytes.data(), &size);
    return bytes;
}

/// A matrix/curve profile, made by Little CMS.
inline std::string icc_profile(const RgbSpace& space) {
    const auto xyY = [](const std::array<double, 2>& xy) { return cmsCIExyY{xy[0], xy[1], 1}; };
    const cmsCIExyY white = xyY(space.white);
    const cmsCIExyYTRIPLE primaries{xyY(space.red), xyY(space.green), xyY(space.blue)};
    const Curve curve = curve_of(space.gamma);
    const std::array curves{curve.get(), curve.get(), curve.get()};
    return icc_bytes(cmsCreateRGBProfile(&white, &primaries, curves.data()), space.name);
}

/// A gray profile with this gamma.
inline std::string gray_profile(double gamma) {
    const cmsCIExyY white{d50[0], d50[1], 1};
    return icc_bytes(cmsCreateGrayProfile(&white, curve_of(gamma).get()), "Gray");
}

/// Converts a color in [0, 1] to linear sRGB by the defining equations: converts it to XYZ, adapts it to the
/// other white point (Bradford, as in ICC profiles), and converts it from XYZ.
inline Eigen::Vector3d srgb_light(const RgbSpace& space, const Eigen::Vector3d& color) {
    using Eigen::Matrix3d, Eigen::Vector3d;
    const auto xyz = [](const std::array<double, 2>& xy) {
        return Vector3d(xy[0] / xy[1], 1, (1 - xy[0] - xy[1]) / xy[1]);
    };
    const auto to_xyz = [&](const RgbSpace& s) -> Matrix3d {
        Matrix3d m;
        m << xyz(s.red), xyz(s.green), xyz(s.blue);
        const Vector3d share = m.inverse() * xyz(s.white);
        return m * share.asDiagonal();
    };
    Matrix3d bradford;
    bradford << 0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296;
    const Vector3d gain =
        ((bradford * xyz(srgb.white)).array() / (bradford * xyz(space.white)).array()).matrix();
    const Matrix3d adapt = bradford.inverse() * gain.asDiagonal() * bradford;
    const Vector3d light = color.unaryExpr([&](double v) {
        if (space.gamma > 0) return std::pow(v, space.gamma);
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    });
    return to_xyz(srgb).inverse() * adapt * to_xyz(space) * light;
}

/// The sRGB value of linear light, from 0 to 255, clipped but not rounded.
inline double srgb_value(double light) {
    const double l = std::min(std::max(light, 0.0), 1.0);
    return 255 * (l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055);
}

}  // namespace vantage
