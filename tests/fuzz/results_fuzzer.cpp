/// Directories of results from others, as a report reads them: nothing in them becomes a part of the page but text.

#include <array>
#include <filesystem>
#include <fstream>

#include "creepcontact/base/log.hpp"
#include "fuzz_target.hpp"
#include "report/criteria.hpp"
#include "report/run_sections.hpp"
#include "report/title_block.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace creepcontact;
  log::set_level(log::Level::off);
  constexpr std::array names{"summary.json", "model.json", "history.csv", "steps.csv"};
  const std::filesystem::path directory = std::filesystem::temp_directory_path() / "creepcontact_fuzz_results";
  std::filesystem::remove_all(directory);
  std::filesystem::create_directories(directory);
  const auto parts = fuzz::parts_of(fuzz::text_of(data, size), "\n---\n", names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!parts[i].empty()) std::ofstream(directory / names[i], std::ios::binary) << parts[i];
  fuzz::may_refuse([&] {
    const report::RunData run = report::read_run(directory, "fuzz", 1);
    report::Html page;
    report::add_question({run}, page);
    report::add_criteria(run, page);
    report::add_answer(run, page);
    report::add_accuracy(run, page);
    fuzz::require(page.text().find("<script") == std::string::npos, "texts of results are escaped");
  });
  return 0;
}
