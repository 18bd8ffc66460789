#include "creepcontact/io/error_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>

#include "creepcontact/base/error.hpp"
#include "creepcontact/io/plot.hpp"

namespace creepcontact::io {
namespace {

using List = std::vector<double> MethodErrors::*;

void check(const MethodErrors& method) {
  const std::size_t runs = method.error.size();
  if (method.setting.size() != runs || method.elastic_solves.size() != runs || method.wall_seconds.size() != runs)
    throw ConfigError(fmt::format(
        "errors of '{}': {} errors, {} settings, {} numbers of solves and {} times; each run has one of "
        "every kind",
        method.name, runs, method.setting.size(), method.elastic_solves.size(), method.wall_seconds.size()));
}

/// What a logarithmic plot can show, in the order of x: lines then do not cross themselves.
Series series_of(const MethodErrors& method, List list) {
  Series series{method.name, {}, {}};
  std::vector<std::size_t> order(method.error.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::vector<double>& x = method.*list;
  std::erase_if(order, [&](std::size_t i) { return !(x[i] > 0 && method.error[i] > 0); });
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return x[i]; });
  for (std::size_t i : order) {
    series.x.push_back(x[i]);
    series.y.push_back(method.error[i]);
  }
  return series;
}

std::string file_name(std::string text) {
  for (char& c : text)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return text;
}

}  // namespace

std::vector<std::filesystem::path> plot_errors(const std::filesystem::path& directory, const std::string& title,
                                               const std::string& error_label, const std::vector<MethodErrors>& methods,
                                               const std::string& stem) {
  for (const MethodErrors& method : methods) check(method);
  std::vector<std::filesystem::path> pictures;
  const auto picture = [&](const std::string& over, const std::string& label, const std::vector<Series>& all) {
    const std::string name = fmt::format("{}error_over_{}", stem.empty() ? "" : file_name(stem) + "_", file_name(over));
    auto next = all.begin();
    int part = 0;
    for (std::size_t size : even_parts(all.size(), max_series)) {
      Figure figure;
      figure.title = title;
      figure.x = {.label = label, .logarithmic = true};
      figure.panels.emplace_back();
      figure.panels[0].y = {.label = error_label, .logarithmic = true};
      figure.panels[0].series.assign(next, next + static_cast<long>(size));
      const std::string file = ++part == 1 ? name : fmt::format("{}_{}", name, part);
      draw(figure, directory, file);
      pictures.push_back(directory / (file + ".svg"));
      next += static_cast<long>(size);
    }
  };
  const auto collect = [&](List list, const std::string* setting) {
    std::vector<Series> all;
    for (std::size_t m = 0; m < methods.size(); ++m) {
      if (setting != nullptr && methods[m].setting_name != *setting) continue;
      all.push_back(series_of(methods[m], list));
      if (methods.size() <= max_series) all.back().look = static_cast<int>(m);  // the same in every picture
    }
    std::erase_if(all, [](const Series& series) { return series.x.empty(); });
    return all;
  };
  std::vector<std::string> settings;
  for (const MethodErrors& method : methods)
    if (std::ranges::count(settings, method.setting_name) == 0) settings.push_back(method.setting_name);
  for (const std::string& setting : settings) picture(setting, setting, collect(&MethodErrors::setting, &setting));
  picture("solves", "elastic solves", collect(&MethodErrors::elastic_solves, nullptr));
  picture("seconds", "wall-clock time (s)", collect(&MethodErrors::wall_seconds, nullptr));
  return pictures;
}

}  // namespace creepcontact::io
