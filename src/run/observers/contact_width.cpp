/// Contacts that few elements resolve at the end.
#include "creepcontact/results/contact_width.hpp"

#include "creepcontact/base/log.hpp"
#include "observers.hpp"

namespace creepcontact::run {
namespace {

class ContactWidth final : public Observer {
 public:
  explicit ContactWidth(const RunContext& context) : context_(context) {}

  void output(StepView& view) override {
    if (!view.is_end) return;
    view.with_snapshot([&](results::Snapshot& snapshot) {
      warnings_ = results::narrow_contacts(context_.assembly(), snapshot.equilibrium(), "at the end");
      return std::vector<double>{};
    });
  }
  void end(End how) override {
    if (how != End::completed) return;
    for (const std::string& warning : warnings_) log::warning("{}", warning);
  }

 private:
  const RunContext& context_;
  std::vector<std::string> warnings_;  // in process 0
};

}  // namespace

std::unique_ptr<Observer> observe_contact_width(const RunContext& context) {
  return std::make_unique<ContactWidth>(context);
}

}  // namespace creepcontact::run
