/// [sensitivity]

#include "creepcontact/config/dotted_key.hpp"
#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {

Value<Sensitivity> sensitivity_table() {
  const auto keys = table<Sensitivity>({
      field<Sensitivity>("keys", &Sensitivity::keys,
                         list(reference("a key of this configuration, \"contacts[0].gap\"")),
                         "numbers of this configuration, written as for `--set`: derivatives of all probes and event "
                         "times with respect to each"),
      field<Sensitivity>("changes", &Sensitivity::changes, list(number(greater(0))),
                         "a typical change of each, to which its effect is compared")
          .otherwise("their values"),
  });
  return converted<Sensitivity>(keys, [](Sensitivity read, const Item& item, Context& context) {
    if (!read.changes.empty() && read.changes.size() != read.keys.size())
      context.errors.add(item.child("changes").location,
                         fmt::format("{} changes of {} keys", read.changes.size(), read.keys.size()),
                         "one for each key");
    for (std::size_t k = 0; k < read.keys.size(); ++k)
      for (std::size_t other = 0; other < k; ++other)
        if (read.keys[k].given() && parts_of(read.keys[k].name) == parts_of(read.keys[other].name))
          context.errors.add(read.keys[k].location, fmt::format("'{}' is named twice", read.keys[k].name));
    return std::optional(std::move(read));
  });
}

}  // namespace creepcontact::config
