#include "libbake/report/sheet.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <sstream>

namespace texbake {
namespace {

constexpr int kGapPx = 14;
constexpr int kTitlePx = 40;
constexpr int kLabelPx = 44;  // two lines
constexpr int kLinePx = 19;
constexpr double kTitleScale = 0.7;
constexpr double kLabelScale = 0.45;
const V3f kPaper(0.9f);
const V3f kInk(0.02f);

V2i largest_cell(const Sheet& sheet) {
  V2i size(1, 1);
  for (const SheetCell& cell : sheet.cells)
    size = {std::max(size.x, cell.linear.width()), std::max(size.y, cell.linear.height())};
  return size;
}

void paste(ImageView<const V3f> picture, V2i at, ImageView<V3f> sheet) {
  for (int y = 0; y < picture.height(); ++y) std::copy_n(picture.row(y), picture.width(), sheet.row(at.y + y) + at.x);
}

}  // namespace

void draw_text(ImageView<V3f> picture, const std::string& text, V2i at, double scale, V3f color) {
  cv::Mat coverage(picture.height(), picture.width(), CV_8UC1, cv::Scalar(0));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line); at.y += kLinePx)
    cv::putText(coverage, line, {at.x, at.y}, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar(255), 1, cv::LINE_AA);
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const float share = static_cast<float>(coverage.at<uint8_t>(y, x)) / 255.0f;
      picture(x, y) += (color - picture(x, y)) * share;
    }
}

Image<V3f> draw(const Sheet& sheet) {
  const V2i cell = largest_cell(sheet);
  const int count = static_cast<int>(sheet.cells.size());
  const int columns = std::max(std::min(sheet.columns, count), 1);
  const int rows = (count + columns - 1) / columns;
  const V2i pitch = cell + V2i(kGapPx, kGapPx + kLabelPx);
  Image<V3f> picture(columns * pitch.x + kGapPx, rows * pitch.y + kGapPx + kTitlePx, kPaper);
  draw_text(picture, sheet.title, {kGapPx, kTitlePx - 8}, kTitleScale, kInk);
  for (int i = 0; i < count; ++i) {
    const V2i at(kGapPx + i % columns * pitch.x, kTitlePx + kGapPx + i / columns * pitch.y);
    const SheetCell& shown = sheet.cells[static_cast<size_t>(i)];
    paste(shown.linear, at + V2i(0, kLabelPx), picture);
    // A label of its own size, so that each text costs what it covers.
    Image<V3f> label(cell.x, kLabelPx, kPaper);
    draw_text(label, shown.label, {0, kLinePx - 4}, kLabelScale, kInk);
    paste(label, at, picture);
  }
  return picture;
}

}  // namespace texbake
