#include "pages/report_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/base64.h"
#include "formats/picture_bytes.h"
#include "formats/srgb_codes.h"
#include "libbake/color/luv.h"

namespace texbake {
namespace {

constexpr const char* kStyle =
#include "pages/report_style.inc"
    ;

/// One heading of the page and the pictures below it.
struct Section {
  PictureGroup group;
  const char* title;
  const char* note;
};
constexpr Section kOverview = {PictureGroup::overview, "The exemplar and the result", ""};
constexpr Section kNear = {PictureGroup::near, "The same window, up close",
                           "Where four tiles meet, one texel per pixel."};
constexpr Section kFar = {PictureGroup::far, "From a distance",
                          "Each rendering as a whole: a grid that shows here reveals the tiling."};
constexpr Section kSeams = {PictureGroup::seams, "Seams and repetition", ""};
constexpr Section kParts = {PictureGroup::parts, "How it is put together", ""};
constexpr Section kLayers = {PictureGroup::layers, "Structure and noise", ""};

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string number_text(double value) {
  const double size = std::fabs(value);
  if (size >= 100) return fmt::format("{:.0f}", value);
  if (size >= 10) return fmt::format("{:.1f}", value);
  if (size >= 1) return fmt::format("{:.2f}", value);
  return fmt::format("{:.3f}", size < 0.0005 ? 0.0 : value);  // no -0.000
}

std::string pill(std::string_view name, std::string_view text) {
  return fmt::format("<span class=\"pill {}\">{}</span>", name, text);
}

const char* words(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::warn:
      return "warn";
    case Verdict::undefined:
      return "not defined";
    default:
      return "fail";
  }
}

std::string figure(const ReportPicture& picture) {
  const PictureCoding coding = picture.is_drawing ? PictureCoding::png : PictureCoding::jpeg;
  const std::string bytes = picture_bytes(picture.linear, coding);
  const bool wide = picture.linear.width() > 3 * picture.linear.height();
  return fmt::format(
      "<figure class=\"{}{}\"><img alt=\"{}\" width=\"{}\" height=\"{}\" src=\"data:image/{};base64,{}\">"
      "<figcaption>{}</figcaption></figure>\n",
      picture.is_drawing ? "drawing" : "photo", wide ? " wide" : "", escaped(picture.caption), picture.linear.width(),
      picture.linear.height(), coding == PictureCoding::png ? "png" : "jpeg", base64(bytes.data(), bytes.size()),
      escaped(picture.caption));
}

std::string heading(const Section& section) {
  std::string html = fmt::format("<h2>{}</h2>\n", section.title);
  if (*section.note) html += fmt::format("<p class=\"soft\">{}</p>\n", section.note);
  return html;
}

/// "" where the report has no such pictures.
std::string gallery(const Report& report, const Section& section, const char* layout = "grid") {
  std::string figures;
  for (const ReportPicture& picture : report.pictures)
    if (picture.group == section.group) figures += figure(picture);
  if (figures.empty()) return "";
  return heading(section) + fmt::format("<div class=\"{}\">\n{}</div>\n", layout, figures);
}

std::string swatches(const Palette& palette) {
  const SrgbEncoder encode(8);
  std::string html = "<p class=\"soft\">Palette: the dominant colors.</p><div class=\"swatches\">";
  for (const ColorClass& c : palette.classes) {
    const V3f linear = linear_from_luv(c.dominant);
    html += fmt::format("<span style=\"background:rgb({},{},{})\"></span>", encode(linear.x), encode(linear.y),
                        encode(linear.z));
  }
  return html + "</div>\n";
}

std::string cell(const char* label, const Measured& measured) {
  if (!measured.value)
    return fmt::format("<td class=\"none\" data-label=\"{}\"><abbr title=\"{}\">–</abbr></td>", label,
                       escaped(measured.undefined_because));
  const auto [mean, spread] = *measured.value;
  const std::string deviation = spread > 0 ? fmt::format(" <small>± {}</small>", number_text(spread)) : "";
  return fmt::format("<td data-label=\"{}\"><span>{}{}</span></td>", label, number_text(mean), deviation);
}

std::string bundle_cell(const Measured& measured, const Judgement* judgement) {
  const std::string verdict =
      judgement ? pill(enum_name(judgement->verdict), words(judgement->verdict)) : std::string();
  if (!measured.value)
    return fmt::format("<td class=\"why\" data-label=\"This\"><span>{}<small> not defined here: {}</small></span></td>",
                       verdict, escaped(measured.undefined_because));
  const auto [mean, spread] = *measured.value;
  const std::string deviation = spread > 0 ? fmt::format(" <small>± {}</small>", number_text(spread)) : "";
  return fmt::format("<td data-label=\"This\"><span>{}{}{}</span></td>", number_text(mean), deviation, verdict);
}

const Judgement* judgement_of(const Report& report, Measure measure) {
  for (const Judgement& judgement : report.judgements)
    if (judgement.measure == measure) return &judgement;
  return nullptr;
}

std::string table_row(const Report& report, const MeasureKind& kind) {
  const Judgement* judgement = judgement_of(report, kind.measure);
  const bool good = !judgement || judgement->verdict == Verdict::pass;
  const std::string unit = kind.unit.empty() ? "" : fmt::format(" <span class=\"unit\">{}</span>", kind.unit);
  const std::string advice = good ? "" : fmt::format("<small class=\"try\">Try: {}.</small>", escaped(kind.advice));
  std::string html = fmt::format("<tr><th scope=\"row\">{}{}<small>{}</small>{}</th>", kind.label, unit,
                                 escaped(kind.meaning), advice);
  html += bundle_cell(report.of(Method::bundle)[kind.measure], judgement);
  html += judgement ? fmt::format("<td data-label=\"Good\">{}</td>", good_text(judgement->limits))
                    : std::string("<td class=\"none\" data-label=\"Good\"></td>");
  html += cell("Periodic", report.of(Method::periodic)[kind.measure]);
  html += cell("Wang", report.of(Method::wang)[kind.measure]);
  html += cell("Hex", report.of(Method::hex)[kind.measure]);
  html += cell("Halves", report.floor[kind.measure]);
  return html + "</tr>\n";
}

/// The wrap of a map: the rows of the color's, with what the other methods do not change left out.
std::string map_row(const MapReport& map) {
  return fmt::format(
      "<tr><th scope=\"row\">Wrap seam of the map {}<small>Left to right, and top to bottom.</small></th>"
      "<td data-label=\"This\"><span>{}, {}{}</span></td><td data-label=\"Good\">{}</td>"
      "<td class=\"none\"></td><td class=\"none\"></td><td class=\"none\"></td><td class=\"none\"></td></tr>\n",
      escaped(map.name), number_text(map.tile_x), number_text(map.tile_y),
      pill(enum_name(map.verdict), words(map.verdict)), good_text(*limits_of(Measure::tile_x, 1)));
}

bool is_present(const Report& report, const MeasureKind& kind) {
  const Measured& measured = report.of(Method::bundle)[kind.measure];
  return measured.value || !measured.undefined_because.empty();
}

std::string table(const Report& report) {
  std::string html =
      "<h2>The numbers</h2>\n<p class=\"soft\">The limits are engineering choices, found on photographs by comparing "
      "these numbers with what is seen; they are not a study of perception. Halves: the same measure between the "
      "exemplar's left and right halves, which is what chance alone "
      "gives.</p>\n<table><thead><tr><th>Measure</th><th>This "
      "bundle</th><th>Good</th><th>Periodic</th><th>Wang</th><th>Hex</th><th>Halves</th></tr></thead><tbody>\n";
  // The groups in the order in which they first appear; a group's rows together.
  std::vector<std::string_view> groups;
  for (const MeasureKind& kind : measure_kinds())
    if (is_present(report, kind) && std::find(groups.begin(), groups.end(), kind.group) == groups.end())
      groups.push_back(kind.group);
  for (const std::string_view group : groups) {
    html += fmt::format("<tr class=\"group\"><th colspan=\"7\">{}</th></tr>\n", group);
    for (const MeasureKind& kind : measure_kinds())
      if (kind.group == group && is_present(report, kind)) html += table_row(report, kind);
    if (group == kind_of(Measure::tile_y).group)
      for (const MapReport& map : report.maps) html += map_row(map);
  }
  return html + "</tbody></table>\n";
}

std::string how_measured(const Report& report) {
  std::string text = fmt::format("Measured on {} rendering{} of {} × {} tiles", report.options.seeds,
                                 report.options.seeds == 1 ? "" : "s", report.options.tiles, report.options.tiles);
  if (report.reduction > 1)
    text += fmt::format(", at 1/{} of the tile's size, at which sharpness is less accurate", report.reduction);
  text += report.seam_reduction > 1 ? fmt::format(", seams at 1/{}", report.seam_reduction) : ", seams at full size";
  return text + ".";
}

std::string summary(const Report& report, const std::string& name) {
  const std::string_view verdict = report.is_suitable() ? enum_name(report.verdict) : "unsuitable";
  const char* shown = report.is_suitable() ? words(report.verdict) : "unsuitable";
  std::string html = fmt::format("<header><h1>{}</h1>{}</header>\n", escaped(name), pill(verdict, shown));
  html += fmt::format("<p>{}</p>\n", escaped(verdict_sentence(report)));
  if (!report.is_suitable())
    html += fmt::format("<div class=\"box\"><p>Unsuitable: {}.</p><p>What helps: {}.</p></div>\n",
                        escaped(report.suitability.because), escaped(report.suitability.helps));
  html += fmt::format("<p class=\"soft\">{} × {} texels, {} patches, {} contents each. {}</p>\n", report.tile_px.x,
                      report.tile_px.y, report.patch_count, report.content_count, how_measured(report));
  return html;
}

}  // namespace

