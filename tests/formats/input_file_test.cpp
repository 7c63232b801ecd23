#include "formats/input_file.h"

#include <gtest/gtest.h>

#include "libbake/base/error.h"
#include "tests/formats/bundle_fixtures.h"

namespace texbake {
namespace {

TEST(InputFile, AFileIsReadWithEveryByte) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\r\n\xff", 6);
  write_text(folder / "a", bytes);
  EXPECT_EQ(file_bytes((folder / "a").string()), bytes);
}

TEST(InputFile, AFileThatIsNotThereIsAnIoError) {
  const TemporaryFolder folder;
  try {
    file_bytes((folder / "none").string());
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::io);
  }
}

}  // namespace
}  // namespace texbake
