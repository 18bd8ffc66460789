#pragma once
/// Couplings of contacts that models on one mesh share.

#include <functional>
#include <span>
#include <string>

#include "creepcontact/config/config.hpp"
#include "creepcontact/contact/geometry/mortar.hpp"
#include "creepcontact/model/mesh_store.hpp"

namespace creepcontact::model {

class SharedCouplings {
 public:
  /// @param store  which has those of other models; null: nothing is shared
  SharedCouplings(const config::Config& config, MeshStore* store);

  /// The coupling of a contact, from the store or made. @param slave  0 or 1: which of its surfaces
  /// @param sliding  relative motions that it leaves free exactly
  contact::MortarCoupling of(const config::Contact& contact, std::size_t slave,
                             std::span<const mechanics::RigidMotion> sliding,
                             const std::function<contact::MortarCoupling()>& make) const;

 private:
  MeshStore* store_;
  std::string key_;  // all that bodies and supports are made of
};

}  // namespace creepcontact::model
