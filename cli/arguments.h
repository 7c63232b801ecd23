// What a verb takes on its command line, declared once: the parser, --help, the manual pages and the completions of
// shells read it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace texbake {

/// How an argument is written.
enum class Form {
  positional,  ///< BUNDLE
  option,      ///< --size WIDTHxHEIGHT
  flag,        ///< --json
};

/// What it means that an argument is given again.
enum class Repeat {
  never,  ///< a mistake
  last,   ///< the last one counts
  each,   ///< every one counts
};

/// What the words of a value are, for the completions of shells.
enum class Names { nothing, file, folder };

/// One argument, whatever the type of its value.
struct Argument {
  Form form = Form::option;
  std::string name = {};                  ///< without "--"; of a positional as the help shows it: BUNDLE
  std::string alias = {};                 ///< another name of an option, accepted but not shown; "" for none
  char letter = 0;                        ///< the short name; 0 for none
  std::string value = {};                 ///< what an option takes, in words: "1 to 64 colors"
  std::vector<std::string> choices = {};  ///< all words that it takes, where they can be listed
  Names names = Names::nothing;
  std::string standard = {};  ///< the default in words: "auto (how it is chosen)"; "" for none
  std::string help = {};
  std::string group = "Options";  ///< the heading that it stands under
  bool required = false;
  Repeat repeat = Repeat::never;
  std::string excludes = {};  ///< the name of a flag that may not be given beside this one; "" for none
  /// Reads the text of a value, "" of a flag; throws Error(usage). Empty where the parser itself acts.
  std::function<void(const std::string&)> assign = {};
};

/// The arguments that stand under one heading; positionals have one of their own.
struct ArgumentGroup {
  std::string heading;
  std::vector<const Argument*> arguments;
};

/// The arguments of a verb, in the order in which what was given is assigned. What the assign functions fill must
/// outlive the parse.
class Arguments {
 public:
  /// Sets the form of `argument`, and that all positionals are required, and flags may be repeated.
  void positional(Argument argument);
  void option(Argument argument);
  void flag(Argument argument);

  const std::vector<Argument>& list() const { return list_; }
  /// The same by headings, in the order in which these appear first; borrowed.
  std::vector<ArgumentGroup> groups() const;

 private:
  std::vector<Argument> list_;
};

/// Assign functions: the text itself, one more text, or that the flag was given.
std::function<void(const std::string&)> into(std::string& text);
std::function<void(const std::string&)> into(std::optional<std::string>& text);
std::function<void(const std::string&)> into(std::vector<std::string>& list);
std::function<void(const std::string&)> into(bool& given);

}  // namespace texbake
