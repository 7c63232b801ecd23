// A stranger's reader: formats/README.md turned into code with nothing of texbake's own but SHA-256.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <gtest/gtest.h>

#include <cstring>

#include "formats/sha256.h"
#include "tests/formats/bundle_fixtures.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

/// Canonical bytes of a plane, and its size.
struct Pixels {
  std::string bytes;
  int width = 0;
  int height = 0;

  template <class T>
  T at(size_t channels, size_t channel, int x, int y) const {
    T value;
    const size_t row = static_cast<size_t>(y) * channels + channel;
    std::memcpy(&value, bytes.data() + (row * static_cast<size_t>(width) + static_cast<size_t>(x)) * sizeof(T),
                sizeof(T));
    return value;
  }
};

/// Sections 1 (step 5) and 4: the whole part at once, then put into the canonical order.
Pixels read_pixels(const fs::path& folder, const nlohmann::json& plane) {
  Imf::MultiPartInputFile file((folder / plane["file"].get<std::string>()).c_str());
  int number = 0;
  while (file.header(number).name() != plane["part"].get<std::string>()) ++number;
  Imf::InputPart part(file, number);
  const Imath::Box2i window = part.header().dataWindow();
  Pixels pixels{{}, window.max.x + 1, window.max.y + 1};
  const auto width = static_cast<size_t>(pixels.width), height = static_cast<size_t>(pixels.height);

  const std::string type = plane["type"];
  const size_t value = type == "half" ? 2 : 4;
  std::vector<std::string> channels(plane["channels"].size(), std::string(width * height * value, '\0'));
  Imf::FrameBuffer frame;
  for (size_t c = 0; c < channels.size(); ++c)
    frame.insert(plane["channels"][c].get<std::string>(),
                 Imf::Slice(type == "uint" ? Imf::UINT : (type == "half" ? Imf::HALF : Imf::FLOAT), channels[c].data(),
                            value, value * width));
  part.setFrameBuffer(frame);
  part.readPixels(0, window.max.y);
  for (size_t y = 0; y < height; ++y)
    for (const std::string& channel : channels) pixels.bytes += channel.substr(y * width * value, width * value);
  return pixels;
}

class Readme : public testing::Test {
 protected:
  Readme() : bundle_(bundle_with_everything()), path_(folder_ / "a.texbundle") {
    write_bundle(bundle_, path_);
    manifest_ = nlohmann::ordered_json::parse(file_text(path_ / "bundle.json"));
    scale_ = manifest_["scales"][0];
  }
  /// All plane objects in the order of the file.
  std::vector<nlohmann::json> planes() const {
    std::vector<nlohmann::json> planes;
    for (const auto& [key, plane] : scale_["planes"].items()) planes.push_back(plane);
    for (const auto& map : scale_["maps"]) planes.push_back(map["plane"]);
    return planes;
  }
  /// Section 8: the spectra and the histogram, and the tiles.
  std::vector<nlohmann::json> noise_planes() const {
    std::vector<nlohmann::json> planes = {manifest_["noise"]["histogram"]};
    for (const auto& noise : manifest_["noise"]["noises"])
      for (const char* key : {"spectrum", "tile"}) planes.push_back(noise[key]);
    return planes;
  }

  TemporaryFolder folder_;
  Bundle bundle_;
  fs::path path_;
  nlohmann::ordered_json manifest_, scale_;
};

TEST_F(Readme, PixelHashIsThatOfTheCanonicalBytes) {
  for (const auto& plane : planes()) EXPECT_EQ(sha256(read_pixels(path_, plane).bytes), plane["pixelHash"]) << plane;
}

TEST_F(Readme, PixelHashIsThatOfTheCanonicalBytesOfNoisesToo) {
  for (const auto& plane : noise_planes())
    EXPECT_EQ(sha256(read_pixels(path_, plane).bytes), plane["pixelHash"]) << plane;
}

