#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "io/files/atomic_file.h"
#include "io/pictures/drawing_internal.h"
#include "mesh/base/error.h"

namespace swathplan::internal {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kBoldAbove = 0.7;  // font scale: thin strokes look pale in larger words

}  // namespace

void put_text(cv::Mat& picture, std::string words, cv::Point at, double size,
              const cv::Scalar& colour) {
  std::replace_if(
      words.begin(), words.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  cv::putText(picture, words, at, kFont, size, colour, size > kBoldAbove ? 2 : 1, cv::LINE_AA);
}

int text_width(const std::string& words, double size) {
  int base = 0;
  return cv::getTextSize(words, kFont, size, 1, &base).width;
}

void write_png(const std::filesystem::path& path, const cv::Mat& picture,
               const std::vector<int>& options) {
  std::vector<unsigned char> bytes;
  if (!cv::imencode(".png", picture, bytes, options)) {
    throw InvalidInput(fmt::format("cannot write '{}': no PNG could be made", path.string()));
  }
  write_text_atomically(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace swathplan::internal
