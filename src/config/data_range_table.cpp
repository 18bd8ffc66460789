/// [materials.<name>.data_range], an older way to give the ranges of creep laws

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

/// Two numbers in order; none: not known.
Value<std::vector<double>> interval(const Value<double>& entry) {
  Value<std::vector<double>> value = list(entry);
  value.read = [entry](const Item& item, Context& context) -> std::optional<std::vector<double>> {
    auto found = list(entry).read(item, context);
    if (!found) return std::nullopt;
    if (found->empty() || (found->size() == 2 && found->front() <= found->back())) return found;
    context.errors.add(item.location, fmt::format("the list [{}]", fmt::join(*found, ", ")),
                       "two numbers, the smaller one first");
    return std::nullopt;
  };
  return value;
}

}  // namespace

Value<DataRange> data_range_table() {
  return table<DataRange>({
      field<DataRange>("stress", &DataRange::stress, interval(number({.min = 0})),
                       "smallest and largest stress of the tests")
          .in("stress"),
      field<DataRange>("temperature", &DataRange::temperature, interval(number()),
                       "lowest and highest temperature of the tests")
          .in("temperature"),
      field<DataRange>("time", &DataRange::time, interval(number({.min = 0})), "first and last time of the readings")
          .in("time"),
  });
}

}  // namespace creepcontact::config
