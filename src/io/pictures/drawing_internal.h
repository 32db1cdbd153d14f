#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

namespace swathplan::internal {

// Colours of all maps, in OpenCV's order: blue, green, red.
inline const cv::Scalar kInk(60, 48, 38);            ///< text and lines
inline const cv::Scalar kPaper(255, 255, 255);       ///< around the map
inline const cv::Vec3b kOutsideArea(228, 231, 233);  ///< cells outside the survey area

/// Draws `words` from the point `at`, which is the left end of the base line. `size` is OpenCV's
/// font scale. Large words are drawn bold. Characters other than printable ASCII become '?'.
void put_text(cv::Mat& picture, std::string words, cv::Point at, double size = 0.5,
              const cv::Scalar& colour = kInk);

/// The width in pixels that put_text() needs for `words` of a small size.
[[nodiscard]] int text_width(const std::string& words, double size);

/// Options of write_png() for a small file that takes longer to write.
inline const std::vector<int> kSmallPng{cv::IMWRITE_PNG_COMPRESSION, 9};

/// Writes a picture as PNG. A reader never sees half a file.
/// @throws InvalidInput if the file cannot be written; the message names it.
void write_png(const std::filesystem::path& path, const cv::Mat& picture,
               const std::vector<int>& options = {});

}  // namespace swathplan::internal
