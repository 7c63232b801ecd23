// The three streams that every program begins with, which a caller may have closed, or attached to a full disk.
#pragma once

#include <string_view>

namespace texbake {

/// Puts something that nothing can be read from or written to in the place of each stream that is closed; else the next
/// file that the program opens would take its place, and receive its messages. To be called before anything is opened.
/// From then on a stream without a reader fails to be written, instead of ending the program.
void open_standard_streams();

/// Writes `text` to stderr. What cannot be written is lost: nothing depends on messages.
void write_to_stderr(std::string_view text) noexcept;

/// How the writing of a result ended.
enum class Written {
  whole,
  not_whole,  ///< the disk is full, or the stream closed
  no_reader,  ///< as of "head", which has seen enough
};

/// Writes `text` to stdout and makes sure that it arrived.
Written write_to_stdout(std::string_view text) noexcept;

}  // namespace texbake
