// texbake report: bundle → how good it is, as numbers and as a page, beside what a user would pick instead.
#include "libbake/report/report.h"

#include <memory>

#include "bake/report_of_bundle.h"
#include "cli/bundle_path.h"
#include "cli/command.h"
#include "cli/kept_files.h"
#include "cli/option_flags.h"
#include "cli/report_json.h"
#include "formats/bundle_io.h"
#include "formats/byte_text.h"
#include "formats/safe_file.h"
#include "pages/report_page.h"

namespace texbake {
namespace {

/// From which verdict on the answer is no.
enum class FailOn { never, warn, fail };

}  // namespace

template <>
struct EnumNames<FailOn> {
  static constexpr std::pair<FailOn, std::string_view> values[] = {
      {FailOn::never, "never"}, {FailOn::warn, "warn"}, {FailOn::fail, "fail"}};
};

namespace {

struct JudgeOptions {
  FailOn fail_on = FailOn::never;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.fail_on, Field{.name = "fail-on",
                              .help = "end with exit code 1 if the verdict is this or worse; a measure that could not "
                                      "be taken counts as worse than warn"});
  }
};

struct ReportFlags {
  std::string bundle;
  std::string output;
  ReportOptions options;
  JudgeOptions judge;
};

void write_page(const Report& report, const ReportFlags& request, const Bundle& bundle) {
  const auto& colors = bundle.scales.back().colors;
  const std::string name = text_of_bytes(std::filesystem::path(request.bundle).filename().string());
  SafeFile file(request.output);
  file.write(report_page(report, name, colors ? &colors->palette : nullptr));
  file.commit();
}

ExitCode exit_code_of(const Report& report, FailOn fail_on) {
  const Verdict least = fail_on == FailOn::warn ? Verdict::warn : Verdict::undefined;
  return fail_on != FailOn::never && report.verdict >= least ? ExitCode::no : ExitCode::done;
}

std::string text_of(const Report& report, const ReportFlags& request) {
  std::string text;
  for (const Judgement& judgement : report.judgements) {
    const MeasureKind& kind = kind_of(judgement.measure);
    text += fmt::format("{:<12} {:<24} {}{}{} (good: {})\n", enum_name(judgement.verdict), kind.label,
                        measured_text(report.of(Method::bundle)[judgement.measure]), kind.unit.empty() ? "" : " ",
                        kind.unit, good_text(judgement.limits));
  }
  for (const MapReport& map : report.maps)
    text +=
        fmt::format("{:<12} {:<24} {:.2f}, {:.2f} (good: {})\n", enum_name(map.verdict), "Wrap seam of map " + map.name,
                    map.tile_x, map.tile_y, good_text(*limits_of(Measure::tile_x, 1)));
  if (!report.is_suitable())
    text += fmt::format("unsuitable: {}\nwhat helps: {}\n", report.suitability.because, report.suitability.helps);
  text += fmt::format("{}: {}\n", request.bundle, report.is_suitable() ? enum_name(report.verdict) : "unsuitable");
  if (!request.output.empty()) text += request.output + "\n";
  return text;
}

Outcome run(const ReportFlags& request, Console& console) {
  check_options(request.options);
  if (!request.output.empty()) {
    check_page_name(request.output);
    check_file_target(request.output);
  }
  console.step("read");
  const Bundle bundle = read_bundle(request.bundle);
  check_keeps_sources(request.output, bundle);
  const Report result = report(report_input(bundle), request.options, console.step("measure"));
  if (!request.output.empty()) {
    console.step("write");
    write_page(result, request, bundle);
  }
  console.finish_step();
  return {exit_code_of(result, request.judge.fail_on), text_of(result, request),
          report_json(result, request.bundle, request.output)};
}

Action declare_report(Arguments& arguments) {
  const auto request = std::make_shared<ReportFlags>();
  add_bundle_path(arguments, request->bundle);
  arguments.option({.name = "output",
                    .letter = 'o',
                    .value = "FILE",
                    .names = Names::file,
                    .standard = "no page",
                    .help = "the page to write, one .html file",
                    .assign = into(request->output)});
  // Declared first, so that flags that follow change what it sets.
  arguments.flag({.name = "quick",
                  .help = "a preview within seconds: --seeds 1 --side 256",
                  .assign = [request](const std::string&) { request->options = ReportOptions::quick(); }});
  add_flags(arguments, request->options, "Options");
  add_flags(arguments, request->judge, "Options");
  return [request](Console& console) { return run(*request, console); };
}

}  // namespace

Command report_command() {
  return {"report", "bundle → numbers and page: measure how good it is, beside periodic, Wang and hex tiling",
          "  texbake report leaves.texbundle -o leaves.html\n"
          "  texbake report leaves.texbundle --quick --fail-on warn --json",
          declare_report};
}

}  // namespace texbake
