// The first stage: from pictures to a new bundle.
#pragma once

#include "bake/material.h"
#include "libbake/color/convert.h"
#include "libbake/tile/flatten.h"
#include "libbake/tile/periodic.h"

namespace texbake {

/// How the color of the bundle is stored.
enum class ColorForm {
  full,     ///< every texel's color, so that nothing is lost
  palette,  ///< the paper's compact form: class and variation alone
};
template <>
struct EnumNames<ColorForm> {
  static constexpr std::pair<ColorForm, std::string_view> values[] = {{ColorForm::full, "full"},
                                                                      {ColorForm::palette, "palette"}};
};

struct StorageOptions {
  ColorForm color = ColorForm::full;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(
        self.color,
        Field{.name = "colour",
              .help = "how colors are stored: full (lossless), or palette (color class and variation only; smaller)"});
  }
};

/// Everything that decides what convert makes.
struct ConvertRequest {
  MaterialFiles files;
  ImportOptions import;
  PeriodicOptions periodic;
  FlattenOptions flatten;
  ConvertOptions convert;
  StorageOptions storage;
};

/// Calls `visit(options)` for every options struct of `request`, in the order of the help text and of the provenance.
template <class Request, class Visit>
void for_each_options(Request& request, const Visit& visit) {
  visit(request.import);
  visit(request.periodic);
  visit(request.flatten);
  visit(request.convert);
  visit(request.storage);
}

/// Reads the pictures and makes a bundle of one scale. Throws Error as read_material and the stages do.
Bundle run_convert(const ConvertRequest& request, Listener& listener);

}  // namespace texbake
