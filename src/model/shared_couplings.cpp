#include "shared_couplings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "creepcontact/config/configured.hpp"

namespace creepcontact::model {
namespace {

/// No coupling depends on these, but for what of() adds of its own contact.
constexpr std::array without_effect{"materials", "loads", "contacts", "gaskets", "time"};

std::string text_of(const Vector3& v) {
  return fmt::format("{:a} {:a} {:a} ", v.x(), v.y(), v.z());
}

}  // namespace

SharedCouplings::SharedCouplings(const config::Config& config, MeshStore* store) : store_(store) {
  if (store == nullptr) return;
  key_ = MeshStore::key_of(config);
  for (const config::ConfiguredValue& value : config::identifying_values(config))
    if (std::ranges::none_of(without_effect, [&](const char* table) { return value.key.starts_with(table); }))
      key_ += fmt::format("\n{} = {}", value.key, value.text);
}

contact::MortarCoupling SharedCouplings::of(const config::Contact& contact, std::size_t slave,
                                            std::span<const mechanics::RigidMotion> sliding,
                                            const std::function<contact::MortarCoupling()>& make) const {
  if (store_ == nullptr) return make();
  std::string key = fmt::format("{}\n{}\n{}\n{} {} {}", key_, contact.between[0].name, contact.between[1].name, slave,
                                static_cast<int>(contact.type), contact.friction.is_zero());
  for (const mechanics::RigidMotion& motion : sliding)
    key += '\n' + text_of(motion.translation) + text_of(motion.rotation) + text_of(motion.centre);
  return *store_->coupling(key, make);
}

}  // namespace creepcontact::model
