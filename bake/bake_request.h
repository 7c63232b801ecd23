// Everything that decides what bake makes, and its three spellings: flags, recipe, provenance.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bake/convert_stage.h"
#include "formats/stage_table.h"
#include "libbake/content/select_contents.h"
#include "libbake/noise/decompose.h"
#include "libbake/noise/estimate_psd.h"
#include "libbake/segment/patch.h"

namespace texbake {

/// What the exemplar is taken for.
enum class Layers {
  exemplar,         ///< one layer
  structure_noise,  ///< two: contents are exchanged in the structure, the grain is made anew everywhere
};
template <>
struct EnumNames<Layers> {
  static constexpr std::pair<Layers, std::string_view> values[] = {{Layers::exemplar, "exemplar"},
                                                                   {Layers::structure_noise, "structure+noise"}};
};

struct LayerOptions {
  Layers layers = Layers::exemplar;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.layers, Field{.name = "layers",
                             .help = "exemplar: one layer; structure+noise: fine grain is re-synthesized everywhere, "
                                     "and contents are exchanged in the structure beneath it"});
  }
};

/// The stages of StageUse::layers belong to the chain where `layers` says so: in a recipe and in a record they are what
/// says it.
struct BakeRequest {
  ConvertRequest convert;
  LayerOptions layers;
  DecomposeOptions decompose;
  EstimatePsdOptions estimate_psd;
  FragmentOptions fragment;
  PatchOptions patch;
  SelectContentsOptions select_contents;
};

/// Calls `visit(options)` for every options struct of the stage `verb` of the chain.
template <class Request, class Visit>
void for_each_options_of(std::string_view verb, Request& request, const Visit& visit) {
  if (verb == "convert") for_each_options(request.convert, visit);
  if (verb == "decompose") visit(request.decompose);
  if (verb == "estimate-psd") visit(request.estimate_psd);
  if (verb == "fragment") visit(request.fragment);
  if (verb == "patch") visit(request.patch);
  if (verb == "select-contents") visit(request.select_contents);
}

/// The stages that bake runs for `request`, in order.
std::vector<const StageRow*> stages_for(const LayerOptions& layers);

/// Calls `visit(verb, options)` for every options struct of the stages that bake runs for `request`, in order.
template <class Request, class Visit>
void for_each_stage_options(Request& request, const Visit& visit) {
  for (const StageRow* row : stages_for(request.layers))
    for_each_options_of(row->verb, request, [&](auto& options) { visit(row->verb, options); });
}

/// Throws Error(usage) for values out of range and for options that exclude each other.
void check_request(const BakeRequest& request);

/// A recipe: the files, and for each stage what is asked of it, null where the stage chooses (bake/recipe.schema.json).
inline constexpr const char* kRecipeKind = "texbake.recipe";
inline constexpr const char* kRecipeExtension = ".json";

/// True for a path that names a recipe and not a picture.
bool is_recipe(const std::string& path);

/// The recipe that makes a bundle with these sources and stages. Names of files are bytes: with_text makes it JSON that
/// read_recipe understands. Throws Error(bad_data) when they did not come from this chain.
Json recipe_of(const Bundle& bundle);

/// Reads a recipe. Files are found beside it. Throws Error(io), or Error(bad_data) with the place in the recipe.
BakeRequest read_recipe(const std::string& path);

/// True when the bundle at `path` is whole, was made by this version of the program, from files of these contents and
/// with this request. Throws Error(io) when a picture cannot be read.
bool is_up_to_date(const std::string& path, const BakeRequest& request);

}  // namespace texbake
