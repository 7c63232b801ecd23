// The options of a stage as JSON: into the provenance of a bundle, and back out of a recipe.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "formats/bundle.h"
#include "formats/json_text.h"
#include "libbake/base/option_text.h"

namespace texbake {

template <class T>
Json json_value(const T& value) {
  if constexpr (IsOptional<T>::value)
    return value ? json_value(*value) : Json();
  else if constexpr (std::is_enum_v<T>)
    return std::string(enum_name(value));
  else if constexpr (std::is_same_v<T, float>)
    return json_number(value);
  else
    return value;
}

/// Every field by its name, in the order of the list; null for an automatic value that is not set. A text that is
/// empty is left out.
template <class Options>
Json json_of(const Options& options) {
  Json json = Json::object();
  Options::fields(options, [&](const auto& value, const Field& field) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>)
      if (value.empty()) return;
    json[field.name] = json_value(value);
  });
  return json;
}

/// The effective parameters of a stage, as its provenance records them: every field, and under "automatic" the names
/// of those that were chosen by the stage. Called for each options struct of the stage.
template <class Options>
void add_parameters(Json& parameters, const Options& asked, const Options& effective) {
  Json automatic = parameters.value("automatic", Json::array());
  parameters.erase("automatic");
  parameters.update(json_of(effective));
  Options::fields(asked, [&](const auto& value, const Field& field) {
    if constexpr (IsOptional<std::decay_t<decltype(value)>>::value)
      if (!value) automatic.push_back(field.name);
  });
  parameters["automatic"] = automatic;
}

/// What was asked for, from what add_parameters recorded: null where the stage chose.
Json asked_parameters(const Json& recorded);

/// The members of a JSON object that no field has taken yet.
class JsonReader {
 public:
  /// `where` names the object in messages: `rock.json: stages.fragment`.
  JsonReader(const Json& object, std::string where);

  template <class Options>
  void read(Options& options) {
    Options::fields(options, [&](auto& value, const Field& field) {
      if (const auto text = take(field.name)) guarded([&] { assign_text(value, field.name, field, *text); });
    });
  }
  /// Throws Error(bad_data) naming the first member that nothing has read, with the nearest known name.
  void finish() const;

 private:
  std::optional<std::string> take(const char* name);
  void guarded(const std::function<void()>& assign) const;

  Json left_;
  std::string where_;
  std::vector<std::string> known_;
};

}  // namespace texbake
