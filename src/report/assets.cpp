#include "assets.hpp"

// Defined in assets.S.
#define CREEPCONTACT_ASSET(name)                                     \
  extern "C" const char creepcontact_##name##_begin[];               \
  extern "C" const char creepcontact_##name##_end[];                 \
  namespace creepcontact::report {                                   \
  std::string_view name() {                                          \
    return {creepcontact_##name##_begin, creepcontact_##name##_end}; \
  }                                                                  \
  }

CREEPCONTACT_ASSET(viewer_script)
CREEPCONTACT_ASSET(viewer_style)
CREEPCONTACT_ASSET(report_style)
CREEPCONTACT_ASSET(colours)
