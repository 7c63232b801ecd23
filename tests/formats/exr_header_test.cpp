#include "formats/exr_header.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formats/verify.h"
#include "tests/formats/bundle_fixtures.h"

namespace texbake {
namespace {

TEST(ExrHeader, OfAPayloadIsSound) {
  const TemporaryFolder folder;
  write_bundle(bundle_with_everything(), folder / "a.texbundle");
  EXPECT_EQ(read_exr_headers(payload_of(folder / "a.texbundle")).fault, "");
}

TEST(ExrHeader, AnAttributeThatClaimsMoreThanTheFileIsRefusedUnread) {
  const TemporaryFolder folder;
  write_bundle(bundle_with_everything(), folder / "a.texbundle");
  const auto payload = payload_of(folder / "a.texbundle");
  std::string bytes = file_text(payload);
  const std::string attribute("name\0string\0", 12);
  const size_t size_at = bytes.find(attribute) + attribute.size();
  bytes.replace(size_at, 4, std::string("\xff\xff\xff\x7f", 4));
  write_text(payload, bytes);
  EXPECT_THAT(read_exr_headers(payload).fault, testing::HasSubstr("attribute \"name\" of 2147483647 bytes"));
  EXPECT_EQ(verify_bundle(folder / "a.texbundle").at(0).id, IssueId::exr_unreadable);
}

TEST(ExrHeader, WhatIsNoOpenExrIsRefused) {
  const TemporaryFolder folder;
  for (const char* text : {"", "v/1", "\x89PNG\r\n", "v/1\x01 and then names that never end"}) {
    write_text(folder / "a.exr", text);
    EXPECT_NE(read_exr_headers(folder / "a.exr").fault, "") << text;
  }
}

}  // namespace
}  // namespace texbake
