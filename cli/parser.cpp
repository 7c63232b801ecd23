#include "cli/parser.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <set>

#include "libbake/base/suggestion.h"

namespace texbake {
namespace {

using Words = std::span<const std::string>;

[[noreturn]] void refuse(const std::string& text) { throw Error(ErrorKind::usage, text); }

/// The name by which CLI11 knows an argument.
std::string name_of(const Argument& argument) {
  return argument.form == Form::positional ? argument.name : "--" + argument.name;
}

CLI::MultiOptionPolicy policy_of(Repeat repeat) {
  switch (repeat) {
    case Repeat::last:
      return CLI::MultiOptionPolicy::TakeLast;
    case Repeat::each:
      return CLI::MultiOptionPolicy::TakeAll;
    case Repeat::never:
      break;
  }
  return CLI::MultiOptionPolicy::Throw;
}

/// Finds the words that belong to each of some arguments. CLI11 does this work; it does not read the values.
class WordFinder {
 public:
  /// `help` is the command that a person who made a mistake is sent to.
  explicit WordFinder(std::string help) : help_(std::move(help)) {
    app_.set_help_flag();
    app_.allow_extras();
  }

  void declare(const Arguments& arguments);
  /// From the first word on that is no option and belongs to none, all are left over.
  void stop_at_word() { app_.prefix_command(); }
  /// Throws Error(usage) for words that do not fit, unless --help is among them.
  void find(Words words);

  bool has(const std::string& name) const;
  std::vector<std::string> left_over() const { return app_.remaining(); }
  /// Throws Error(usage) when anything is left over.
  void check_left_over() const;
  /// Throws Error(usage) for an argument here and one here or in `before` that exclude each other.
  void check_excluded(const WordFinder& before) const;
  void assign() const;

 private:
  /// `words` with "-o=FILE" as "-o" "FILE": CLI11 takes the sign for a part of the value.
  std::vector<std::string> unjoined(Words words) const;

