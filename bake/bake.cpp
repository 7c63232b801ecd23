#include "bake/bake.h"

#include <map>

#include "bake/layer_stages.h"
#include "bake/stages.h"

namespace texbake {
namespace {

using Run = void (*)(Bundle&, const BakeRequest&, Listener&);

/// How each stage of the chain is run. The order is that of the table of stages.
Run run_of(const std::string& verb) {
  static const std::map<std::string, Run> runs = {
      {"convert", [](Bundle& b, const BakeRequest& r, Listener& l) { b = run_convert(r.convert, l); }},
      {"decompose", [](Bundle& b, const BakeRequest& r, Listener& l) { run_decompose(b, r.decompose, "", l); }},
      {"estimate-psd", [](Bundle& b, const BakeRequest& r, Listener& l) { run_estimate_psd(b, r.estimate_psd, l); }},
      {"fragment", [](Bundle& b, const BakeRequest& r, Listener& l) { run_fragment(b, r.fragment, l); }},
      {"patch", [](Bundle& b, const BakeRequest& r, Listener& l) { run_patch(b, r.patch, l); }},
      {"select-contents",
       [](Bundle& b, const BakeRequest& r, Listener& l) { run_select_contents(b, r.select_contents, l); }},
  };
  return runs.at(verb);
}

}  // namespace

Bundle bake(const BakeRequest& request, Listener& listener) {
  check_request(request);
  Bundle bundle;
  for (const StageRow* row : stages_for(request.layers)) run_of(row->verb)(bundle, request, listener);
  return bundle;
}

}  // namespace texbake