TEST_F(Readme, HistogramsAndSpectraAreWhereItSays) {
  const Pixels histogram = read_pixels(path_, manifest_["noise"]["histogram"]);
  const Pixels spectrum = read_pixels(path_, manifest_["noise"]["noises"][1]["spectrum"]);
  const NoiseChannel& channel = bundle_.noise->noises[1].channels[2];
  EXPECT_EQ(histogram.at<float>(1, 0, 33, 3 * 1 + 2), channel.equalization.values[33]);
  EXPECT_EQ(spectrum.width, channel.spectrum.width());
  EXPECT_EQ(spectrum.at<float>(3, 2, 1, 2), channel.spectrum(1, 2));
}

TEST_F(Readme, TheFileIsNamedByItsContentHash) {
  std::string lines, last;
  for (const auto& plane : planes()) {
    if (plane["part"] == last) continue;
    last = plane["part"];
    const Pixels pixels = read_pixels(path_, plane);
    std::string channels;
    for (const auto& channel : plane["channels"]) {
      if (!channels.empty()) channels += ',';
      channels += channel.get<std::string>();
    }
    std::ostringstream line;
    line << last << ' ' << pixels.width << ' ' << pixels.height << ' ' << plane["type"].get<std::string>() << ' '
         << channels << ' ' << plane["pixelHash"].get<std::string>() << '\n';
    lines += line.str();
  }
  EXPECT_EQ(payload_of(path_).filename().string(), "fine-" + sha256(lines).substr(0, 12) + ".exr");
}

TEST_F(Readme, PartsShareTheDisplayWindowAndThePreviewIsFirst) {
  const Imf::MultiPartInputFile file(payload_of(path_).c_str());
  EXPECT_EQ(file.header(0).name(), "preview");
  for (int i = 0; i < file.parts(); ++i)
    EXPECT_EQ(file.header(i).displayWindow(), Imath::Box2i(V2i(0, 0), V2i(63, 63)));
}

TEST_F(Readme, OwnerOffsetsAndTheFragmentTableAreWhereItSays) {
  const Pixels fragment = read_pixels(path_, scale_["planes"]["fragment"]);
  const Pixels color = read_pixels(path_, scale_["planes"]["fragmentColor"]);
  const FragmentMap& fragments = *bundle_.scales[0].fragments;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      EXPECT_EQ(fragment.at<uint32_t>(2, 0, x, y), fragments.partition.idx(x, y));
      const int code = static_cast<int>(fragment.at<uint32_t>(2, 1, x, y));
      EXPECT_EQ(code % 3 - 1, fragments.partition.owner(x, y).x);
      EXPECT_EQ(code / 3 - 1, fragments.partition.owner(x, y).y);
    }
  const int count = scale_["fragments"]["count"];
  EXPECT_EQ(color.height, (count + 63) / 64);
  for (int i = 0; i < count; ++i)
    EXPECT_EQ(color.at<float>(3, 1, i % 64, i / 64), fragments.fragments[static_cast<size_t>(i)].mean_color.y);
}

TEST_F(Readme, TheOutputOfAStageIsTheHashOfItsMembersWithoutWhiteSpace) {
  const auto hash_of = [&](const char* member) {
    nlohmann::ordered_json part = nlohmann::ordered_json::array({{{member, scale_[member]}}});
    return sha256(compact_json(part));
  };
  EXPECT_EQ(manifest_["stages"][5]["output"], hash_of("contents"));
  nlohmann::ordered_json plane = scale_["planes"]["patch"];
  plane.erase("file");
  nlohmann::ordered_json part;
  part["planes"]["patch"] = plane;
  part["patches"] = scale_["patches"];
  EXPECT_EQ(manifest_["stages"][4]["output"], sha256(compact_json(nlohmann::ordered_json::array({part}))));
  EXPECT_EQ(manifest_["stages"][0]["input"], sha256("color " + std::string(64, 'a') + "\n"));
}

}  // namespace
}  // namespace texbake
