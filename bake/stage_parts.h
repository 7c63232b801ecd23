// What every stage asks of its bundle, and how it words its record.
#pragma once

#include <fmt/format.h>

#include <optional>

#include "bake/option_json.h"
#include "formats/bundle.h"
#include "libbake/base/error.h"

namespace texbake {

/// The scale a stage works on. Stages come before the scales are stacked: throws Error(unsupported) for several.
Scale& only_scale(Bundle& bundle);

[[noreturn]] void refuse_missing(const char* what, const char* verb);

/// Throws Error(bad_data), naming the verb to run first, where `part` is not there.
template <class T>
const T& required(const std::optional<T>& part, const char* what, const char* verb) {
  if (!part) refuse_missing(what, verb);
  return *part;
}

template <class Options>
Json parameters_of(const Options& asked, const Options& effective) {
  Json parameters = Json::object();
  add_parameters(parameters, asked, effective);
  return parameters;
}

}  // namespace texbake
