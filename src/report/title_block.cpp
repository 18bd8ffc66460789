#include "title_block.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "creepcontact/base/base64.hpp"
#include "creepcontact/base/image.hpp"
#include "markdown.hpp"

namespace creepcontact::report {
namespace {

/// The text, if there are runs and all have the same; else empty.
std::string common(const std::vector<RunData>& runs, std::string io::RecordedReport::*member) {
  if (runs.empty()) return "";
  const std::string& first = runs.front().record.report.*member;
  const bool same = std::ranges::all_of(runs, [&](const RunData& run) { return run.record.report.*member == first; });
  return same ? first : "";
}

/// "2026-11-27 14:05" of an ISO date
std::string date_of(const std::string& iso) {
  constexpr std::size_t day = 10, minute = 16;
  if (iso.size() < minute) return iso;
  return iso.substr(0, day) + ' ' + iso.substr(day + 1, minute - day - 1);
}

}  // namespace

std::string add_title_block(const std::vector<RunData>& runs, const std::string& title, Html& page) {
  const std::time_t now = std::time(nullptr);
  std::string missing;
  page.open("header");
  if (const std::string logo = common(runs, &io::RecordedReport::logo); !logo.empty()) {
    // The type is that of the content: model.json may be anybody's.
    const std::optional<std::string> bytes = from_base64(logo);
    const std::string type = bytes && bytes->size() <= max_image_bytes ? image_type(*bytes) : "";
    if (type.empty())
      missing = "The logo in model.json is not an image.";
    else
      page.raw(fmt::format("<img class=\"logo\" src=\"{}\" alt=\"Logo\">\n", data_url(type, *bytes)));
  } else if (const std::string file = common(runs, &io::RecordedReport::logo_file); !file.empty()) {
    missing = fmt::format("The logo {} could not be read when the run began.", file);
  }
  page.element("h1", title);
  page.open("dl", "class=\"block\"");
  const auto add = [&](const char* name, const std::string& text) {
    if (text.empty()) return;
    page.open("div");
    page.element("dt", name);
    page.element("dd", text);
    page.close("div");
  };
  add("Project", common(runs, &io::RecordedReport::project));
  add("Drawing", common(runs, &io::RecordedReport::drawing));
  add("Revision", common(runs, &io::RecordedReport::revision));
  add("Author", common(runs, &io::RecordedReport::author));
  add("Checked by", common(runs, &io::RecordedReport::checker));
  if (runs.size() == 1) add("Computed", date_of(runs.front().record.started));
  add("Report", fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(now)));
  add("Program", "creepcontact " CREEPCONTACT_VERSION);
  if (runs.size() == 1) add("Model", runs.front().record.fingerprint);
  page.close("dl");
  page.close("header");
  return missing;
}

void add_question(const std::vector<RunData>& runs, Html& page) {
  const std::string purpose = common(runs, &io::RecordedReport::purpose);
  if (purpose.empty()) return;
  page.open("section", "id=\"question\"");
  page.element("h2", "Question");
  page.raw(markdown(purpose, 3));
  page.close("section");
}

}  // namespace creepcontact::report
