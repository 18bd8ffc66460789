#pragma once
/// Visitors of variants made of functions, one per alternative.

namespace creepcontact {

/// std::visit(Overload{[](const A&) {...}, [](const B&) {...}}, variant): an alternative without a function of its own
/// is an error of the compiler, so no function may be a template.
template <class... Functions>
struct Overload : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overload(Functions...) -> Overload<Functions...>;

}  // namespace creepcontact
