#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace vantage {

/// A setting of `vantage prepare` or `vantage-player` with one value to be measured.
struct CostTrial {
    std::string setting, value;        ///< "--max-photo-size", "1416"; empty: the defaults
    std::string usual;                 ///< the default value, for tables
    std::string note;                  ///< purpose or content of the value, for tables; may be empty
    std::vector<std::string> prepare;  ///< options of `vantage prepare`; none: the default package
    std::vector<std::string> show;     ///< options of `vantage-player`
    bool frames = true;                ///< whether frame times may differ from the default's
    bool whole_frame = false;  ///< compare whole frames, including the background, and not only the model
    bool operator==(const CostTrial&) const = default;
};

/// Measured costs and quality of a trial. Values are empty if they were not measured or are those of the
/// defaults.
struct TrialCosts {
    CostTrial trial;
    std::vector<double> prepare_seconds;  ///< wall-clock time of each run, with photos held out
    std::vector<double> frame_ms;  ///< the median of the opening view's frames at 1280x720, of each run
    /// The same times of the defaults, each measured directly before this trial's; empty for the defaults
    /// themselves.
    std::vector<double> default_seconds, default_ms;
    std::optional<double> memory_bytes;  ///< peak memory of `vantage prepare`
    std::optional<double> package_bytes;
    /// One value per held-out photo, in dB after the best gain per channel. For the defaults, it is the PSNR.
    /// For other trials, it is the difference from that PSNR, on the pixels that both pictures color.
    std::vector<double> psnr;
    std::vector<double> ssim;  ///< the same for the SSIM of luminance
};

/// A recommendation for a purpose, with its measured costs.
struct Recipe {
    std::string purpose;  ///< "a laptop without a graphics card"
    std::string reason;   ///< rule by which the settings were chosen
    std::vector<std::string> commands;
    TrialCosts costs;
};

/// The measurements on one scan or package.
struct ScanCosts {
    std::string name, key;  ///< key: see costs_key()
    std::string input;      ///< the scan or package, as given
    std::size_t photos = 0, triangles = 0;
    int width = 0, height = 0;  ///< of the largest photo, px
    int picture = 0;            ///< longer side of the compared pictures, px
    double photo_bytes = 0;     ///< total size of the photo files; 0: unknown
    /// Names of the photos that are compared, in groups that are held out together.
    std::vector<std::vector<std::string>> held_out;
    bool excluded = false;  ///< there was no scan to prepare, so photos were only excluded from blending
    bool complete = false;  ///< every trial has been measured
    std::optional<double> whole_seconds, whole_bytes;  ///< for all photos, prepared with the defaults
    std::vector<TrialCosts> trials;                    ///< the first is that of the defaults
    std::vector<Recipe> recipes;
};

/// The measurements on one machine.
struct Costs {
    std::string version;  ///< of Vantage
    std::string date;     ///< ISO 8601
    std::string processor, renderer;
    unsigned cores = 0;
    std::vector<ScanCosts> scans;
};

nlohmann::json to_json(const Costs& costs);
/// Throws nlohmann::json::exception.
Costs costs_of(const nlohmann::json& json);

}  // namespace vantage
