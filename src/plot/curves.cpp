#include "creepcontact/plot/curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "axis_range.hpp"

namespace creepcontact::plot {
namespace {

/// The points that are shown, in the order of x: lines then do not cross themselves.
Series shown(const Series& all, const Axis& x, const Axis& y) {
  std::vector<std::size_t> order(all.x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) { return !is_drawn(all.x[i], all.y[i], x, y); });
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return all.x[i]; });
  Series series = all;
  series.x.clear();
  series.y.clear();
  for (const std::size_t i : order) {
    series.x.push_back(all.x[i]);
    series.y.push_back(all.y[i]);
  }
  return series;
}

}  // namespace

std::vector<std::filesystem::path> draw_curves(const Curves& curves, const std::filesystem::path& directory,
                                               const std::string& stem) {
  std::vector<Series> all;
  for (const Series& series : curves.series) all.push_back(shown(series, curves.x, curves.y));
  std::erase_if(all, [](const Series& series) { return series.x.empty(); });
  std::vector<std::filesystem::path> pictures;
  auto next = all.begin();
  for (const std::size_t size : even_parts(all.size(), max_series)) {
    Figure figure{curves.title, curves.x, {{curves.y, {next, next + size}}}};
    const std::string name = pictures.empty() ? stem : fmt::format("{}_{}", stem, pictures.size() + 1);
    draw(figure, directory, name);
    pictures.push_back(directory / (name + ".svg"));
    next += static_cast<long>(size);
  }
  return pictures;
}

}  // namespace creepcontact::plot
