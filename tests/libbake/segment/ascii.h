// Tiles drawn in ASCII: rows separated by spaces, one character for each texel.
#pragma once

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "libbake/base/image.h"

namespace texbake {

/// '0' … '9' are 0 … 9, 'a' … 'z' are 10 … 35.
inline Image<uint32_t> ascii_ids(const std::string& text) {
  std::istringstream words(text);
  std::vector<std::string> rows;
  for (std::string row; words >> row;) rows.push_back(row);
  Image<uint32_t> ids(static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
  for (int y = 0; y < ids.height(); ++y)
    for (int x = 0; x < ids.width(); ++x) {
      const char c = rows[static_cast<size_t>(y)].at(static_cast<size_t>(x));
      ids(x, y) = static_cast<uint32_t>(c <= '9' ? c - '0' : c - 'a' + 10);
    }
  return ids;
}

/// The inverse of ascii_ids, for messages.
inline std::string ascii(const Image<uint32_t>& ids) {
  std::string text;
  for (int y = 0; y < ids.height(); ++y) {
    for (int x = 0; x < ids.width(); ++x) text += "0123456789abcdefghijklmnopqrstuvwxyz"[ids(x, y) % 36];
    text += ' ';
  }
  text.pop_back();
  return text;
}

}  // namespace texbake
