// A manifest by itself, and a whole bundle: verified, read and drawn.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>

#include "formats/bundle_io.h"
#include "formats/drawn_bundle.h"
#include "formats/json_text.h"
#include "formats/verify.h"
#include "libbake/draw/drawing.h"
#include "tests/fuzz/json_mutation.h"
#include "tests/fuzz/sound_bundles.h"
#include "tests/fuzz/target.h"

namespace texbake::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxDrawnTile = 512;  // more takes time and shows nothing new

fs::path folder() { return scratch() / "a.texbundle"; }

std::vector<Files> seed_files() {
  std::vector<Files> all;
  for (const Bundle& bundle : sound_bundles()) {
    fs::remove_all(folder());
    write_bundle(bundle, folder());
    all.push_back(files_of(folder()));
  }
  fs::remove_all(folder());
  return all;
}

std::vector<std::string> manifest_seeds() {
  std::vector<std::string> seeds;
  for (const Files& files : seed_files()) seeds.push_back(files.at(kManifestName));
  return seeds;
}

/// Half of the time with the names of files and the hashes of stages put right.
std::string mutate_manifest(const std::string& input, Random& random) {
  const std::string changed = mutate_json_text(input, random);
  Json json = Json::parse(changed, nullptr, false);
  if (json.is_discarded() || random.below(2) == 0) return changed;
  Files none;
  repair(json, none, Repair::names);
  return print_json(json);
}

void run_manifest(const std::string& input) {
  IssueLog log("", IssueLog::OnError::collect);
  Json json = parse_json(input, log);
  if (log.error_count() > 0) return;
  const Manifest manifest = parse_manifest(json, Semantics::known, log);
  for (const Issue& issue : log.issues())
    if (text(issue).size() > 4000) broken("an issue is told in a few lines: " + text(issue));
}

std::vector<std::string> bundle_seeds() {
  std::vector<std::string> seeds;
  for (const Files& files : seed_files()) seeds.push_back(packed(files));
  return seeds;
}

template <class T>
T& any_of(Image<T>& image, Random& random) {
  return image.data()[random.below(static_cast<uint32_t>(image.size()))];
}

float a_float(Random& random) {
  const float values[] = {0, 1, -1, 0.5f, 65504, INFINITY, NAN, 1e-7f};
  return values[random.below(8)];
}

void mutate_labels(Partition& partition, Random& random) {
  if (partition.idx.empty()) return;
  if (random.below(2) == 0)
    any_of(partition.idx, random) = random.below(4) == 0 ? random.next() : any_of(partition.idx, random);
  else
    any_of(partition.owner, random) = owner_of(random.below(9));
}

/// A texel or two with values that no stage writes.
void mutate_pixels(Scale& scale, Random& random) {
  switch (random.below(7)) {
    case 0:
      if (scale.fragments) mutate_labels(scale.fragments->partition, random);
      return;
    case 1:
      if (scale.patches) mutate_labels(scale.patches->partition, random);
      return;
    case 2:
      if (scale.colors && !scale.colors->index.empty())
        any_of(scale.colors->index, random) = static_cast<uint8_t>(random.below(70));
      return;
    case 3:
      if (scale.colors && !scale.colors->variation.empty()) any_of(scale.colors->variation, random) = a_float(random);
      return;
    case 4:
      if (scale.fragments && !scale.fragments->fragments.empty())
        scale.fragments->fragments[0] = {random.below(70), V3f(a_float(random))};
      return;
    case 5:
      for (Image<float>& mask : scale.masks)
        if (!mask.empty()) any_of(mask, random) = a_float(random);
      return;
    default:
      if (!scale.exemplar.empty() && scale.stores_exemplar) any_of(scale.exemplar, random) = V3f(a_float(random));
  }
}

/// The files of the bundle with other pixels, if it can be written at all.
Files with_other_pixels(const Files& files, Random& random) {
  write_files(files, folder());
  try {
    Bundle bundle = read_bundle(folder());
    mutate_pixels(bundle.scales[random.below(static_cast<uint32_t>(bundle.scales.size()))], random);
    fs::remove_all(folder());
    write_bundle(bundle, folder());
    return files_of(folder());
  } catch (const Error&) {
    return files;
  }
}

std::string mutate_bundle(const std::string& input, Random& random) {
  Files files = unpacked(input);
  const uint32_t what = random.below(10);
  if (what == 0) return mutate_bytes(input, random);
  if (what <= 2 && files.size() > 1) {
    // The headers of a payload lie in its first bytes.
    auto file = std::next(files.begin(), random.below(static_cast<uint32_t>(files.size())));
    const size_t head = std::min<size_t>(file->second.size(), 3000);
    file->second = mutate_bytes(file->second.substr(0, head), random) + file->second.substr(head);
  }
  if (what == 3 || what == 4) files = with_other_pixels(files, random);
  Json json = Json::parse(files[kManifestName], nullptr, false);
  if (json.is_discarded()) return packed(files);
  if (what >= 4) mutate_json(json, random);
  if (what != 9) repair(json, files, what <= 2 || what == 8 ? Repair::hashes : Repair::names);
  files[kManifestName] = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return packed(files);
}

void draw(const Bundle& bundle) {
  const DrawnMaterial material = drawn_material(bundle);
  const V2i size = material.tile_size();
  if (std::max(size.x, size.y) > kMaxDrawnTile) return;
  Window window{.origin_x = {}, .origin_y = {}, .width = 24, .height = 9, .filter = Filter::trilinear};
  window.step_256 = 700;
  const Drawing drawing(material, {.view = window});
  drawing.rows(0, 9);
  if (!bundle.scales.back().patches) return;
  window.filter = Filter::nearest;
  const Drawing labels(material, {.view = window, .show = Show::contents});
  labels.rows(0, 9);
}

/// What verify accepts can be read, and what can be read can be drawn, or is refused with a message.
void run_bundle(const std::string& input) {
  write_files(unpacked(input), folder());
  const std::vector<Issue> issues = verify_bundle(folder());
  bool was_read = false;
  try {
    const Bundle bundle = read_bundle(folder());
    was_read = true;
    draw(bundle);
  } catch (const Error& error) {
    if (!was_read && !has_errors(issues)) broken(std::string("what verify accepts can be read: ") + error.what());
  }
  if (!was_read || !std::getenv("FUZZ_JUDGE")) return;
  std::set<int> refused;
  for (const Issue& issue : issues)
    if (issue.kind().severity == Severity::error) refused.insert(issue.number());
  for (const int number : refused) std::printf("read, refused by verify: %d\n", number);
}

}  // namespace

const Target kManifest = {"manifest", manifest_seeds, mutate_manifest, run_manifest};
const Target kBundle = {"bundle", bundle_seeds, mutate_bundle, run_bundle};

}  // namespace texbake::fuzz
