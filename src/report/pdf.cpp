#include "pdf.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/platform/child_process.hpp"
#include "creepcontact/platform/private_directory.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "page.hpp"

namespace creepcontact::report {
namespace {

constexpr std::chrono::minutes longest{10};
constexpr std::chrono::milliseconds between_looks{50};

std::filesystem::path browser() {
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
    if (std::filesystem::path program = platform::find_on_path(name); !program.empty()) return program;
  throw ConfigError(
      "--pdf: PDF files are made by Chromium, which is not installed (Debian: apt-get install chromium); or write the "
      "report without --pdf, open it in any browser, and print it to a file");
}

/// Without network or settings of the user's, and with all that it writes in `place`.
std::vector<std::string> arguments_for(const std::filesystem::path& page, const std::filesystem::path& pdf,
                                       const std::filesystem::path& place) {
  std::vector<std::string> all{"--headless",
                               "--disable-gpu",
                               "--disable-dev-shm-usage",
                               "--disable-extensions",
                               "--disable-background-networking",
                               "--disable-component-update",
                               "--disable-sync",
                               "--no-first-run",
                               "--no-default-browser-check",
                               "--host-resolver-rules=MAP * ~NOTFOUND",
                               "--proxy-server=127.0.0.1:9",
                               "--no-pdf-header-footer",
                               "--user-data-dir=" + (place / "profile").string(),
                               "--crash-dumps-dir=" + place.string(),
                               "--print-to-pdf=" + pdf.string()};
  // Its sandbox does not work for root; the page is our own, and nothing in it is executed.
  if (::geteuid() == 0) all.emplace_back("--no-sandbox");
  all.push_back("file://" + page.string());
  return all;
}

}  // namespace

void require_browser() {
  browser();
}

double print_pdf(const std::string& page, const std::filesystem::path& file) {
  const std::filesystem::path program = browser();
  const platform::PrivateDirectory place;
  const std::filesystem::path html = place.path() / "report.html", pdf = place.path() / "report.pdf",
                              messages = place.path() / "messages.txt";
  platform::replace_file(html, page);
  const int log = platform::create_file(messages);
  // What it keeps next to the profile goes where its home is.
  std::vector<std::string> words{"HOME=" + place.path().string(), "XDG_CONFIG_HOME=" + place.path().string(),
                                 "XDG_CACHE_HOME=" + place.path().string(), program.string()};
  for (std::string& argument : arguments_for(html, pdf, place.path())) words.push_back(std::move(argument));
  platform::ChildProcess process({.program = "/usr/bin/env",
                                  .arguments = words,
                                  .descriptors = {{log, STDOUT_FILENO}, {log, STDERR_FILENO}},
                                  .directory = place.path()});
  ::close(log);
  const auto end = std::chrono::steady_clock::now() + longest;
  std::optional<int> status;
  while (!(status = process.poll()) && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(between_looks);
  if (!status) {
    process.kill();
    throw Error(fmt::format("--pdf: {} had not ended after {} minutes", program.string(), longest.count()), 4);
  }
  const std::string bytes = path_exists(pdf) ? read_file(pdf).bytes : "";
  if (*status != 0 || !bytes.starts_with("%PDF-")) {
    std::string said = read_file(messages).bytes;
    while (!said.empty() && said.back() == '\n') said.pop_back();
    throw Error(fmt::format("--pdf: {} failed with exit status {}: {}", program.string(), *status,
                            said.substr(said.rfind('\n') + 1)),
                4);
  }
  make_parent_directory(file, "--output");
  platform::replace_file(file, bytes);
  return static_cast<double>(bytes.size()) / 1e6;
}

}  // namespace creepcontact::report
