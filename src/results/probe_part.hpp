#pragma once
/// The part of a group or body that a probe looks at: its key `where`.

#include <string>

#include "creepcontact/base/tensor.hpp"
#include "creepcontact/config/config.hpp"

namespace creepcontact::results {

class ProbePart {
 public:
  explicit ProbePart(const config::Probe& probe) : probe_(probe) {}

  bool is_whole() const { return !probe_.where; }
  bool holds(const Vector3& at) const;
  /// @param found  true if anything lies in the part, on any process
  /// @param of  what it is a part of: "surface 'a'" @throws ModelError if the part is empty
  void require(bool found, const std::string& of) const;

 private:
  const config::Probe& probe_;
};

}  // namespace creepcontact::results
