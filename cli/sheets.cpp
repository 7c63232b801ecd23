#include "cli/sheets.h"

#include "cli/bundle_path.h"
#include "formats/image_writer.h"

namespace texbake {

void add_sheet_flag(Arguments& arguments, std::string& file) {
  arguments.option({.name = "sheet",
                    .value = "FILE",
                    .names = Names::file,
                    .help = "also write a picture for choosing the options by eye: labeled results of other values",
                    .assign = into(file)});
}

void check_sheet(const std::string& file) {
  if (file.empty()) return;
  check_picture_name(file);
  check_file_target(file);
}

void write_sheet(const std::string& file, const Sheet& sheet) { write_picture(file, draw(sheet), PictureRole::color); }

}  // namespace texbake
