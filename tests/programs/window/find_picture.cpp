// Finds a part of a photo in a screenshot, at any size. Prints the position of the part's center, its scale
// relative to the photo, and its similarity (correlation, at most 1). Usage: find_picture SCREENSHOT PHOTO
// LEFT TOP WIDTH HEIGHT
#include <cstdio>
#include <cstdlib>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

int main(int argc, char** argv) {
    if (argc != 7) return 2;
    const cv::Mat screen = cv::imread(argv[1]), photo = cv::imread(argv[2]);
    const cv::Rect box(std::atoi(argv[3]), std::atoi(argv[4]), std::atoi(argv[5]), std::atoi(argv[6]));
    if (screen.empty() || photo.empty() || (box & cv::Rect({}, photo.size())) != box) return 2;
    double best = -1, scale = 0;
    cv::Point2d middle;
    for (double s = 0.5; s < 16; s *= 1.05) {
        cv::Mat reduced, part, score;
        // Neither picture is enlarged, because that would invent detail.
        cv::resize(screen, reduced, {}, std::min(1.0, 1 / s), std::min(1.0, 1 / s), cv::INTER_AREA);
        cv::resize(photo(box), part, {}, std::min(1.0, s), std::min(1.0, s), cv::INTER_AREA);
        if (reduced.cols < part.cols || reduced.rows < part.rows) break;
        cv::matchTemplate(reduced, part, score, cv::TM_CCOEFF_NORMED);
        double most = 0;
        cv::Point at;
        cv::minMaxLoc(score, nullptr, &most, nullptr, &at);
        if (most <= best) continue;
        best = most;
        scale = s;
        middle = cv::Point2d(at.x + part.cols / 2.0, at.y + part.rows / 2.0) * std::max(1.0, s);
    }
    std::printf("%.0f %.0f %.2f %.2f\n", middle.x, middle.y, scale, best);
}
