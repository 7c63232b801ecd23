#include "bake/option_json.h"

#include "libbake/base/suggestion.h"

namespace texbake {

Json asked_parameters(const Json& recorded) {
  Json asked = recorded;
  asked.erase("automatic");
  for (const Json& name : recorded.value("automatic", Json::array()))
    if (name.is_string()) asked[name.get<std::string>()] = nullptr;
  return asked;
}

JsonReader::JsonReader(const Json& object, std::string where) : left_(object), where_(std::move(where)) {
  if (!left_.is_object())
    throw Error(ErrorKind::bad_data, fmt::format("{}: expected an object, found {}", where_, left_.type_name()));
}

std::optional<std::string> JsonReader::take(const char* name) {
  known_.emplace_back(name);
  const auto member = left_.find(name);
  if (member == left_.end()) return std::nullopt;
  const Json value = *member;
  left_.erase(member);
  if (value.is_null()) return "auto";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

void JsonReader::guarded(const std::function<void()>& assign) const {
  try {
    assign();
  } catch (const Error& error) {
    throw Error(ErrorKind::bad_data, fmt::format("{}: {}", where_, error.what()));
  }
}

void JsonReader::finish() const {
  if (left_.empty()) return;
  const std::string name = left_.begin().key();
  throw Error(ErrorKind::bad_data, fmt::format("{}: unknown member \"{}\"{}", where_, name, suggestion(name, known_)));
}

}  // namespace texbake