std::string measured_text(const Measured& measured) {
  if (!measured.value) return "not defined here: " + measured.undefined_because;
  const auto [mean, spread] = *measured.value;
  return number_text(mean) + (spread > 0 ? " ± " + number_text(spread) : "");
}

std::string verdict_sentence(const Report& report) {
  std::string bad;
  std::string doubtful;
  std::string missing;
  const auto add = [](std::string& list, std::string_view label) {
    list += (list.empty() ? "" : ", ") + std::string(label);
  };
  for (const Judgement& judgement : report.judgements) {
    const std::string_view label = kind_of(judgement.measure).label;
    if (judgement.verdict == Verdict::fail) add(bad, label);
    if (judgement.verdict == Verdict::warn) add(doubtful, label);
    if (judgement.verdict == Verdict::undefined) add(missing, label);
  }
  for (const MapReport& map : report.maps) {
    if (map.verdict == Verdict::fail) add(bad, "wrap seam of " + map.name);
    if (map.verdict == Verdict::warn) add(doubtful, "wrap seam of " + map.name);
  }
  if (bad.empty() && doubtful.empty() && missing.empty()) return "Every measure is good.";
  std::string text;
  if (!bad.empty()) text += "Bad: " + bad + ". ";
  if (!missing.empty()) text += "Could not be measured: " + missing + ". ";
  if (!doubtful.empty()) text += "Doubtful: " + doubtful + ".";
  return text;
}

std::string report_page(const Report& report, const std::string& name, const Palette* palette) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
      "<title>{}: report</title>\n<style>\n{}</style></head>\n<body><main>\n",
      escaped(name), kStyle);
  html += summary(report, name);
  html += gallery(report, kOverview, "pair");
  html += gallery(report, kNear);
  html += gallery(report, kFar);
  html += table(report);
  html += gallery(report, kSeams);
  const std::string parts = gallery(report, kParts);
  html += parts;
  if (palette && !parts.empty()) html += swatches(*palette);
  html += gallery(report, kLayers);
  return html + "</main></body></html>\n";
}

}  // namespace texbake
