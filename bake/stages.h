// The stages of the chain on a bundle: run one, record it. Single verbs and bake call the same functions, so that they
// write the same bytes.
#pragma once

#include "bake/listener.h"
#include "formats/bundle.h"
#include "libbake/content/select_contents.h"
#include "libbake/segment/patch.h"

namespace texbake {

// Each replaces its result in `bundle`, and drops, with a warning, what had been derived from the old one. Throws Error
// as the stage does, and Error(bad_data) when a stage that must come before has not run; `bundle` is then as it was.
void run_fragment(Bundle& bundle, const FragmentOptions& options, Listener& listener);
void run_patch(Bundle& bundle, const PatchOptions& options, Listener& listener);
void run_select_contents(Bundle& bundle, const SelectContentsOptions& options, Listener& listener);

}  // namespace texbake
