#include "page.hpp"

#include <fmt/format.h>

#include "assets.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/platform/replace_file.hpp"

namespace creepcontact::report {

void open_page(const std::string& title, Html& page, Script script) {
  page.raw(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"generator\" content=\"creepcontact " CREEPCONTACT_VERSION "\">\n");
  // Whatever a page may have become by a mistake here: it loads nothing and sends nothing.
  page.raw(
      fmt::format("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
                  "'unsafe-inline'; script-src {}; base-uri 'none'; form-action 'none'\">\n",
                  script == Script::embedded ? "'unsafe-inline'" : "'none'"));
  page.element("title", title);
  page.raw("<style>\n");
  page.raw(report_style());
  page.raw(viewer_style());
  page.raw("</style>\n</head>\n<body>\n");
}

void close_page(Html& page, Script script) {
  if (script == Script::embedded && !viewer_script().empty()) {
    page.raw("<script>\n");
    page.raw(viewer_script());
    page.raw("\n</script>\n");
  }
  page.raw("</body>\n</html>\n");
}

void make_parent_directory(const std::filesystem::path& file, const char* option) {
  std::error_code failure;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), failure);
  if (failure)
    throw ConfigError(fmt::format("{}: directory {}: {}", option, file.parent_path().string(), failure.message()));
}

void write_page(const std::filesystem::path& file, const std::string& text, const char* option) {
  make_parent_directory(file, option);
  platform::replace_file(file, text);
}

}  // namespace creepcontact::report
