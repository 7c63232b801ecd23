#include "cli/arguments.h"

#include <algorithm>
#include <utility>

namespace texbake {

void Arguments::positional(Argument argument) {
  argument.form = Form::positional;
  argument.required = true;
  list_.push_back(std::move(argument));
}

void Arguments::option(Argument argument) {
  argument.form = Form::option;
  list_.push_back(std::move(argument));
}

void Arguments::flag(Argument argument) {
  argument.form = Form::flag;
  argument.repeat = Repeat::last;
  list_.push_back(std::move(argument));
}

std::vector<ArgumentGroup> Arguments::groups() const {
  std::vector<ArgumentGroup> groups;
  for (const Argument& argument : list_) {
    const std::string heading = argument.form == Form::positional ? "Arguments" : argument.group;
    auto group = std::ranges::find(groups, heading, &ArgumentGroup::heading);
    if (group == groups.end()) group = groups.insert(group, {heading, {}});
    group->arguments.push_back(&argument);
  }
  return groups;
}

std::function<void(const std::string&)> into(std::string& text) {
  return [&text](const std::string& given) { text = given; };
}

std::function<void(const std::string&)> into(std::optional<std::string>& text) {
  return [&text](const std::string& given) { text = given; };
}

std::function<void(const std::string&)> into(std::vector<std::string>& list) {
  return [&list](const std::string& given) { list.push_back(given); };
}

std::function<void(const std::string&)> into(bool& given) {
  return [&given](const std::string&) { given = true; };
}

}  // namespace texbake
