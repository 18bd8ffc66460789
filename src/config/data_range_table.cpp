/// [materials.<name>.data_range], an older way to give the ranges of creep laws

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {

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
