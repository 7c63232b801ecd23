#include "cli/parser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "libbake/base/error.h"

namespace texbake {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Words = std::vector<std::string>;

/// What the words of a small verb were assigned to.
struct Given {
  std::string input, size, name;
  std::vector<std::string> maps;
  bool quick = false, slow = false;
};

Given parsed(const Words& words) {
  Given given;
  Arguments arguments;
  arguments.positional({.name = "INPUT", .assign = into(given.input)});
  arguments.option({.name = "size", .alias = "extent", .letter = 's', .value = "N", .assign = into(given.size)});
  arguments.option({.name = "name", .value = "NAME", .repeat = Repeat::last, .assign = into(given.name)});
  arguments.option({.name = "map", .value = "FILE", .repeat = Repeat::each, .assign = into(given.maps)});
  arguments.flag({.name = "quick", .excludes = "slow", .assign = into(given.quick)});
  arguments.flag({.name = "slow", .assign = into(given.slow)});
  parse(arguments, words);
  return given;
}

/// The message with which the words are refused.
std::string usage_error(const Words& words) {
  try {
    parsed(words);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    return error.what();
  }
  return "";
}

TEST(Parser, ValuesComeAsAWordOfTheirOwnOrBehindASign) {
  EXPECT_EQ(parsed({"a.png", "--size", "4"}).size, "4");
  EXPECT_EQ(parsed({"a.png", "--size=4"}).size, "4");
  EXPECT_EQ(parsed({"--size", "4", "a.png"}).input, "a.png");
  EXPECT_EQ(parsed({"a.png", "-s", "4"}).size, "4");
  EXPECT_EQ(parsed({"a.png", "--extent", "4"}).size, "4");
}

TEST(Parser, ANegativeNumberIsAValue) { EXPECT_EQ(parsed({"a.png", "--size", "-4,5"}).size, "-4,5"); }

TEST(Parser, AnArgumentThatIsGivenAgain) {
  EXPECT_EQ(parsed({"a.png", "--name", "one", "--name", "two"}).name, "two");
  EXPECT_THAT(parsed({"a.png", "--map", "n=1", "--map", "h=2"}).maps, ElementsAre("n=1", "h=2"));
  EXPECT_TRUE(parsed({"a.png", "--quick", "--quick"}).quick);
  EXPECT_THAT(usage_error({"a.png", "--size", "4", "--size", "5"}), HasSubstr("size"));
}

TEST(Parser, WhatDoesNotFitIsRefused) {
  EXPECT_THAT(usage_error({}), HasSubstr("INPUT"));
  EXPECT_THAT(usage_error({"a.png", "b.png"}), HasSubstr("unexpected argument \"b.png\""));
  EXPECT_THAT(usage_error({"a.png", "--sise", "4"}), AllOf(HasSubstr("\"--sise\""), HasSubstr("--size")));
  EXPECT_THAT(usage_error({"a.png", "--quick", "--slow"}), HasSubstr("--quick cannot be combined with --slow"));
  EXPECT_NE(usage_error({"a.png", "--size"}), "");
}

TEST(Parser, VerbsHelpAndVersion) {
  const CommandLine line;
  const auto asked = [&](const Words& words) { return parse(line, words); };
  EXPECT_EQ(asked({"--version"}).what, Asked::For::version);
  EXPECT_EQ(asked({"--help"}).verb, nullptr);
  for (const Words& words : {Words{"help", "bake"}, Words{"bake", "--help"}, Words{"--help", "bake"},
                             Words{"bake", "--no-such-option", "--help"}}) {
    EXPECT_EQ(asked(words).what, Asked::For::help) << words[0] << " " << words[1];
    EXPECT_EQ(asked(words).verb, line.find("bake")) << words[0] << " " << words[1];
  }
  EXPECT_EQ(asked({"--json", "info", "a.texbundle"}).verb, line.find("info"));
  EXPECT_TRUE(line.global().json);
  EXPECT_THROW(asked({"bakke", "a.png"}), Error);
  EXPECT_THROW(asked({}), Error);
}

}  // namespace
}  // namespace texbake
