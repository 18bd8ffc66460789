#pragma once
/// Runs of a study as threads of this process.

#include "creepcontact/study/study.hpp"

namespace creepcontact::cli {

/// Runs share the mesh, the factors of equal stiffness, and the passes through them (run::Kept). @param threads  that
/// work at a time
study::RunsTogether runs_together(int threads);

}  // namespace creepcontact::cli