  std::string help_;
  CLI::App app_;
  std::vector<const Argument*> arguments_;
  std::set<std::string> flags_;  ///< those that were given, but not as --json=false
};

void WordFinder::declare(const Arguments& arguments) {
  for (const Argument& argument : arguments.list()) {
    const std::string names = (argument.letter ? fmt::format("-{},", argument.letter) : "") + name_of(argument) +
                              (argument.alias.empty() ? "" : ",--" + argument.alias);
    const bool is_flag = argument.form == Form::flag;
    CLI::Option* option = is_flag ? app_.add_flag(names) : app_.add_option(names);
    option->multi_option_policy(policy_of(argument.repeat))->required(argument.required);
    if (!is_flag) option->type_name(argument.value);
    if (argument.form == Form::positional && argument.repeat == Repeat::each)
      option->expected(1, CLI::detail::expected_max_vector_size)->allow_extra_args();
    arguments_.push_back(&argument);
  }
}

std::vector<std::string> WordFinder::unjoined(Words words) const {
  std::vector<std::string> out;
  bool has_ended = false;  // "--": all that follows is no option
  for (const std::string& word : words) {
    const bool is_joined = !has_ended && word.size() > 2 && word[0] == '-' && word[1] != '-' && word[2] == '=' &&
                           std::ranges::any_of(arguments_, [&](const Argument* argument) {
                             return argument->form == Form::option && argument->letter == word[1];
                           });
    out.push_back(is_joined ? word.substr(0, 2) : word);
    if (is_joined) out.push_back(word.substr(3));
    has_ended = has_ended || word == "--";
  }
  return out;
}

void WordFinder::find(Words words) {
  try {
    std::vector<std::string> separate = unjoined(words);
    std::ranges::reverse(separate);
    app_.parse(std::move(separate));
    for (const Argument* argument : arguments_)
      if (argument->form == Form::flag && has(argument->name) && app_["--" + argument->name]->as<bool>())
        flags_.insert(argument->name);
  } catch (const CLI::ParseError& error) {
    if (has("help")) return;
    check_left_over();
    refuse(error.what() + help_);
  }
}

bool WordFinder::has(const std::string& name) const {
  const CLI::Option* option = app_.get_option_no_throw("--" + name);
  return option && option->count() > 0;
}

void WordFinder::check_left_over() const {
  std::vector<std::string> known;
  for (const Argument* argument : arguments_)
    if (argument->form != Form::positional) known.push_back(name_of(*argument));
  for (const std::string& word : left_over()) {
    if (!word.starts_with("-")) refuse(fmt::format("unexpected argument \"{}\"{}", word, help_));
    const std::string name = word.substr(0, word.find('='));
    const std::string near = suggestion(name, known);
    refuse(fmt::format("unknown option \"{}\"{}", name, near.empty() ? help_ : near));
  }
}

void WordFinder::check_excluded(const WordFinder& before) const {
  for (const Argument* argument : arguments_) {
    const std::string &name = argument->name, &other = argument->excludes;
    if (!other.empty() && (has(name) || before.has(name)) && (has(other) || before.has(other)))
      refuse(fmt::format("--{} cannot be combined with --{}{}", name, other, help_));
  }
}

void assign_value(const Argument& argument, const std::string& word) {
  if (word.empty() && argument.names != Names::nothing)
    refuse(fmt::format("{}: expected the name of a {}, found an empty one", name_of(argument),
                       argument.names == Names::file ? "file" : "folder"));
  argument.assign(word);
}

void WordFinder::assign() const {
  for (const Argument* argument : arguments_) {
    const CLI::Option& option = *app_.get_option(name_of(*argument));
    if (option.count() == 0 || !argument->assign) continue;
    if (argument->form != Form::flag)
      for (const std::string& word : option.reduced_results()) assign_value(*argument, word);
    else if (flags_.contains(argument->name))
      argument->assign("");
  }
}

std::string see(const std::string& command) { return fmt::format("; see {} --help", command); }

const Verb& verb_named(const CommandLine& line, const std::string& word) {
  if (const Verb* verb = line.find(word)) return *verb;
  const std::string near = suggestion(word, line.verb_names());
  refuse(fmt::format("unknown verb \"{}\"{} texbake --help lists the verbs", word, near.empty() ? ";" : near));
}

/// texbake help [VERB]
Asked help_of(const CommandLine& line, Words words) {
  if (words.size() > 1) refuse(fmt::format("unexpected argument \"{}\"{}", words[1], see("texbake")));
  return {Asked::For::help, words.empty() ? nullptr : &verb_named(line, words[0])};
}

}  // namespace

Asked parse(const CommandLine& line, Words words) {
  WordFinder before_verb(see("texbake"));
  before_verb.declare(line.program());
  before_verb.declare(line.common());
  before_verb.stop_at_word();
  before_verb.find(words);
  if (before_verb.has("version")) return {Asked::For::version};
  const std::vector<std::string> rest = before_verb.left_over();
  if (rest.empty() && before_verb.has("help")) return {Asked::For::help};
  if (rest.empty()) refuse("expected a verb; texbake --help lists them");
  if (rest[0].starts_with("-")) before_verb.check_left_over();
  const Words after_verb = Words(rest).subspan(1);
  if (rest[0] == "help") return help_of(line, after_verb);

  const Verb& verb = verb_named(line, rest[0]);
  if (before_verb.has("help")) return {Asked::For::help, &verb};
  WordFinder of_verb(see("texbake " + verb.name()));
  of_verb.declare(verb.arguments);
  of_verb.declare(line.common());
  of_verb.find(after_verb);
  if (of_verb.has("help")) return {Asked::For::help, &verb};
  of_verb.check_left_over();
  of_verb.check_excluded(before_verb);
  before_verb.assign();
  of_verb.assign();
  return {Asked::For::run, &verb};
}

void parse(const Arguments& arguments, Words words) {
  WordFinder finder("");
  finder.declare(arguments);
  finder.find(words);
  finder.check_left_over();
  finder.check_excluded(finder);
  finder.assign();
}

}  // namespace texbake
