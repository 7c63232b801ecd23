// The folder that an export makes: as a whole where it is new, file by file where an earlier export made it.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace texbake {

/// How a folder is told that an earlier export of the same kind made.
struct ExportKind {
  std::string_view marker;                        ///< a file in it
  std::string_view begins;                        ///< how that begins
  std::function<bool(std::string_view)> may_own;  ///< whether a file of this name may be one of the export's
};

/// Calls `write` with the folder to be filled. Throws Error(io) when `target` is a file or holds what no export of
/// this kind made, or cannot be written; then nothing of an earlier export is lost.
void write_export(const std::filesystem::path& target, const ExportKind& kind,
                  const std::function<void(const std::filesystem::path& folder)>& write);

}  // namespace texbake
